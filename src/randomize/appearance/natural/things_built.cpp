#include "randomize/appearance/natural/things.h"

#include <algorithm>
#include <array>
#include <vector>

#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/surfaces.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// Common to all windows of a facade.
struct Windows {
  Tile frame;
  Tile ledge;
  Colour glass;
  bool has_bars;
};

/// Draws a window between two opposite corners.
void addWindow(Canvas& canvas, const Windows& all, const Point& from, const Point& to,
               bool has_ledge, base::RandomSource& random) {
  Paint plain;
  plain.tile = &all.frame;
  fillRectangle(canvas, from, to, plain);
  const Tile pane(
      lit(chance(random, 0.15) ? Colour{130, 190, 220} : all.glass, between(random, 150, 420)));
  Paint shine;
  shine.tile = &pane;
  shine.middle_y = static_cast<int>(from.y);
  shine.light_y = -static_cast<int>(256.0 * between(random, -60, 160) / (to.y - from.y));
  fillRectangle(canvas, {from.x + 1.5, from.y + 1.5}, {to.x - 1.5, to.y - 1.5}, shine);
  if (chance(random, 0.25)) {  // a blind
    plain.tile = &all.ledge;
    const double down = from.y + (to.y - from.y) * random.uniform(0.2, 0.8);
    fillRectangle(canvas, {from.x + 2.0, from.y + 2.0}, {to.x - 2.0, down}, plain);
  }
  plain.tile = &all.frame;
  if (all.has_bars) {
    const double middle = 0.5 * (from.x + to.x);
    fillRectangle(canvas, {middle - 0.7, from.y}, {middle + 0.7, to.y}, plain);
  }
  plain.tile = &all.ledge;
  if (has_ledge) fillRectangle(canvas, {from.x - 2.0, to.y}, {to.x + 2.0, to.y + 2.5}, plain);
}

}  // namespace

Tile drawFacade(base::RandomSource& random) {
  constexpr int kBits = 8;
  constexpr double kSide = 1 << kBits;
  using Make = Surface (*)(base::RandomSource&, int);
  constexpr std::array<Make, 6> kWalls = {brick, brick, plaster, plaster, concrete, tiles};
  const Tile wall = tileOf(
      kWalls[static_cast<std::size_t>(below(random, static_cast<int>(kWalls.size())))](random, 6),
      random);
  Canvas canvas(1 << kBits, 1 << kBits);
  fillRectangle(canvas, {0.0, 0.0}, {kSide, kSide}, paintOf(wall, random, 1.0));
  const int floors = between(random, 2, 5);
  const int columns = between(random, 2, 6);
  const double high = kSide / floors;
  const double wide = kSide / columns;
  const double part_x = random.uniform(0.3, 0.75);
  const double part_y = random.uniform(0.4, 0.75);
  Windows windows{Tile(drawColour(random, chance(random, 0.6) ? Hues::kCream : Hues::kDark)),
                  Tile(drawColour(random, chance(random, 0.5) ? Hues::kCream : Hues::kGrey)),
                  mixed(drawColour(random, Hues::kDark), drawColour(random, Hues::kSky), 70),
                  false};
  const Tile band(drawColour(random, chance(random, 0.4) ? Hues::kVivid : Hues::kEarth));
  const bool has_shops = chance(random, 0.4);
  windows.has_bars = chance(random, 0.7);
  Paint plain;
  for (int floor = 0; floor < floors; ++floor) {
    const bool is_shop = has_shops && floor == floors - 1;
    const double top = high * floor;
    if (is_shop) {
      plain.tile = &band;
      fillRectangle(canvas, {0.0, top + 0.08 * high}, {kSide, top + 0.3 * high}, plain);
    } else if (chance(random, 0.5)) {
      plain.tile = &windows.ledge;
      fillRectangle(canvas, {0.0, top}, {kSide, top + 3.0}, plain);
    }
    for (int column = 0; column < columns; ++column) {
      const double share_x = is_shop ? 0.85 : part_x;
      const double share_y = is_shop ? 0.62 : part_y;
      const double left = wide * (column + 0.5 - 0.5 * share_x);
      const double low = is_shop ? top + 0.34 * high : top + high * (0.5 - 0.5 * share_y);
      const double right = left + wide * share_x;
      const double bottom = low + high * share_y;
      addWindow(canvas, windows, {left, low}, {right, bottom}, !is_shop, random);
    }
  }
  return {kBits, std::vector<cv::Vec4b>(canvas[0], canvas[0] + canvas.total())};
}

void addPole(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
             base::RandomSource& random) {
  const double height = at.metre * random.uniform(2.2, 7.0);
  const double width = std::max(1.0, at.metre * random.uniform(0.05, 0.16));
  const Tile colour(drawColour(random, chance(random, 0.6) ? Hues::kGrey : Hues::kDark));
  Paint paint = colourPaint(colour, at);
  paint.round = 120;
  const Point top{at.foot.x + random.uniform(-0.02, 0.02) * height, at.foot.y - height};
  addShadow(canvas, at, 2.0 * width);
  fillLine(canvas, at.foot, top, width, 0.7 * width, paint);
  const double draw = random.unit();
  if (draw < 0.3) {  // a lamp
    const double arm = at.metre * random.uniform(0.5, 1.5) * (chance(random, 0.5) ? 1.0 : -1.0);
    fillLine(canvas, top, {top.x + arm, top.y - 0.1 * at.metre}, 0.6 * width, 0.5 * width, paint);
    fillEllipse(canvas, {top.x + arm, top.y}, 0.3 * at.metre, 0.1 * at.metre, paint);
    return;
  }
  if (draw > 0.75) return;
  const double size = at.metre * random.uniform(0.25, 0.6);
  const Point middle{top.x, top.y + size};
  const Tile rim(chance(random, 0.6) ? drawColour(random, Hues::kVivid)
                                     : drawColour(random, Hues::kCream));
  Paint edge = colourPaint(rim, at);
  Paint face =
      standingPaint(oneOf(chosen.printed, random), random, std::clamp(40.0 / size, 0.5, 8.0), at);
  const double kind = random.unit();
  if (kind < 0.35) {
    fillEllipse(canvas, middle, size, size, edge);
    fillEllipse(canvas, middle, 0.75 * size, 0.75 * size, face);
  } else if (kind < 0.6) {
    const auto triangle = [&](double r) {
      return std::vector<Point>{{middle.x, middle.y - r},
                                {middle.x + 0.87 * r, middle.y + 0.5 * r},
                                {middle.x - 0.87 * r, middle.y + 0.5 * r}};
    };
    fillPolygon(canvas, triangle(1.2 * size), edge);
    fillPolygon(canvas, triangle(0.75 * size), face);
  } else {
    const double wide = size * random.uniform(0.8, 2.2);
    fillRectangle(canvas, {middle.x - wide, middle.y - size}, {middle.x + wide, middle.y + size},
                  edge);
    fillRectangle(canvas, {middle.x - 0.92 * wide, middle.y - 0.88 * size},
                  {middle.x + 0.92 * wide, middle.y + 0.88 * size}, face);
  }
}

void addCar(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
            base::RandomSource& random) {
  const double m = at.metre;
  const double half = m * random.uniform(0.85, 2.2);  // seen from behind or from the side
  const bool is_side = half > 1.4 * m;
  const double height = m * random.uniform(1.35, is_side ? 1.7 : 2.3);
  const double belt = height * random.uniform(0.5, 0.62);
  const Colour paint_colour = drawAnyColour(random);
  const Tile body(paint_colour);
  const Tile dark(Colour{28, 26, 25});
  const Tile glass(mixed({60, 55, 50}, at.haze, 60));
  const Point& foot = at.foot;
  addShadow(canvas, at, 1.15 * half);
  Paint paint = colourPaint(body, at);
  paint.middle_y = static_cast<int>(foot.y - 0.5 * height);
  paint.light_y = -static_cast<int>(256.0 * 130.0 / height);
  const Paint black = colourPaint(dark, at);
  const double roof = is_side ? 0.55 : 0.8;
  const double shift = is_side ? random.uniform(-0.15, 0.15) * half : 0.0;
  const auto cabin = [&](double inset) {
    const double top = foot.y - height + 1.6 * inset;
    return std::vector<Point>{{foot.x + shift - roof * half + inset, top},
                              {foot.x + shift + roof * half - inset, top},
                              {foot.x + shift + 0.93 * half - 1.6 * inset, foot.y - belt},
                              {foot.x + shift - 0.93 * half + 1.6 * inset, foot.y - belt}};
  };
  const double wheel = 0.32 * m;
  const double out = is_side ? 0.62 * half : 0.8 * half;
  for (const double side : {-1.0, 1.0}) {
    const Point axle{foot.x + side * out, foot.y - 0.8 * wheel};
    fillEllipse(canvas, axle, is_side ? wheel : 0.4 * wheel, wheel, black);
  }
  fillPolygon(canvas, cabin(0.0), paint);
  Paint window = colourPaint(glass, at);
  window.middle_y = static_cast<int>(foot.y - height);
  window.light_x = between(random, -60, 60);
  fillPolygon(canvas, cabin(0.09 * m), window);
  const double low = foot.y - 0.22 * m;
  fillPolygon(canvas,
              {{foot.x - 0.97 * half, foot.y - belt},
               {foot.x + 0.97 * half, foot.y - belt},
               {foot.x + half, foot.y - 0.8 * belt},
               {foot.x + half, low},
               {foot.x - half, low},
               {foot.x - half, foot.y - 0.8 * belt}},
              paint);
  if (is_side) {
    for (const double side : {-1.0, 1.0}) {
      const Point axle{foot.x + side * out, foot.y - wheel};
      fillEllipse(canvas, axle, wheel, wheel, black);
      fillEllipse(canvas, axle, 0.55 * wheel, 0.55 * wheel, paint);
    }
    return;
  }
  const Tile lamp(chance(random, 0.5) ? Colour{40, 40, 190} : Colour{225, 235, 235});
  const Paint light = colourPaint(lamp, at);
  for (const double side : {-1.0, 1.0}) {
    fillEllipse(canvas, {foot.x + side * 0.75 * half, foot.y - 0.75 * belt}, 0.16 * m, 0.1 * m,
                light);
  }
  Paint plate = standingPaint(oneOf(chosen.printed, random), random, 3.0, at);
  fillRectangle(canvas, {foot.x - 0.26 * m, foot.y - 0.55 * belt},
                {foot.x + 0.26 * m, foot.y - 0.4 * belt}, plate);
}

void addFence(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
              base::RandomSource& random) {
  const double m = at.metre;
  const double height = m * random.uniform(0.6, 1.8);
  const double step =
      m * (chance(random, 0.5) ? random.uniform(0.1, 0.3) : random.uniform(1.0, 2.5));
  const double width = std::max(1.0, std::min(0.6 * step, m * random.uniform(0.03, 0.14)));
  Paint paint =
      standingPaint(oneOf(chosen.plain, random), random, std::clamp(20.0 / m, 0.5, 4.0), at);
  const double right = at.foot.x + m * random.uniform(3.0, 14.0);
  for (int i = between(random, 1, 3); i > 0; --i) {
    const double y = at.foot.y - height * i / 3.3;
    fillRectangle(canvas, {at.foot.x, y - 0.5 * width}, {right, y + 0.5 * width}, paint);
  }
  paint.light = 215;
  for (double x = at.foot.x; x < right; x += step) {
    if (x < -width || x > canvas.cols + width) continue;
    fillRectangle(canvas, {x - 0.5 * width, at.foot.y - height}, {x + 0.5 * width, at.foot.y},
                  paint);
  }
}

}  // namespace synthetic_dataset::randomize::natural
