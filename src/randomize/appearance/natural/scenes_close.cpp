#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "randomize/appearance/natural/lens.h"
#include "randomize/appearance/natural/marks.h"
#include "randomize/appearance/natural/planes.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/scenes.h"
#include "randomize/appearance/natural/surfaces.h"
#include "randomize/appearance/natural/things.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// A size from a power law: its density falls off with the third power.
double drawSize(base::RandomSource& random, double least, double most) {
  const double ends = 1.0 - least * least / (most * most);
  return least / std::sqrt(1.0 - ends * random.unit());
}

}  // namespace

/// The ground in front of one's feet.
void drawFloor(Canvas& canvas, base::RandomSource& random) {
  using Make = Surface (*)(base::RandomSource&, int);
  constexpr std::array<Make, 10> kGrounds = {asphalt, asphalt, concrete, tiles, tiles,
                                             grass,   gravel,  wood,     rock,  cloth};
  const auto draw = [&](int bits) {
    const auto i = static_cast<std::size_t>(below(random, static_cast<int>(kGrounds.size())));
    return tileOf(kGrounds[i](random, bits), random);
  };
  const SceneMaterials chosen = drawSceneMaterials(random);
  const Tile ground_tile = draw(8);
  const Tile way_tile = draw(7);
  Ground ground;
  ground.tile = &ground_tile;
  if (chance(random, 0.5)) ground.way = &way_tile;
  ground.horizon = -canvas.rows * random.uniform(0.1, 2.5);
  ground.focal = canvas.cols * random.uniform(0.8, 1.4);
  ground.height = 1.2;
  ground.texel = random.uniform(0.002, 0.005);
  ground.half_width = random.uniform(0.2, 1.0);
  ground.middle = random.uniform(-1.0, 1.0);
  ground.slant = random.uniform(-0.8, 0.8);
  ground.patches = between(random, 10, 50);
  if (chance(random, 0.3)) {
    ground.markings.push_back({random.uniform(-0.5, 0.5), 0.12, 0.0, {225, 230, 230}});
  }
  fillGround(canvas, ground, random);
  const double size = canvas.cols;
  for (int i = between(random, 0, 3); i > 0; --i) {  // shadows of things outside the picture
    Paint shade;
    shade.light = between(random, 110, 190);
    fillShape(canvas, {random.uniform(-0.2, 1.2) * size, random.uniform(0.0, 1.0) * size},
              random.uniform(0.1, 0.6) * size, shade, random);
  }
  for (int i = between(random, 0, 3); i > 0; --i) {  // stains
    Blob stain;
    stain.middle = {random.unit() * size, random.unit() * canvas.rows};
    stain.wide = size * random.uniform(0.03, 0.25);
    stain.high = 0.6 * stain.wide;
    stain.shift = below(random, 512);
    stain.zoom = 128;
    Paint shade;
    shade.light = between(random, 150, 320);
    fillBlob(canvas, stain, shade);
  }
  if (chance(random, 0.3)) soften(canvas, between(random, 1, 3));
  for (int i = between(random, 0, 60); i > 0; --i) {  // litter and leaves
    const Paint paint =
        paintOf(chance(random, 0.6) ? oneOf(chosen.crowns, random) : oneOf(chosen.plain, random),
                random, 1.0);
    fillShape(canvas, {random.unit() * size, random.unit() * canvas.rows},
              drawSize(random, 2.0, 30.0), paint, random);
  }
  for (int i = between(random, 0, 4); i > 0; --i) {
    Standing at;
    at.foot = {random.unit() * size, random.uniform(0.1, 1.2) * canvas.rows};
    at.metre = size * random.uniform(0.1, 0.4);
    addThing(canvas, at, chosen, random);
  }
}

/// Dead leaves model (Lee, Mumford and Huang 2001) with all materials: shapes that occlude one
/// another have the statistics of photographs, in edges as well as surfaces.
void drawClutter(Canvas& canvas, base::RandomSource& random) {
  const SceneMaterials chosen = drawSceneMaterials(random);
  std::vector<const Tile*> materials;
  for (const std::vector<Tile>* tiles : {&chosen.plain, &chosen.crowns, &chosen.printed}) {
    for (const Tile& tile : *tiles) materials.push_back(&tile);
  }
  const double most = canvas.cols * random.uniform(0.2, 0.5);
  const double least = canvas.cols * random.uniform(0.01, 0.024);
  const Tile* first = materials.front();
  fillRectangle(canvas, {0.0, 0.0}, {1.0 * canvas.cols, 1.0 * canvas.rows},
                paintOf(*first, random, 1.0));
  // Covers everything; if that is then blurred, sharp shapes cover about two thirds of it again.
  const double all = 1.0 * canvas.cols * canvas.rows;
  double area = 2.1 * all;
  const double focus = chance(random, 0.5) ? 1.0 * all : -1.0;
  bool is_sharp = focus < 0.0;
  const bool has_shadows = chance(random, 0.7);
  while (area > 0.0) {
    if (!is_sharp && area < focus) {
      soften(canvas, between(random, 2, 6));
      is_sharp = true;
    }
    const double radius = drawSize(random, least, most);
    const Point middle{random.uniform(-0.05, 1.05) * canvas.cols,
                       random.uniform(-0.05, 1.05) * canvas.rows};
    Point turn;
    drawTurn(random, turn.x, turn.y);
    const Tile& tile =
        *materials[static_cast<std::size_t>(below(random, static_cast<int>(materials.size())))];
    const Tile plain(drawAnyColour(random));
    Paint paint =
        paintOf(chance(random, 0.4) ? plain : tile, random, random.uniform(0.5, 2.0), turn);
    paint.light = between(random, 130, 310);
    paint.middle_x = static_cast<int>(middle.x);
    paint.middle_y = static_cast<int>(middle.y);
    const int slope = static_cast<int>(256.0 * 90.0 / radius);
    paint.light_x = between(random, -slope, slope);
    paint.light_y = between(random, -slope, slope);
    if (has_shadows && radius > 20.0) {
      addHaze(canvas, {middle.x + 0.1 * radius, middle.y + 0.1 * radius}, 1.05 * radius,
              1.05 * radius, {12, 12, 12}, 220);
    }
    const double flat = random.uniform(0.3, 1.0);
    const double draw = random.unit();
    if (draw < 0.3) {
      fillEllipse(canvas, middle, radius, flat * radius, paint, turn);
    } else if (draw < 0.65) {
      const Point along{radius * turn.x, radius * turn.y};
      paint.round = chance(random, 0.3) ? 160 : 0;
      fillLine(canvas, {middle.x - along.x, middle.y - along.y},
               {middle.x + along.x, middle.y + along.y}, 1.4 * flat * radius, 1.4 * flat * radius,
               paint);
    } else if (draw < 0.85) {
      fillShape(canvas, middle, 1.1 * radius, paint, random);
    } else {
      Blob blob;
      blob.middle = middle;
      blob.wide = 0.8 * radius;
      blob.high = 0.8 * flat * radius;
      blob.zoom = static_cast<int>(std::clamp(256.0 * 50.0 / radius, 64.0, 1500.0));
      blob.shift = below(random, 512);
      blob.clumps = 100;
      fillBlob(canvas, blob, paint);
    }
    area -= 2.2 * radius * radius * flat;
  }
}

}  // namespace synthetic_dataset::randomize::natural
