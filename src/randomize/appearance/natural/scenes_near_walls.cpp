#include <algorithm>
#include <array>
#include <vector>

#include "randomize/appearance/natural/lens.h"
#include "randomize/appearance/natural/planes.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/scenes.h"
#include "randomize/appearance/natural/surfaces.h"
#include "randomize/appearance/natural/things.h"

namespace synthetic_dataset::randomize::natural {
namespace {

using MakeSurface = Surface (*)(base::RandomSource&, int);

Tile drawnOf(const std::vector<MakeSurface>& makers, int bits, base::RandomSource& random) {
  const MakeSurface make =
      makers[static_cast<std::size_t>(below(random, static_cast<int>(makers.size())))];
  return tileOf(make(random, bits), random);
}

/// A rectangle with a border: a window, a door, a picture on the wall, a poster.
void addFramed(Canvas& canvas, const Point& low, const Point& high, double rim, const Paint& frame,
               const Paint& inside) {
  addHaze(canvas, {0.5 * (low.x + high.x) + 3.0, high.y}, 0.6 * (high.x - low.x), 14.0,
          {15, 14, 13}, 90);
  fillRectangle(canvas, low, high, frame);
  fillRectangle(canvas, {low.x + rim, low.y + rim}, {high.x - rim, high.y - rim}, inside);
}

void addWindow(Canvas& canvas, const Point& low, const Point& high, base::RandomSource& random) {
  const Tile frame(drawColour(random, chance(random, 0.6) ? Hues::kCream : Hues::kDark));
  const bool is_bright = chance(random, 0.5);
  const Tile glass(is_bright ? mixed(drawColour(random, Hues::kSky), {250, 248, 245}, 150)
                             : mixed(drawColour(random, Hues::kDark), {120, 100, 80}, 60));
  Paint bars;
  bars.tile = &frame;
  Paint pane;
  pane.tile = &glass;
  pane.middle_x = static_cast<int>(low.x);
  pane.middle_y = static_cast<int>(low.y);
  pane.light_y = between(random, -120, 60);
  pane.light_x = between(random, -60, 60);
  const double rim = std::max(2.0, 0.03 * (high.x - low.x));
  addFramed(canvas, low, high, rim, bars, pane);
  const int columns = between(random, 1, 3);
  const int rows = between(random, 1, 3);
  for (int i = 1; i < columns; ++i) {
    const double x = low.x + (high.x - low.x) * i / columns;
    fillRectangle(canvas, {x - 0.4 * rim, low.y}, {x + 0.4 * rim, high.y}, bars);
  }
  for (int i = 1; i < rows; ++i) {
    const double y = low.y + (high.y - low.y) * i / rows;
    fillRectangle(canvas, {low.x, y - 0.4 * rim}, {high.x, y + 0.4 * rim}, bars);
  }
}

/// Adds windows, posters and boards to a wall between two rows.
void addToWall(Canvas& canvas, double top, double bottom, const SceneMaterials& chosen,
               base::RandomSource& random) {
  for (int i = between(random, 0, 6); i > 0; --i) {
    const double wide = canvas.cols * random.uniform(0.06, 0.28);
    const double high = (bottom - top) * random.uniform(0.15, 0.6);
    const Point low{random.uniform(-0.05, 0.95) * canvas.cols,
                    top + (bottom - top - high) * random.unit()};
    const Point end{low.x + wide, low.y + high};
    if (chance(random, 0.4)) {
      addWindow(canvas, low, end, random);
      continue;
    }
    const Paint frame = paintOf(oneOf(chosen.plain, random), random, 1.0);
    const bool is_printed = chance(random, 0.7);
    const Paint inside = paintOf(is_printed ? chosen.printed.front() : oneOf(chosen.plain, random),
                                 random, std::clamp(100.0 / wide, 0.4, 2.5));
    addFramed(canvas, low, end, chance(random, 0.5) ? 0.0 : random.uniform(2.0, 8.0), frame,
              inside);
  }
}

/// Adds standing things; those lower in the picture are nearer.
void addRow(Canvas& canvas, double top, const SceneMaterials& chosen, int count, double metre,
            base::RandomSource& random) {
  std::vector<double> feet;
  for (int i = 0; i < count; ++i) feet.push_back(random.uniform(top, 1.05 * canvas.rows));
  std::sort(feet.begin(), feet.end());
  for (const double foot : feet) {
    Standing at;
    at.foot = {random.uniform(0.0, 1.0) * canvas.cols, foot};
    at.metre = metre * (1.0 + (foot - top) / canvas.rows);
    at.sun = chance(random, 0.5) ? 1 : -1;
    addThing(canvas, at, chosen, random);
  }
}

/// A cupboard or a table: a front with doors, and a top.
void addCupboard(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
                 base::RandomSource& random) {
  const double wide = at.metre * random.uniform(0.3, 1.1);
  const double high = at.metre * random.uniform(0.5, 2.0);
  const Point& foot = at.foot;
  addShadow(canvas, at, 1.2 * wide);
  Paint paint = paintOf(oneOf(chosen.plain, random), random, std::clamp(50.0 / wide, 0.4, 3.0));
  paint.light = between(random, 180, 270);
  if (chance(random, 0.35)) {  // a table
    const double leg = std::max(2.0, 0.05 * at.metre);
    for (const double x : {-0.9 * wide, 0.9 * wide}) {
      fillLine(canvas, {foot.x + x, foot.y}, {foot.x + x, foot.y - 0.75 * at.metre}, leg, leg,
               paint);
    }
    paint.light += 30;
    fillRectangle(canvas, {foot.x - wide, foot.y - 0.8 * at.metre},
                  {foot.x + wide, foot.y - 0.72 * at.metre}, paint);
    Standing on = at;
    on.foot = {foot.x + random.uniform(-0.6, 0.6) * wide, foot.y - 0.8 * at.metre};
    on.metre = 0.3 * at.metre;
    addThing(canvas, on, chosen, random);
    return;
  }
  fillRectangle(canvas, {foot.x - wide, foot.y - high}, {foot.x + wide, foot.y}, paint);
  Paint edge = paint;
  edge.light = 90;
  const int columns = between(random, 1, 3);
  const int rows = between(random, 1, 4);
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      const double gap = std::max(1.0, 0.015 * at.metre);
      const Point low{foot.x - wide + 2.0 * wide * column / columns + gap,
                      foot.y - high + high * row / rows + gap};
      const Point end{low.x + 2.0 * wide / columns - 2.0 * gap, low.y + high / rows - 2.0 * gap};
      fillRectangle(canvas, {low.x - gap, low.y - gap}, {end.x + gap, end.y + gap}, edge);
      fillRectangle(canvas, low, end, paint);
      fillEllipse(canvas, {end.x - 4.0 * gap, 0.5 * (low.y + end.y)}, 1.6 * gap, 1.6 * gap, edge);
    }
  }
}

}  // namespace

void drawWallFront(Canvas& canvas, base::RandomSource& random) {
  const SceneMaterials chosen = drawSceneMaterials(random);
  const Tile wall = drawnOf({brick, brick, plaster, concrete, metal, wood, tiles, rock}, 8, random);
  const Tile floor = drawnOf({asphalt, concrete, tiles, grass, gravel}, 8, random);
  const double foot = canvas.rows * random.uniform(0.5, 1.1);
  Paint paint = paintOf(wall, random, random.uniform(0.7, 1.6));
  paint.u_y = 0;  // upright
  paint.light = between(random, 200, 280);
  paint.light_x = between(random, -60, 60);
  paint.middle_x = canvas.cols / 2;
  fillRectangle(canvas, {0.0, 0.0}, {1.0 * canvas.cols, 1.0 * canvas.rows}, paint);
  if (chance(random, 0.4)) {  // a lower part made of another material
    Paint base = paintOf(oneOf(chosen.plain, random), random, 1.0);
    fillRectangle(canvas, {0.0, foot - canvas.rows * random.uniform(0.04, 0.25)},
                  {1.0 * canvas.cols, foot}, base);
  }
  addToWall(canvas, -0.1 * canvas.rows, 0.95 * foot, chosen, random);
  Ground ground;
  ground.tile = &floor;
  ground.height = 1.5;
  ground.focal = 1.0 * canvas.cols;
  ground.horizon = foot - random.uniform(0.25, 0.6) * canvas.rows;
  ground.first = static_cast<int>(foot);
  fillGround(canvas, ground, random);
  addHaze(canvas, {0.5 * canvas.cols, foot}, 0.9 * canvas.cols, 16.0, {15, 15, 15}, 130);
  if (chance(random, 0.35)) soften(canvas, between(random, 1, 4));
  addRow(canvas, foot, chosen, between(random, 0, 9), canvas.rows * random.uniform(0.2, 0.6),
         random);
  if (chance(random, 0.4)) {
    Standing at;
    at.foot = {random.uniform(0.1, 0.9) * canvas.cols, foot + 4.0};
    at.metre = canvas.rows * random.uniform(0.15, 0.4);
    addBush(canvas, at, chosen, random);
  }
}

void drawRoom(Canvas& canvas, base::RandomSource& random) {
  const SceneMaterials chosen = drawSceneMaterials(random, Whereabouts::kIndoors);
  const Tile wall = drawnOf({plaster, plaster, plaster, plaster, brick, wood, concrete}, 7, random);
  const Tile floor = drawnOf({wood, wood, tiles, cloth, concrete, plaster}, 8, random);
  const Colour ceiling = drawColour(random, Hues::kCream);
  const double w = canvas.cols;
  const double h = canvas.rows;
  // The far wall, and the vanishing point of all edges along the room.
  const double left = w * random.uniform(-0.2, 0.35);
  const double right = w * random.uniform(0.6, 1.2);
  const double top = h * random.uniform(-0.2, 0.2);
  const double foot = h * random.uniform(0.5, 0.75);
  const Point eye{left + (right - left) * random.uniform(0.3, 0.7), top + 0.5 * (foot - top)};
  const Tile above(ceiling);
  Paint paint;
  paint.tile = &above;
  fillRectangle(canvas, {0.0, 0.0}, {w, h}, paint);
  Ground ground;
  ground.tile = &floor;
  ground.horizon = eye.y;
  ground.first = static_cast<int>(foot);
  ground.focal = 0.9 * w;
  ground.height = 1.4;
  ground.texel = random.uniform(0.006, 0.014);
  ground.patches = between(random, 0, 20);
  fillGround(canvas, ground, random);
  // A side wall continues the far wall's edges out of the picture.
  const auto outward = [&](double edge, double row, double x) {
    return eye.y + (row - eye.y) * (x - eye.x) / (edge - eye.x);
  };
  Wall side;
  side.repeats = 2.0;
  side.repeats_along = 2.0;
  side.light = between(random, 170, 240);
  if (left > 0.0) {
    side.left = -1.0;
    side.right = left;
    side.top_left = outward(left, top, -1.0);
    side.top_right = top;
    side.bottom_left = outward(left, foot, -1.0);
    side.bottom_right = foot;
    fillWall(canvas, side, wall);
  }
  if (right < w) {
    side.left = right;
    side.right = w + 1.0;
    side.top_left = top;
    side.top_right = outward(right, top, w + 1.0);
    side.bottom_left = foot;
    side.bottom_right = outward(right, foot, w + 1.0);
    side.light = between(random, 190, 280);
    fillWall(canvas, side, wall);
  }
  paint = paintOf(wall, random, 1.0);
  paint.light = between(random, 220, 280);
  paint.light_x = between(random, -50, 50);
  paint.middle_x = canvas.cols / 2;
  fillRectangle(canvas, {left, top}, {right, foot}, paint);
  addToWall(canvas, std::max(0.0, top), foot - 0.15 * h, chosen, random);
  const Tile skirting(drawColour(random, chance(random, 0.5) ? Hues::kCream : Hues::kEarth));
  Paint board;
  board.tile = &skirting;
  fillRectangle(canvas, {left, foot - 0.02 * h}, {right, foot + 1.0}, board);
  addHaze(canvas, {0.5 * (left + right), foot}, 0.7 * (right - left), 14.0, {15, 15, 15}, 110);
  if (chance(random, 0.6)) {  // light from a window or a lamp
    addHaze(canvas, {random.uniform(0.0, 1.0) * w, random.uniform(0.0, 0.7) * h}, 0.5 * w, 0.5 * h,
            {220, 240, 250}, between(random, 20, 90));
  }
  const double metre = (foot - top) / random.uniform(2.0, 3.0);
  std::vector<double> feet;
  for (int i = between(random, 2, 6); i > 0; --i) feet.push_back(random.uniform(foot, 0.95 * h));
  std::sort(feet.begin(), feet.end());
  for (const double row : feet) {
    Standing at;
    at.foot = {random.uniform(0.0, 1.0) * w, row};
    at.metre = metre * (row - eye.y) / (foot - eye.y);
    addCupboard(canvas, at, chosen, random);
  }
  if (chance(random, 0.4)) soften(canvas, between(random, 1, 4));
  addRow(canvas, foot, chosen, between(random, 1, 8), 0.6 * metre, random);
}

void drawShelf(Canvas& canvas, base::RandomSource& random) {
  const SceneMaterials chosen = drawSceneMaterials(random, Whereabouts::kIndoors);
  Paint back = paintOf(oneOf(chosen.plain, random), random, 1.0);
  back.light = between(random, 60, 160);
  fillRectangle(canvas, {0.0, 0.0}, {1.0 * canvas.cols, 1.0 * canvas.rows}, back);
  const Tile board = tileOf(chance(random, 0.6) ? wood(random, 7) : metal(random, 7), random);
  const int rows = between(random, 2, 5);
  const double high = 1.0 * canvas.rows / rows;
  for (int row = 0; row <= rows; ++row) {
    const double foot = high * (row + random.uniform(0.3, 0.5));
    double x = -random.uniform(0.0, 30.0);
    while (x < canvas.cols) {
      const double wide = random.uniform(0.06, chance(random, 0.4) ? 0.6 : 0.25) * high;
      const double tall = high * random.uniform(0.4, 0.85);
      const Tile colour(drawAnyColour(random));
      const double draw = random.unit();
      const bool is_printed = draw > 0.8;
      Paint paint;
      paint.tile = &colour;
      if (draw < 0.3) paint = paintOf(oneOf(chosen.plain, random), random, 1.0);
      if (is_printed) paint = paintOf(chosen.printed.front(), random, random.uniform(0.8, 2.0));
      paint.light = between(random, 170, 290);
      paint.round = chance(random, 0.4) ? between(random, 60, 220) : 40;
      fillRectangle(canvas, {x, foot - tall}, {x + wide, foot}, paint);
      if (!is_printed && chance(random, 0.6)) {  // a label
        Paint label = paintOf(chosen.printed.front(), random, 1.5);
        label.light = paint.light;
        label.round = paint.round;
        const double from = foot - tall * random.uniform(0.5, 0.9);
        fillRectangle(canvas, {x + 0.08 * wide, from}, {x + 0.92 * wide, from + 0.3 * tall}, label);
      }
      if (chance(random, 0.2))
        fillEllipse(canvas, {x + 0.5 * wide, foot - tall}, 0.5 * wide, 0.12 * wide, paint);
      x += wide + (chance(random, 0.2) ? random.uniform(2.0, 0.5 * high) : 1.0);
    }
    Paint plank = paintOf(board, random, 1.0);
    fillRectangle(canvas, {0.0, foot}, {1.0 * canvas.cols, foot + 0.07 * high}, plank);
    addHaze(canvas, {0.5 * canvas.cols, foot + 0.12 * high}, 1.2 * canvas.cols, 0.1 * high,
            {10, 10, 10}, 170);
  }
  if (chance(random, 0.4)) soften(canvas, between(random, 1, 5));
  if (chance(random, 0.4)) {
    addRow(canvas, 0.9 * canvas.rows, chosen, between(random, 1, 3), 0.7 * canvas.rows, random);
  }
}

}  // namespace synthetic_dataset::randomize::natural
