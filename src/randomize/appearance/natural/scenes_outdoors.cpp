#include <algorithm>
#include <vector>

#include "randomize/appearance/natural/lens.h"
#include "randomize/appearance/natural/planes.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/scenes.h"
#include "randomize/appearance/natural/surfaces.h"
#include "randomize/appearance/natural/things.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// A view over the ground, with a sky.
struct View {
  Sky sky;
  Ground ground;
  int sun = 1;

  /// Where a point on the ground appears. @param across, ahead  [m]
  [[nodiscard]] Standing at(const Canvas& canvas, double across, double ahead) const {
    Standing standing;
    standing.metre = ground.focal / ahead;
    standing.foot = {0.5 * canvas.cols + across * standing.metre,
                     ground.horizon + ground.height * standing.metre};
    standing.haze = ground.haze;
    standing.haze_share = static_cast<int>(256.0 * ahead / (ahead + ground.haze_distance));
    standing.sun = sun;
    return standing;
  }
};

View drawView(const Canvas& canvas, base::RandomSource& random) {
  View view;
  view.sky = drawSky(random);
  view.sun = chance(random, 0.5) ? 1 : -1;
  view.ground.horizon = canvas.rows * random.uniform(0.28, 0.6);
  view.ground.focal = canvas.cols * random.uniform(0.7, 1.3);
  view.ground.height = random.uniform(0.5, 2.2);
  view.ground.texel = random.uniform(0.008, 0.02);
  view.ground.haze = mixed(view.sky.horizon, {170, 165, 160}, 60);
  view.ground.haze_distance =
      chance(random, 0.25) ? random.uniform(40.0, 120.0) : random.uniform(150.0, 900.0);
  view.ground.patches = between(random, 10, 60);
  return view;
}

/// Adds houses side by side along one side of a street, from far to near.
/// @param side  -1 for left, 1 for right
void addHouses(Canvas& canvas, const View& view, int side, double distance,
               const std::vector<Tile>& facades, base::RandomSource& random) {
  std::vector<double> ends = {random.uniform(2.5, 7.0)};
  while (ends.back() < 90.0) ends.push_back(ends.back() + random.uniform(5.0, 16.0));
  for (std::size_t i = ends.size() - 1; i > 0; --i) {
    if (chance(random, 0.12)) continue;  // a gap
    const double near = ends[i - 1];
    const double far = ends[i] - (chance(random, 0.3) ? 1.5 : 0.0);
    const double out = distance + random.uniform(0.0, 1.5);
    const double tall = random.uniform(4.0, 16.0);
    const auto across = [&](double ahead) {
      return view.ground.middle + view.ground.slant * ahead + side * out;
    };
    const Standing front = view.at(canvas, across(near), near);
    const Standing back = view.at(canvas, across(far), far);
    const Tile& facade = oneOf(facades, random);
    Wall wall;
    wall.haze = view.ground.haze;
    const Standing& left = side < 0 ? front : back;
    const Standing& right = side < 0 ? back : front;
    wall.left = left.foot.x;
    wall.right = right.foot.x;
    wall.bottom_left = left.foot.y;
    wall.bottom_right = right.foot.y;
    wall.top_left = left.foot.y - tall * left.metre;
    wall.top_right = right.foot.y - tall * right.metre;
    wall.haze_left = left.haze_share;
    wall.haze_right = right.haze_share;
    const double floors = std::max(1.0, tall / random.uniform(8.0, 13.0));
    wall.repeats_along = floors;
    wall.repeats = std::max(0.5, (far - near) / random.uniform(7.0, 12.0));
    wall.light = side == view.sun ? between(random, 140, 200) : between(random, 220, 300);
    if (wall.right > wall.left + 1.0) fillWall(canvas, wall, facade);
    // The face that is turned to the camera.
    Wall gable = wall;
    const double deep = 9.0 * front.metre;
    gable.left = side < 0 ? front.foot.x - deep : front.foot.x;
    gable.right = side < 0 ? front.foot.x : front.foot.x + deep;
    gable.bottom_left = gable.bottom_right = front.foot.y;
    gable.top_left = gable.top_right = front.foot.y - tall * front.metre;
    gable.haze_left = gable.haze_right = front.haze_share;
    gable.repeats = 1.0;
    gable.light = between(random, 150, 270);
    fillWall(canvas, gable, facade);
  }
}

/// Adds blocks of flats on the horizon.
void addSkyline(Canvas& canvas, const View& view, const Tile& facade, base::RandomSource& random) {
  for (int i = between(random, 4, 14); i > 0; --i) {
    const double ahead = random.uniform(90.0, 300.0);
    const Standing at = view.at(canvas, random.uniform(-0.6, 0.6) * ahead, ahead);
    const double wide = at.metre * random.uniform(4.0, 16.0);
    const double high = at.metre * random.uniform(8.0, 45.0);
    Paint paint = paintOf(facade, random, std::clamp(12.0 / at.metre, 1.0, 8.0));
    paint.haze = at.haze;
    paint.haze_share = std::min(210, at.haze_share + 40);
    paint.light = between(random, 170, 300);
    fillRectangle(canvas, {at.foot.x - wide, at.foot.y - high}, {at.foot.x + wide, at.foot.y + 1.0},
                  paint);
  }
}

void addRidges(Canvas& canvas, const View& view, const SceneMaterials& chosen,
               base::RandomSource& random) {
  const int count = between(random, 1, 3);
  for (int i = 0; i < count; ++i) {
    Ridge ridge;
    ridge.foot = view.ground.horizon + 2.0;
    const bool is_wood = i + 1 == count;
    ridge.height = canvas.rows * (is_wood ? random.uniform(0.02, 0.2) : random.uniform(0.03, 0.25));
    ridge.waves = is_wood ? Waves::kMedium : Waves::kBroad;
    ridge.zoom = is_wood ? between(random, 40, 130) : between(random, 20, 60);
    Paint paint = paintOf(is_wood ? chosen.crowns.front() : chosen.crowns.back(), random, 2.0);
    paint.haze = view.ground.haze;
    paint.haze_share = std::max(0, 190 - 80 * i - between(random, 0, 50));
    paint.light = between(random, 120, 240);
    fillRidge(canvas, ridge, paint, random);
  }
}

using AddThing = void (*)(Canvas&, const Standing&, const SceneMaterials&, base::RandomSource&);

/// Adds things on both sides of a way, the far ones first.
void addThings(Canvas& canvas, const View& view, const SceneMaterials& chosen,
               const std::vector<AddThing>& kinds, int count, double least_ahead,
               base::RandomSource& random) {
  std::vector<double> distances;
  for (int i = 0; i < count; ++i) {
    const double share = random.unit();
    distances.push_back(least_ahead / (1.0 - 0.95 * share));  // evenly spread over the image rows
  }
  std::sort(distances.rbegin(), distances.rend());
  for (const double ahead : distances) {
    const double way =
        view.ground.middle + view.ground.slant * ahead + view.ground.curve * ahead * ahead;
    const double spread = 0.55 * ahead * canvas.cols / view.ground.focal;
    double across = random.uniform(-spread, spread);
    const bool is_on_way = std::abs(across - way) < view.ground.half_width;
    if (view.ground.way != nullptr && is_on_way && chance(random, 0.75)) {
      across =
          way + (across < way ? -1.0 : 1.0) * view.ground.half_width * random.uniform(1.0, 1.6);
    }
    const AddThing add =
        kinds[static_cast<std::size_t>(below(random, static_cast<int>(kinds.size())))];
    add(canvas, view.at(canvas, across, ahead), chosen, random);
  }
}

void markRoad(Ground& ground, base::RandomSource& random) {
  const Colour white{between(random, 190, 240), between(random, 200, 245),
                     between(random, 200, 245)};
  const Colour yellow{between(random, 30, 80), between(random, 160, 200),
                      between(random, 200, 240)};
  const Colour& edge = chance(random, 0.7) ? white : yellow;
  if (chance(random, 0.7)) {
    const double offset = 0.9 * ground.half_width;
    ground.markings.push_back({-offset, 0.12, 0.0, edge});
    ground.markings.push_back({offset, 0.12, 0.0, edge});
  }
  if (chance(random, 0.75)) {
    const Colour& middle = chance(random, 0.7) ? white : yellow;
    const double dash = chance(random, 0.7) ? random.uniform(1.5, 4.0) : 0.0;
    ground.markings.push_back({0.0, 0.12, dash, middle});
    if (chance(random, 0.2)) ground.markings.push_back({0.25, 0.12, 0.0, middle});
  }
  if (chance(random, 0.6)) {  // a kerb
    const Colour stone = drawColour(random, Hues::kGrey);
    ground.markings.push_back({-ground.half_width, 0.2, 0.0, lit(stone, 300)});
    ground.markings.push_back({ground.half_width, 0.2, 0.0, lit(stone, 300)});
  }
}

}  // namespace

void drawStreet(Canvas& canvas, base::RandomSource& random) {
  View view = drawView(canvas, random);
  const SceneMaterials chosen = drawSceneMaterials(random);
  const Tile road = tileOf(asphalt(random, 8), random);
  const Tile pavement = tileOf(chance(random, 0.4)   ? tiles(random, 7)
                               : chance(random, 0.5) ? concrete(random, 7)
                                                     : grass(random, 7),
                               random);
  const int count = between(random, 1, 2);
  std::vector<Tile> facades;
  for (int i = 0; i < count; ++i) facades.push_back(drawFacade(random));
  view.ground.tile = &pavement;
  view.ground.way = &road;
  view.ground.half_width = random.uniform(2.5, 8.0);
  view.ground.middle = random.uniform(-0.8, 0.8) * view.ground.half_width;
  view.ground.slant = random.uniform(-0.25, 0.25);
  markRoad(view.ground, random);
  fillSky(canvas, view.sky, static_cast<int>(view.ground.horizon) + 2, random);
  if (chance(random, 0.6)) addRidges(canvas, view, chosen, random);
  if (chance(random, 0.6)) addSkyline(canvas, view, facades.front(), random);
  fillGround(canvas, view.ground, random);
  for (const int side : {-1, 1}) {
    if (chance(random, 0.25)) continue;
    const double distance = view.ground.half_width + random.uniform(1.0, 5.0);
    addHouses(canvas, view, side, distance, facades, random);
  }
  if (chance(random, 0.3)) soften(canvas, between(random, 1, 4));
  addThings(canvas, view, chosen,
            {addTree, addCar, addCar, addPole, addPole, addThing, addThing, addBush, addFence},
            between(random, 12, 36), random.uniform(4.0, 8.0), random);
}

void drawCountry(Canvas& canvas, base::RandomSource& random) {
  View view = drawView(canvas, random);
  const SceneMaterials chosen = drawSceneMaterials(random);
  const double kind = random.unit();
  const Tile meadow = tileOf(kind < 0.55   ? grass(random, 8)
                             : kind < 0.75 ? rock(random, 8)
                             : kind < 0.9  ? gravel(random, 8)
                                           : plaster(random, 8),
                             random);
  const Tile way = tileOf(chance(random, 0.6) ? asphalt(random, 7) : gravel(random, 7), random);
  view.ground.tile = &meadow;
  if (chance(random, 0.65)) view.ground.way = &way;
  view.ground.half_width = random.uniform(0.6, 5.0);
  view.ground.middle = random.uniform(-1.5, 1.5) * view.ground.half_width;
  view.ground.slant = random.uniform(-0.3, 0.3);
  view.ground.curve = random.uniform(-0.006, 0.006);
  if (view.ground.half_width > 2.2) markRoad(view.ground, random);
  fillSky(canvas, view.sky, static_cast<int>(view.ground.horizon) + 2, random);
  addRidges(canvas, view, chosen, random);
  fillGround(canvas, view.ground, random);
  std::vector<AddThing> kinds = {addTree, addTree, addBush, addBush, addPole, addFence, addThing};
  if (chance(random, 0.4)) kinds.push_back(addCar);
  if (chance(random, 0.3)) soften(canvas, between(random, 1, 4));
  addThings(canvas, view, chosen, kinds, between(random, 6, 30), random.uniform(5.0, 10.0), random);
}

void drawForest(Canvas& canvas, base::RandomSource& random) {
  View view = drawView(canvas, random);
  const SceneMaterials chosen = drawSceneMaterials(random);
  const Tile ground = tileOf(chance(random, 0.5) ? foliage(random, 8) : grass(random, 8), random);
  const Tile way = tileOf(chance(random, 0.5) ? rock(random, 7) : gravel(random, 7), random);
  view.ground.tile = &ground;
  if (chance(random, 0.5)) view.ground.way = &way;
  view.ground.half_width = random.uniform(0.5, 1.5);
  view.ground.middle = random.uniform(-2.0, 2.0);
  view.ground.slant = random.uniform(-0.3, 0.3);
  view.ground.curve = random.uniform(-0.01, 0.01);
  fillSky(canvas, view.sky, static_cast<int>(view.ground.horizon) + 2, random);
  for (int i = 0; i < 3; ++i) {  // foliage in front of the sky
    Ridge ridge;
    ridge.foot = view.ground.horizon + 2.0;
    ridge.height = canvas.rows * random.uniform(0.15, 1.1);
    ridge.waves = Waves::kMedium;
    ridge.zoom = between(random, 30, 100);
    Paint paint = paintOf(oneOf(chosen.crowns, random), random, random.uniform(0.8, 2.0));
    paint.haze = view.ground.haze;
    paint.haze_share = std::max(0, 150 - 60 * i);
    paint.light = between(random, 90, 220);
    fillRidge(canvas, ridge, paint, random);
  }
  fillGround(canvas, view.ground, random);
  if (chance(random, 0.5)) soften(canvas, between(random, 1, 4));
  addThings(canvas, view, chosen, {addTree, addTree, addTree, addTree, addBush, addBush},
            between(random, 8, 18), random.uniform(4.0, 7.0), random);
}

}  // namespace synthetic_dataset::randomize::natural
