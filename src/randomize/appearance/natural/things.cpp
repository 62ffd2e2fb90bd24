#include "randomize/appearance/natural/things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "randomize/appearance/natural/marks.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/surfaces.h"

namespace synthetic_dataset::randomize::natural {

Point drawnTurn(base::RandomSource& random) {
  Point turn;
  drawTurn(random, turn.x, turn.y);
  return turn;
}

Paint standingPaint(const Tile& tile, base::RandomSource& random, double scale,
                    const Standing& at) {
  Paint paint = paintOf(tile, random, scale);
  paint.haze = at.haze;
  paint.haze_share = at.haze_share;
  paint.middle_x = static_cast<int>(at.foot.x);
  paint.middle_y = static_cast<int>(at.foot.y);
  return paint;
}

Paint colourPaint(const Tile& colour, const Standing& at) {
  Paint paint;
  paint.tile = &colour;
  paint.haze = at.haze;
  paint.haze_share = at.haze_share;
  return paint;
}

const Tile& oneOf(const std::vector<Tile>& tiles, base::RandomSource& random) {
  return tiles[static_cast<std::size_t>(below(random, static_cast<int>(tiles.size())))];
}

SceneMaterials drawSceneMaterials(base::RandomSource& random, Whereabouts where) {
  using Make = Surface (*)(base::RandomSource&, int);
  constexpr std::array<Make, 12> kAny = {brick, tiles, concrete, plaster, plaster, metal,
                                         metal, wood,  cloth,    cloth,   rock,    leaves};
  constexpr std::array<Make, 12> kHousehold = {plaster, plaster, plaster, plaster, metal, wood,
                                               wood,    wood,    cloth,   cloth,   tiles, concrete};
  const std::array<Make, 12>& makers = where == Whereabouts::kIndoors ? kHousehold : kAny;
  SceneMaterials chosen;
  for (int i = 0; i < 2; ++i) chosen.crowns.push_back(tileOf(foliage(random, 6), random));
  chosen.trunks.push_back(tileOf(bark(random, 6), random));
  for (int i = 0; i < 5; ++i) {
    const Make make =
        makers[static_cast<std::size_t>(below(random, static_cast<int>(makers.size())))];
    chosen.plain.push_back(tileOf(make(random, 6), random));
  }
  chosen.printed.push_back(tileOf(print(random, 7), random));
  return chosen;
}

void addShadow(Canvas& canvas, const Standing& at, double wide) {
  addHaze(canvas, {at.foot.x - 0.3 * at.sun * wide, at.foot.y}, 1.2 * wide,
          std::max(1.5, 0.22 * wide), {18, 16, 15}, 190 * (256 - at.haze_share) / 256);
}

void addThing(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
              base::RandomSource& random) {
  const double wide = at.metre * random.uniform(0.15, 0.7);
  const double high = at.metre * random.uniform(0.3, 1.5);
  const Tile& tile =
      chance(random, 0.25) ? oneOf(chosen.printed, random) : oneOf(chosen.plain, random);
  Paint paint = standingPaint(tile, random, std::clamp(30.0 / wide, 0.4, 6.0), at);
  addShadow(canvas, at, 1.2 * wide);
  const double draw = random.unit();
  if (draw < 0.5) {  // a box
    const double deep = wide * random.uniform(0.2, 0.9);
    const double up = deep * random.uniform(0.1, 0.5);
    const double side = at.sun * deep;
    const double left = at.foot.x - wide;
    const double right = at.foot.x + wide;
    const double corner = at.sun > 0 ? right : left;
    paint.light = between(random, 170, 250);
    fillRectangle(canvas, {left, at.foot.y - high}, {right, at.foot.y}, paint);
    paint.light = between(random, 110, 330);
    fillPolygon(canvas,
                {{corner, at.foot.y},
                 {corner + side, at.foot.y - up},
                 {corner + side, at.foot.y - high - up},
                 {corner, at.foot.y - high}},
                paint);
    paint.light = between(random, 250, 350);
    fillPolygon(canvas,
                {{left, at.foot.y - high},
                 {right, at.foot.y - high},
                 {right + side, at.foot.y - high - up},
                 {left + side, at.foot.y - high - up}},
                paint);
  } else if (draw < 0.75) {  // a barrel
    paint.round = between(random, 120, 230);
    fillEllipse(canvas, {at.foot.x, at.foot.y}, wide, 0.2 * wide, paint);
    fillRectangle(canvas, {at.foot.x - wide, at.foot.y - high}, {at.foot.x + wide, at.foot.y},
                  paint);
    paint.round = 0;
    paint.light = between(random, 180, 330);
    fillEllipse(canvas, {at.foot.x, at.foot.y - high}, wide, 0.2 * wide, paint);
  } else {
    paint.round = between(random, 60, 200);
    paint.middle_y = static_cast<int>(at.foot.y - 0.5 * high);
    paint.light_y = -static_cast<int>(256.0 * 100.0 / std::max(4.0, high));
    if (chance(random, 0.5)) {
      fillEllipse(canvas, {at.foot.x, at.foot.y - 0.9 * wide}, wide, wide, paint);
    } else {
      fillShape(canvas, {at.foot.x, at.foot.y - 0.7 * wide}, wide, paint, random);
    }
  }
}

void fillShape(Canvas& canvas, const Point& middle, double radius, const Paint& paint,
               base::RandomSource& random) {
  const int corners = between(random, 3, 9);
  std::vector<Point> points;
  Point turn = drawnTurn(random);
  // The corners of a regular polygon, each moved in or out. Each direction is the previous one
  // turned by a constant angle, whose cosine and sine are tabulated.
  constexpr std::array<Point, 7> kSteps = {{{-0.5, 0.8660254},
                                            {0.0, 1.0},
                                            {0.3090170, 0.9510565},
                                            {0.5, 0.8660254},
                                            {0.6234898, 0.7818315},
                                            {0.7071068, 0.7071068},
                                            {0.7660444, 0.6427876}}};
  const Point& step = kSteps[static_cast<std::size_t>(corners - 3)];
  const double flat = random.uniform(0.4, 1.0);
  for (int i = 0; i < corners; ++i) {
    const double out = radius * random.uniform(0.55, 1.0);
    points.push_back({middle.x + out * turn.x, middle.y + flat * out * turn.y});
    turn = {turn.x * step.x - turn.y * step.y, turn.x * step.y + turn.y * step.x};
  }
  fillPolygon(canvas, points, paint);
}

}  // namespace synthetic_dataset::randomize::natural
