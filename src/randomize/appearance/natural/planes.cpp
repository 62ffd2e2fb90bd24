#include "randomize/appearance/natural/planes.h"

#include <algorithm>
#include <cmath>

#include "randomize/appearance/natural/noise_table.h"
#include "randomize/appearance/natural/paint_pixel.h"
#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {
namespace {

std::uint32_t fixedPlace(double places) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(places * 65536.0));
}

/// One row of a ground, which is all at the same distance.
struct GroundRow {
  double distance;  ///< [m]
  double metre;     ///< [px]
  int haze;         ///< in 1/256
};

void putGround(Canvas& canvas, const Ground& ground, const GroundRow& row, int y, int shift,
               const Tile& tile, int first, int last) {
  const double scale = 1.0 / (row.metre * ground.texel);  // texels per pixel
  const TileReader reader(tile, levelOf(tile, 1.3 * scale));
  const double left = (first + 0.5 - 0.5 * canvas.cols) / row.metre;  // [m]
  std::uint32_t u = fixedPlace(left / ground.texel);
  const std::uint32_t step = fixedPlace(scale);
  const std::uint32_t v = fixedPlace(row.distance / ground.texel);
  const NoiseTable& patches = noise(Waves::kBroad);
  int patch = static_cast<int>(left * 24.0 * 256.0);
  const int patch_step = static_cast<int>(24.0 * 256.0 / row.metre);
  const int patch_row = static_cast<int>(row.distance * 24.0) + shift;
  // Far away a pixel averages many patches.
  const int strength = static_cast<int>(ground.patches * std::min(1.0, row.metre / 24.0));
  const Lanes haze = lanesOf(ground.haze);
  cv::Vec4b* pixels = canvas[y];
  for (int x = first; x <= last; ++x) {
    const cv::Vec4b& texel = reader.at(u, v);
    const int light = 256 + (patches.at((patch >> 8) + shift, patch_row) * strength >> 6);
    setPixel(pixels[x], mixedLanes(litLanes(lanesOf(texel), light), haze, row.haze));
    u += step;
    patch += patch_step;
  }
}

}  // namespace

void fillGround(Canvas& canvas, const Ground& ground, base::RandomSource& random) {
  const int shift = below(random, NoiseTable::kSide);
  const double dash_shift = random.uniform(0.0, 10.0);
  const double middle_x = 0.5 * canvas.cols;
  const int top = std::max(ground.first, static_cast<int>(std::floor(ground.horizon)) + 1);
  for (int y = std::max(0, top); y < canvas.rows; ++y) {
    const double under = std::max(0.3, y + 0.5 - ground.horizon);
    GroundRow row{};
    row.distance = ground.height * ground.focal / under;
    row.metre = under / ground.height;
    row.haze = static_cast<int>(256.0 * row.distance / (row.distance + ground.haze_distance));
    const double way =
        ground.middle + ground.slant * row.distance + ground.curve * row.distance * row.distance;
    const auto column = [&](double offset) {
      const double x = middle_x + (way + offset) * row.metre;
      return static_cast<int>(std::clamp(x + 0.5, 0.0, static_cast<double>(canvas.cols)));
    };
    const int left = ground.way == nullptr ? canvas.cols : column(-ground.half_width);
    const int right = ground.way == nullptr ? canvas.cols : column(ground.half_width);
    putGround(canvas, ground, row, y, shift, *ground.tile, 0, left - 1);
    if (ground.way == nullptr) continue;
    putGround(canvas, ground, row, y, shift, *ground.way, left, right - 1);
    putGround(canvas, ground, row, y, shift, *ground.tile, right, canvas.cols - 1);
    for (const Marking& marking : ground.markings) {
      const double along = row.distance + dash_shift;
      if (marking.dash > 0.0 && std::fmod(along, 2.0 * marking.dash) > marking.dash) continue;
      const double x = middle_x + (way + marking.offset) * row.metre;
      const double half = 0.5 * marking.width * row.metre;
      const int share = half < 0.5 ? static_cast<int>(360.0 * half) : 200;
      for (int i = std::max(0, static_cast<int>(x - half));
           i < std::min(canvas.cols, static_cast<int>(x + half) + 1); ++i) {
        const Colour colour = mixed(marking.colour, ground.haze, row.haze);
        const int worn = noise(Waves::kMedium).at(i * 2 + shift, y * 2) > 40 ? share / 2 : share;
        cv::Vec4b& pixel = canvas(y, i);
        setPixel(pixel, mixedLanes(lanesOf(pixel), lanesOf(colour), worn));
      }
    }
  }
}

Sky drawSky(base::RandomSource& random) {
  Sky sky;
  const double draw = random.unit();
  if (draw < 0.55) {  // blue, with or without clouds
    sky.zenith = drawColour(random, Hues::kSky);
    sky.zenith.blue = std::max(sky.zenith.blue, 150);
    sky.horizon = mixed(sky.zenith, {245, 238, 230}, between(random, 110, 210));
    sky.cover = chance(random, 0.3) ? 0 : between(random, 60, 190);
    sky.cloud = {250, 248, 246};
  } else if (draw < 0.88) {  // overcast
    const int grey = between(random, 130, 235);
    sky.zenith = {grey + 6, grey, grey - 4};
    sky.horizon = mixed(sky.zenith, {250, 248, 246}, between(random, 40, 180));
    sky.cover = between(random, 100, 256);
    sky.cloud = lit(sky.zenith, between(random, 190, 300));
  } else {  // evening
    sky.zenith = mixed(drawColour(random, Hues::kSky), {90, 60, 60}, 140);
    sky.horizon = {between(random, 90, 160), between(random, 140, 190), between(random, 215, 250)};
    sky.cover = between(random, 0, 200);
    sky.cloud = mixed(sky.zenith, sky.horizon, between(random, 60, 220));
  }
  return sky;
}

void fillSky(Canvas& canvas, const Sky& sky, int horizon, base::RandomSource& random) {
  const NoiseTable& table = noise(Waves::kBroad);
  const int shift_x = 256 * below(random, NoiseTable::kSide);
  const int shift_y = 256 * below(random, NoiseTable::kSide);
  const int wide = between(random, 50, 160);
  const int rows = std::min(canvas.rows, std::max(1, horizon));
  const Lanes cloud = lanesOf(sky.cloud);
  int place_y = shift_y;
  for (int y = 0; y < rows; ++y) {
    const Colour air = mixed(sky.zenith, sky.horizon, y * 256 / rows);
    // Clouds appear closer together towards the horizon.
    const int distance = 40 * rows / (rows - y + rows / 3);  // 30 .. 120
    const int step = wide * (60 + distance) / 90;
    place_y += step * (40 + distance) / 70;
    int place_x = shift_x - canvas.cols / 2 * step;
    cv::Vec4b* pixels = canvas[y];
    const Lanes of_air = lanesOf(air);
    int value = -127;
    for (int x = 0; x < canvas.cols; ++x, place_x += step) {
      if (x % 2 == 0 && sky.cover > 0) value = table.smoothAt(place_x, place_y);
      const int share = std::clamp((value - 64 + sky.cover / 2) * 4, 0, 256);
      const int shade = 256 - std::max(0, value) / 2;  // thick clouds are darker
      setPixel(pixels[x], share == 0 ? of_air : mixedLanes(of_air, litLanes(cloud, shade), share));
    }
  }
}

void fillRidge(Canvas& canvas, const Ridge& ridge, Paint paint, base::RandomSource& random) {
  const NoiseTable& table = noise(ridge.waves);
  const int shift = 256 * below(random, NoiseTable::kSide);
  const int row = 256 * below(random, NoiseTable::kSide);
  RowPainter painter(paint);
  const int bottom = std::min(canvas.rows, static_cast<int>(ridge.foot) + 1);
  std::vector<int> tops;
  int top = bottom;
  for (int x = 0; x < canvas.cols; ++x) {
    const double height =
        ridge.height * (0.5 + table.smoothAt(x * ridge.zoom + shift, row) / 130.0);
    tops.push_back(static_cast<int>(ridge.foot - std::max(0.0, height)));
    top = std::min(top, tops.back());
  }
  for (int y = std::max(0, top); y < bottom; ++y) {
    painter.startRow(y);
    for (int x = 0; x < canvas.cols; ++x) {
      if (tops[static_cast<std::size_t>(x)] > y) continue;
      painter.put(canvas(y, x), x, painter.lightAt(x), 256);
    }
  }
}

void fillWall(Canvas& canvas, const Wall& wall, const Tile& tile) {
  struct Column {
    double top;
    double inverse;  ///< of its height
    std::uint32_t u;
    int haze;
  };
  const int left = std::max(0, static_cast<int>(std::ceil(wall.left - 0.5)));
  const int right = std::min(canvas.cols - 1, static_cast<int>(std::ceil(wall.right - 0.5)) - 1);
  if (right < left) return;
  const double height_left = wall.bottom_left - wall.top_left;
  const double height_right = wall.bottom_right - wall.top_right;
  const double side = 1 << tile.bits;
  std::vector<Column> columns;
  double top = canvas.rows;
  double bottom = 0.0;
  for (int x = left; x <= right; ++x) {
    const double share = (x + 0.5 - wall.left) / (wall.right - wall.left);
    const double height = height_left + share * (height_right - height_left);
    const double high = wall.top_left + share * (wall.top_right - wall.top_left);
    // The farther away, the lower the wall is, and the more of it fits into a pixel.
    const double along =
        share * height_right / ((1.0 - share) * height_left + share * height_right);
    columns.push_back(
        {high, side * wall.repeats_along / height, fixedPlace(side * wall.repeats * along),
         wall.haze_left + static_cast<int>(share * (wall.haze_right - wall.haze_left))});
    top = std::min(top, high);
    bottom = std::max(bottom, high + height);
  }
  const double mean_height = 0.5 * (height_left + height_right);
  const TileReader reader(tile, levelOf(tile, side * wall.repeats_along / mean_height));
  const Lanes haze = lanesOf(wall.haze);
  const int last = std::min(canvas.rows - 1, static_cast<int>(bottom));
  const double limit = side * wall.repeats_along;
  for (int y = std::max(0, static_cast<int>(top)); y <= last; ++y) {
    for (int x = left; x <= right; ++x) {
      const Column& column = columns[static_cast<std::size_t>(x - left)];
      const double place = (y + 0.5 - column.top) * column.inverse;
      if (place < 0.0 || place >= limit) continue;
      const cv::Vec4b& texel = reader.at(column.u, fixedPlace(place));
      setPixel(canvas(y, x), mixedLanes(litLanes(lanesOf(texel), wall.light), haze, column.haze));
    }
  }
}

}  // namespace synthetic_dataset::randomize::natural
