#include "randomize/appearance/natural/things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "randomize/appearance/natural/marks.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/surfaces.h"

namespace synthetic_dataset::randomize::natural {
namespace {

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

/// A branch and those that grow from it.
void addBranches(Canvas& canvas, const Point& from, const Point& way, double width, int depth,
                 const Paint& paint, base::RandomSource& random) {
  const Point to{from.x + way.x, from.y + way.y};
  fillLine(canvas, from, to, width, 0.7 * width, paint);
  if (depth == 0) return;
  const int count = between(random, 2, 3);
  for (int i = 0; i < count; ++i) {
    const double bend = random.uniform(-0.9, 0.9);
    const double length = random.uniform(0.55, 0.85);
    const Point next{length * (way.x - bend * way.y), length * (way.y + bend * way.x)};
    addBranches(canvas, to, next, 0.65 * width, depth - 1, paint, random);
  }
}

void addConifer(Canvas& canvas, const Standing& at, double height, const Stuffs& stuffs,
                base::RandomSource& random) {
  const Tile& needles = oneOf(stuffs.crowns, random);
  const double wide = height * random.uniform(0.16, 0.28);
  for (int i = 0; i < 7; ++i) {
    const double share = i / 7.0;
    Blob blob;
    blob.wide = wide * (1.05 - share);
    blob.high = height * 0.12;
    blob.middle = {at.foot.x, at.foot.y - height * (0.12 + 0.85 * share)};
    blob.ragged = 130;
    blob.zoom = static_cast<int>(std::clamp(256.0 * 100.0 / height, 120.0, 1500.0));
    blob.shift = below(random, 512);
    blob.clumps = 120;
    Paint paint = standingPaint(needles, random, std::clamp(60.0 / height, 0.7, 4.0), at);
    paint.light = 150 + 12 * i;
    paint.light_x = static_cast<int>(at.sun * 256.0 * 60.0 / std::max(4.0, wide));
    fillBlob(canvas, blob, paint);
  }
}

void addCrown(Canvas& canvas, const Standing& at, double height, const Stuffs& stuffs,
              base::RandomSource& random) {
  const Tile& leaves = oneOf(stuffs.crowns, random);
  const double wide = height * random.uniform(0.22, 0.45);
  const double high = height * random.uniform(0.25, 0.36);
  const double middle_y = at.foot.y - height + high;
  const int count = between(random, 5, 9);
  const int zoom =
      static_cast<int>(std::clamp(256.0 * 90.0 / std::max(10.0, height), 90.0, 1024.0));
  for (int i = 0; i < count; ++i) {
    const Point turn = drawnTurn(random);
    const double out = i == 0 ? 0.0 : random.uniform(0.3, 0.75);
    Blob blob;
    blob.middle = {at.foot.x + out * turn.x * wide, middle_y + out * turn.y * high};
    const double size = i == 0 ? 0.8 : random.uniform(0.3, 0.55);
    blob.wide = size * wide;
    blob.high = size * high;
    blob.ragged = 150;
    blob.zoom = zoom;
    blob.shift = below(random, 512);
    blob.clumps = 200;
    Paint paint = standingPaint(leaves, random, std::clamp(70.0 / height, 0.7, 4.0), at);
    const double above = -turn.y * out;  // -1 .. 1
    paint.light =
        i == 0 ? 130 : 190 + static_cast<int>(90.0 * above + 50.0 * at.sun * turn.x * out);
    paint.middle_x = static_cast<int>(blob.middle.x);
    paint.middle_y = static_cast<int>(blob.middle.y);
    paint.light_y = -static_cast<int>(256.0 * 50.0 / std::max(3.0, blob.high));
    fillBlob(canvas, blob, paint);
  }
}

}  // namespace

const Tile& oneOf(const std::vector<Tile>& tiles, base::RandomSource& random) {
  return tiles[static_cast<std::size_t>(below(random, static_cast<int>(tiles.size())))];
}

Stuffs drawStuffs(base::RandomSource& random, Whereabouts where) {
  using Make = Surface (*)(base::RandomSource&, int);
  constexpr std::array<Make, 12> kAny = {brick, tiles, concrete, plaster, plaster, metal,
                                         metal, wood,  cloth,    cloth,   rock,    leaves};
  constexpr std::array<Make, 12> kHousehold = {plaster, plaster, plaster, plaster, metal, wood,
                                               wood,    wood,    cloth,   cloth,   tiles, concrete};
  const std::array<Make, 12>& makers = where == Whereabouts::kIndoors ? kHousehold : kAny;
  Stuffs stuffs;
  for (int i = 0; i < 2; ++i) stuffs.crowns.push_back(tileOf(foliage(random, 6), random));
  stuffs.trunks.push_back(tileOf(bark(random, 6), random));
  for (int i = 0; i < 5; ++i) {
    const Make make =
        makers[static_cast<std::size_t>(below(random, static_cast<int>(makers.size())))];
    stuffs.plain.push_back(tileOf(make(random, 6), random));
  }
  stuffs.printed.push_back(tileOf(print(random, 7), random));
  return stuffs;
}

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
  const Tile frame(drawColour(random, chance(random, 0.6) ? Hues::kCream : Hues::kDark));
  const Tile ledge(drawColour(random, chance(random, 0.5) ? Hues::kCream : Hues::kGrey));
  const Colour glass = mixed(drawColour(random, Hues::kDark), drawColour(random, Hues::kSky), 70);
  const Tile band(drawColour(random, chance(random, 0.4) ? Hues::kVivid : Hues::kEarth));
  const bool has_shops = chance(random, 0.4);
  const bool has_bars = chance(random, 0.7);
  Paint plain;
  for (int floor = 0; floor < floors; ++floor) {
    const bool is_shop = has_shops && floor == floors - 1;
    const double top = high * floor;
    if (is_shop) {
      plain.tile = &band;
      fillRectangle(canvas, {0.0, top + 0.08 * high}, {kSide, top + 0.3 * high}, plain);
    } else if (chance(random, 0.5)) {
      plain.tile = &ledge;
      fillRectangle(canvas, {0.0, top}, {kSide, top + 3.0}, plain);
    }
    for (int column = 0; column < columns; ++column) {
      const double share_x = is_shop ? 0.85 : part_x;
      const double share_y = is_shop ? 0.62 : part_y;
      const double left = wide * (column + 0.5 - 0.5 * share_x);
      const double low = is_shop ? top + 0.34 * high : top + high * (0.5 - 0.5 * share_y);
      const double right = left + wide * share_x;
      const double bottom = low + high * share_y;
      plain.tile = &frame;
      fillRectangle(canvas, {left, low}, {right, bottom}, plain);
      const Tile pane(
          lit(chance(random, 0.15) ? Colour{130, 190, 220} : glass, between(random, 150, 420)));
      Paint shine;
      shine.tile = &pane;
      shine.middle_y = static_cast<int>(low);
      shine.light_y = -static_cast<int>(256.0 * between(random, -60, 160) / (bottom - low));
      fillRectangle(canvas, {left + 1.5, low + 1.5}, {right - 1.5, bottom - 1.5}, shine);
      if (chance(random, 0.25)) {  // a blind
        plain.tile = &ledge;
        const double down = low + (bottom - low) * random.uniform(0.2, 0.8);
        fillRectangle(canvas, {left + 2.0, low + 2.0}, {right - 2.0, down}, plain);
      }
      plain.tile = &frame;
      if (has_bars) {
        const double middle = 0.5 * (left + right);
        fillRectangle(canvas, {middle - 0.7, low}, {middle + 0.7, bottom}, plain);
      }
      plain.tile = &ledge;
      if (!is_shop) fillRectangle(canvas, {left - 2.0, bottom}, {right + 2.0, bottom + 2.5}, plain);
    }
  }
  return {kBits, std::vector<cv::Vec4b>(canvas[0], canvas[0] + canvas.total())};
}

void addShadow(Canvas& canvas, const Standing& at, double wide) {
  addHaze(canvas, {at.foot.x - 0.3 * at.sun * wide, at.foot.y}, 1.2 * wide,
          std::max(1.5, 0.22 * wide), {18, 16, 15}, 190 * (256 - at.haze_share) / 256);
}

void addTree(Canvas& canvas, const Standing& at, const Stuffs& stuffs, base::RandomSource& random) {
  const double height = at.metre * random.uniform(3.0, 11.0);
  addShadow(canvas, at, 0.3 * height);
  const double draw = random.unit();
  if (draw < 0.2) {
    addConifer(canvas, at, height, stuffs, random);
    return;
  }
  Paint paint = standingPaint(oneOf(stuffs.trunks, random), random, 1.0, at);
  paint.light = between(random, 130, 230);
  paint.round = 150;
  const double width = std::max(1.2, height * random.uniform(0.03, 0.06));
  if (draw < 0.45) {
    const double lean = random.uniform(-0.06, 0.06);
    addBranches(canvas, at.foot, {lean * height, -0.3 * height}, width,
                std::clamp(static_cast<int>(height / 25.0), 2, 5), paint, random);
    return;
  }
  fillLine(canvas, at.foot,
           {at.foot.x + random.uniform(-0.05, 0.05) * height, at.foot.y - 0.6 * height}, width,
           0.6 * width, paint);
  addCrown(canvas, at, height, stuffs, random);
}

void addBush(Canvas& canvas, const Standing& at, const Stuffs& stuffs, base::RandomSource& random) {
  const Tile& leaves = oneOf(stuffs.crowns, random);
  const double size = at.metre * random.uniform(0.3, 1.2);
  addShadow(canvas, at, 1.1 * size);
  for (int i = between(random, 1, 4); i > 0; --i) {
    Blob blob;
    blob.wide = size * random.uniform(0.6, 1.2);
    blob.high = size * random.uniform(0.4, 0.9);
    blob.middle = {at.foot.x + size * random.uniform(-0.8, 0.8), at.foot.y - 0.7 * blob.high};
    blob.ragged = 120;
    blob.zoom = static_cast<int>(std::clamp(256.0 * 50.0 / size, 64.0, 1500.0));
    blob.shift = below(random, 512);
    blob.clumps = 160;
    Paint paint = standingPaint(leaves, random, std::clamp(30.0 / size, 0.7, 4.0), at);
    paint.middle_y = static_cast<int>(blob.middle.y);
    paint.light = 200;
    paint.light_y = -static_cast<int>(256.0 * 70.0 / std::max(3.0, blob.high));
    fillBlob(canvas, blob, paint);
  }
}

void addPole(Canvas& canvas, const Standing& at, const Stuffs& stuffs, base::RandomSource& random) {
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
      standingPaint(oneOf(stuffs.printed, random), random, std::clamp(40.0 / size, 0.5, 8.0), at);
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

void addCar(Canvas& canvas, const Standing& at, const Stuffs& stuffs, base::RandomSource& random) {
  const double m = at.metre;
  const double half = m * random.uniform(0.85, 2.2);  // from behind, or from the side
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
  Paint plate = standingPaint(oneOf(stuffs.printed, random), random, 3.0, at);
  fillRectangle(canvas, {foot.x - 0.26 * m, foot.y - 0.55 * belt},
                {foot.x + 0.26 * m, foot.y - 0.4 * belt}, plate);
}

void addFence(Canvas& canvas, const Standing& at, const Stuffs& stuffs,
              base::RandomSource& random) {
  const double m = at.metre;
  const double height = m * random.uniform(0.6, 1.8);
  const double step =
      m * (chance(random, 0.5) ? random.uniform(0.1, 0.3) : random.uniform(1.0, 2.5));
  const double width = std::max(1.0, std::min(0.6 * step, m * random.uniform(0.03, 0.14)));
  Paint paint =
      standingPaint(oneOf(stuffs.plain, random), random, std::clamp(20.0 / m, 0.5, 4.0), at);
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

void addThing(Canvas& canvas, const Standing& at, const Stuffs& stuffs,
              base::RandomSource& random) {
  const double wide = at.metre * random.uniform(0.15, 0.7);
  const double high = at.metre * random.uniform(0.3, 1.5);
  const Tile& tile =
      chance(random, 0.25) ? oneOf(stuffs.printed, random) : oneOf(stuffs.plain, random);
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
  // The corners of a regular polygon, each moved in or out: turned by the angle between two,
  // whose cosine and sine are tabled.
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
