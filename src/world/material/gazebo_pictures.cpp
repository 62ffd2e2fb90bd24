#include "world/material/gazebo_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>

namespace synthetic_dataset::world {
namespace {

/// Smooth noise from 0 to 1 over the unit square, which repeats at its edges. It depends only on
/// the seed and the position.
class PeriodicNoise {
 public:
  /// @param cells_u, cells_v  number of cells of the coarsest lattice; each octave has twice as
  ///     many, at half the amplitude
  PeriodicNoise(std::uint32_t seed, int cells_u, int cells_v, int octaves)
      : seed_(seed), cells_u_(cells_u), cells_v_(cells_v), octaves_(octaves) {}

  [[nodiscard]] float operator()(float u, float v) const {
    float sum = 0.0F;
    float weights = 0.0F;
    float weight = 1.0F;
    for (int octave = 0; octave < octaves_; ++octave, weight *= 0.5F) {
      sum += weight * layer(octave, u, v);
      weights += weight;
    }
    return sum / weights;
  }

  /// A pseudo-random number from 0 to 1 for a point of a grid.
  [[nodiscard]] static float value(std::uint32_t seed, int column, int row) {
    // The finaliser of MurmurHash3 (A. Appleby), applied to one number after another.
    std::uint32_t hash = mixed(seed + 0x9E3779B9U);
    hash = mixed(hash ^ static_cast<std::uint32_t>(column));
    hash = mixed(hash ^ static_cast<std::uint32_t>(row) ^ 0x85EBCA6BU);
    return static_cast<float>(hash >> 8U) / 16777215.0F;
  }

 private:
  static std::uint32_t mixed(std::uint32_t h) {
    h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
    return h ^ (h >> 16U);
  }

  /// Lattice values, interpolated by cubic smoothsteps.
  [[nodiscard]] float layer(int octave, float u, float v) const {
    const int columns = cells_u_ << octave;
    const int rows = cells_v_ << octave;
    const float x = (u - std::floor(u)) * static_cast<float>(columns);
    const float y = (v - std::floor(v)) * static_cast<float>(rows);
    const int i = static_cast<int>(x) % columns;
    const int j = static_cast<int>(y) % rows;
    const float fx = step(x - static_cast<float>(i));
    const float fy = step(y - static_cast<float>(j));
    const std::uint32_t seed = seed_ + 7919U * static_cast<std::uint32_t>(octave);
    const float top = joined(value(seed, i, j), value(seed, (i + 1) % columns, j), fx);
    const float bottom =
        joined(value(seed, i, (j + 1) % rows), value(seed, (i + 1) % columns, (j + 1) % rows), fx);
    return joined(top, bottom, fy);
  }

  static float step(float t) { return t * t * (3.0F - 2.0F * t); }
  static float joined(float a, float b, float share) { return a + (b - a) * share; }

  std::uint32_t seed_;
  int cells_u_;
  int cells_v_;
  int octaves_;
};

constexpr int kSide = 512;  // pixels

struct Colour {
  float red, green, blue;  // 0 .. 255
};

Colour operator*(const Colour& c, float factor) {
  return {c.red * factor, c.green * factor, c.blue * factor};
}

Colour blend(const Colour& a, const Colour& b, float share) {
  return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share,
          a.blue + (b.blue - a.blue) * share};
}

/// The colour at a point of the unit square; v grows downwards.
using Painter = std::function<Colour(float u, float v)>;

cv::Mat paint(const Painter& painter) {
  const auto byte = [](float x) {
    return static_cast<std::uint8_t>(std::clamp(x, 0.0F, 255.0F) + 0.5F);
  };
  cv::Mat picture(kSide, kSide, CV_8UC4);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const Colour c =
          painter((static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.5F) / kSide);
      picture.at<cv::Vec4b>(y, x) = cv::Vec4b(byte(c.blue), byte(c.green), byte(c.red), 255);
    }
  }
  return picture;
}

/// The fractional part of `x`.
float fraction(float x) { return x - std::floor(x); }

/// 1 within `width` of the cell's edges, 0 beyond a soft border.
float nearEdge(float along, float width) {
  const float distance = std::min(along, 1.0F - along);
  return std::clamp((width - distance) / (0.4F * width) + 1.0F, 0.0F, 1.0F);
}

/// Wood grain along u: wandering rings, and fibres.
float woodGrain(float u, float v) {
  static const PeriodicNoise kWander(11, 2, 6, 3);
  static const PeriodicNoise kFibre(12, 8, 128, 2);
  const float ring = fraction(6.0F * v + 2.6F * kWander(u, v));
  const float late_wood = ring * ring * (1.0F - ring) * 6.75F;  // dark towards a ring's end
  return 1.06F - 0.24F * late_wood - 0.16F * kFibre(u, v);
}

Colour wood(float u, float v) { return Colour{214, 167, 112} * woodGrain(u, v); }

Colour boards(float u, float v, int rows, const Colour& colour, float gap) {
  const float across = v * static_cast<float>(rows);
  const int row = static_cast<int>(across);
  const float shift = PeriodicNoise::value(21, 0, row);
  const float along = 2.0F * (u + shift);
  const int board = static_cast<int>(std::floor(along)) % 2;
  const float level = 0.82F + 0.3F * PeriodicNoise::value(22, board, row);
  const float grain = woodGrain(u + 0.37F * static_cast<float>(board), v + shift);
  const float seam = std::max(nearEdge(fraction(across), gap),
                              nearEdge(fraction(along), gap / static_cast<float>(rows)));
  return blend(colour * (level * grain), {46, 30, 18}, 0.75F * seam);
}

Colour woodFloor(float u, float v) { return boards(u, v, 8, {188, 128, 76}, 0.02F); }

Colour woodPallet(float u, float v) { return boards(u, v, 5, {196, 160, 116}, 0.08F); }

Colour bricks(float u, float v) {
  constexpr int kCourses = 12;
  constexpr int kColumns = 4;
  static const PeriodicNoise kStain(31, 8, 8, 4);
  static const PeriodicNoise kGrain(32, 128, 128, 2);
  const float y = v * kCourses;
  const int row = static_cast<int>(y);
  const float x = u * kColumns + (row % 2 == 0 ? 0.0F : 0.5F);
  const int column = static_cast<int>(x) % kColumns;
  const float level = 0.78F + 0.34F * PeriodicNoise::value(33, column, row);
  const float surface = 0.82F + 0.2F * kStain(u, v) + 0.16F * kGrain(u, v);
  const float joint = std::max(nearEdge(fraction(y), 0.07F), nearEdge(fraction(x), 0.025F));
  return blend(Colour{166, 80, 58} * (level * surface), Colour{186, 178, 166} * surface, joint);
}

Colour grass(float u, float v) {
  static const PeriodicNoise kPatches(41, 6, 6, 3);
  static const PeriodicNoise kBlades(42, 96, 40, 2);
  static const PeriodicNoise kTurned(43, 40, 96, 2);
  const float blades = 0.5F * (kBlades(u, v) + kTurned(u, v));
  const Colour colour = blend({62, 96, 34}, {132, 150, 66}, kPatches(u, v));
  return colour * (0.5F + 0.95F * blades);
}

Colour asphalt(float u, float v) {
  static const PeriodicNoise kWorn(51, 4, 4, 4);
  static const PeriodicNoise kStones(52, 256, 256, 1);
  return Colour{104, 104, 106} * (0.74F + 0.26F * kWorn(u, v) + 0.28F * kStones(u, v));
}

/// Asphalt with lanes along v and painted lines between them.
Painter road(int lanes, bool edges) {
  return [=](float u, float v) {
    constexpr float kHalfLine = 0.008F;
    float line = 0.0F;
    for (int lane = 1; lane < lanes; ++lane) {
      const float at = static_cast<float>(lane) / static_cast<float>(lanes);
      const bool dash = lane * 2 == lanes || fraction(2.0F * v) < 0.5F;  // the middle line is solid
      if (dash && std::abs(u - at) < kHalfLine) line = 1.0F;
    }
    if (edges && std::abs(std::min(u, 1.0F - u) - 0.03F) < kHalfLine) line = 1.0F;
    return blend(asphalt(u, v), {226, 224, 214}, 0.85F * line);
  };
}

Colour paving(float u, float v) {
  static const PeriodicNoise kGrain(61, 64, 64, 3);
  constexpr int kSlabs = 4;
  const float x = u * kSlabs;
  const float y = v * kSlabs;
  const float level =
      0.9F + 0.14F * PeriodicNoise::value(62, static_cast<int>(x), static_cast<int>(y));
  const float joint = std::max(nearEdge(fraction(x), 0.02F), nearEdge(fraction(y), 0.02F));
  return blend(Colour{172, 168, 160} * (level * (0.86F + 0.24F * kGrain(u, v))), {94, 92, 88},
               0.8F * joint);
}

/// White tiles with pin holes in a metal grid.
Colour ceiling(float u, float v) {
  static const PeriodicNoise kHoles(71, 160, 160, 1);
  constexpr int kTiles = 2;
  const float grid =
      std::max(nearEdge(fraction(u * kTiles), 0.02F), nearEdge(fraction(v * kTiles), 0.02F));
  const float hole = std::clamp((kHoles(u, v) - 0.72F) * 5.0F, 0.0F, 1.0F);
  return blend(Colour{232, 231, 226} * (1.0F - 0.22F * hole), {176, 178, 180}, grid);
}

Colour paintedWall(float u, float v) {
  static const PeriodicNoise kClouds(81, 5, 5, 4);
  static const PeriodicNoise kRoller(82, 200, 200, 1);
  return Colour{226, 220, 204} * (0.93F + 0.07F * kClouds(u, v) + 0.04F * kRoller(u, v));
}

Colour clouds(float u, float v) {
  static const PeriodicNoise kClouds(91, 4, 4, 6);
  const float cover = std::clamp((kClouds(u, v) - 0.42F) * 4.0F, 0.0F, 1.0F);
  return blend({98, 148, 210}, {244, 246, 250}, cover);
}

Colour greyGradient(float, float v) { return Colour{235, 235, 235} * (1.0F - 0.55F * v); }

/// The mark of a centre of mass: black and white quarters.
Colour quarters(float u, float v) {
  return (u < 0.5F) == (v < 0.5F) ? Colour{20, 20, 20} : Colour{240, 240, 240};
}

Colour windowFrame(float u, float v) {
  const float frame = std::max(nearEdge(u, 0.06F), nearEdge(v, 0.06F));
  return blend({150, 182, 200}, {238, 238, 234}, frame);
}

Colour plain(float, float) { return {216, 216, 216}; }

/// Bare earth with stones.
Colour dirt(float u, float v) {
  static const PeriodicNoise kPatches(101, 5, 5, 4);
  static const PeriodicNoise kGrains(102, 128, 128, 2);
  const Colour colour = blend({104, 82, 60}, {150, 124, 94}, kPatches(u, v));
  return colour * (0.66F + 0.6F * kGrains(u, v));
}

Colour mossyRock(float u, float v) {
  static const PeriodicNoise kMoss(111, 8, 8, 4);
  static const PeriodicNoise kGrains(112, 96, 96, 2);
  const Colour colour = blend({112, 108, 98}, {84, 94, 48}, kMoss(u, v));
  return colour * (0.66F + 0.6F * kGrains(u, v));
}

Colour flatNormals(float, float) { return {128, 128, 255}; }

const std::map<std::string, Painter>& painters() {
  static const std::map<std::string, Painter> kPainters{
      {"wood.jpg", wood},
      {"hardwood_floor.jpg", woodFloor},
      {"WoodPallet.png", woodPallet},
      {"building_frame.png", wood},
      {"window_frame.png", windowFrame},
      {"bricks.png", bricks},
      {"grass.jpg", grass},
      {"ceiling_tiled.jpg", ceiling},
      {"paintedWall.jpg", paintedWall},
      {"clouds.jpg", clouds},
      {"grey_gradient.jpg", greyGradient},
      {"com.png", quarters},
      {"runway.png", road(2, true)},
      {"road1.jpg", road(2, true)},
      {"residential.jpg", road(2, false)},
      {"sidewalk.jpg", paving},
      {"steps.jpeg", paving},
      {"motorway.jpg", road(6, true)},
      {"trunk.jpg", road(4, true)},
      {"primary.jpg", road(2, true)},
      {"secondary.jpg", road(1, true)},
      {"dirt_diffusespecular.png", dirt},
      {"fungus_diffusespecular.png", mossyRock},
      {"grass_diffusespecular.png", grass},
      {"terrain_detail.jpg", dirt},
      {"flat_normal.png", flatNormals},
  };
  return kPainters;
}

}  // namespace

bool isGazeboPicture(const std::string& file) { return painters().count(file) > 0; }

cv::Mat paintGazeboPicture(const std::string& file) {
  const auto painter = painters().find(file);
  return paint(painter == painters().end() ? Painter(plain) : painter->second);
}

}  // namespace synthetic_dataset::world
