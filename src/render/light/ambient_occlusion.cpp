#include "render/light/ambient_occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "render/light/occluder_depths.h"
#include "render/pixels/lanes.h"
#include "render/pixels/pixel_bands.h"

namespace synthetic_dataset::render {
namespace {

constexpr float kRadius = 0.4F;  // [m]
constexpr int kSteps = 8;        // to each side
constexpr int kPattern = 4;      // pixels along the side of a square in which all directions differ
constexpr float kFarthestShare = 1.0F / 10.0F;  // of the picture's longer side: the longest search
constexpr float kFading = 0.615F;  // of the radius: the outer part, over which occlusion fades out
constexpr float kFlat = 0.02F;     // the sine of the angle up to which a surface counts as flat
constexpr int kOccluderMargin = OccluderDepths::kMargin;

float farthest(const cv::Size& image) {
  return std::max(4.0F, kFarthestShare * static_cast<float>(std::max(image.width, image.height)));
}

/// The arc cosine of each, with an error of 7e-5 (Abramowitz and Stegun 4.4.45).
Lanes arcCosine(const Lanes& cosine) {
  const Lanes x = cv::v_min(cv::v_abs(cosine), lanes(1.0F));
  const Lanes sum = ((lanes(-0.0187293F) * x + lanes(0.0742610F)) * x - lanes(0.2121144F)) * x +
                    lanes(1.5707288F);
  const Lanes angle = cv::v_sqrt(lanes(1.0F) - x) * sum;
  return cv::v_select(cosine < lanes(0.0F), lanes(static_cast<float>(M_PI)) - angle, angle);
}

/// For each pixel of a square, the direction of its slice, and how far out its steps begin.
struct Pattern {
  Pattern() {
    // A square in which each row and column has numbers from the whole range.
    constexpr std::array<int, 16> kOrder = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    for (std::size_t i = 0; i < kOrder.size(); ++i) {
      const double angle = M_PI * (kOrder[i] + 0.5) / 16.0;
      x[i] = static_cast<float>(std::cos(angle));
      y[i] = static_cast<float>(std::sin(angle));
      starts[i] = (static_cast<float>(kOrder[(i + 7) % 16]) + 0.5F) / 16.0F;
    }
  }

  /// The values of four adjacent pixels in a row of the picture.
  /// @param values  of a square, row by row
  [[nodiscard]] static Lanes four(const std::array<float, 16>& values, int u, int v) {
    const std::size_t row = std::size_t{kPattern} * (static_cast<unsigned>(v) % kPattern);
    std::array<float, kLaneCount> of_pixels;
    for (std::size_t i = 0; i < of_pixels.size(); ++i) {
      of_pixels[i] = values[row + (static_cast<unsigned>(u) + i) % kPattern];
    }
    return cv::v_load(of_pixels.data());
  }

  std::array<float, 16> x;
  std::array<float, 16> y;
  std::array<float, 16> starts;
};

const Pattern& pattern() {
  static const Pattern kThePattern;
  return kThePattern;
}

/// Four surfaces, and how far around them occluders are searched for.
struct FourSurfaces {
  int u;  ///< of the first pixel, in the picture
  int v;
  Lanes3 ray;
  Lanes3 position;
  Lanes3 to_eye;
  Lanes3 normal;
  Lanes radius;  ///< [m]
  Lanes pixels;  ///< the same [px]
  Lanes start;   ///< of the steps
};

struct Angle {
  Lanes sine;
  Lanes cosine;
};

/// The light that reaches surfaces in one slice, in any unit.
struct Reaching {
  Lanes open;   ///< past occluders
  Lanes whole;  ///< if there were no occluders
};

class HorizonFinder {
 public:
  HorizonFinder(const OccluderDepths& depths, const Intrinsics& k, const cv::Size& image)
      : depths_(depths), focal_(static_cast<float>(k.fx)), farthest_(farthest(image)) {}

  /// The light that reaches four adjacent pixels in a row.
  /// @param normals  of these pixels, as half floats
  [[nodiscard]] Reaching find(int u, int v, const std::uint16_t* normals) const {
    const Lanes depth = depths_.four(u, v);
    FourSurfaces four;
    four.u = u;
    four.v = v;
    four.ray = depths_.raysOfFour(u, v);
    four.position = four.ray * depth;
    const Lanes distance = cv::v_max(length(four.position), lanes(1e-6F));
    four.to_eye = four.position * (lanes(-1.0F) / distance);
    four.normal = normalized(loadHalves(normals).xyz);
    const Lanes scale = lanes(focal_) / distance;  // [px/m]
    four.pixels = cv::v_min(lanes(kRadius) * scale, lanes(farthest_));
    four.radius = four.pixels / scale;
    four.start = Pattern::four(pattern().starts, u, v);
    return openIn(four);
  }

 private:
  struct Direction {
    Lanes x, y;
  };

  [[nodiscard]] Reaching openIn(const FourSurfaces& four) const {
    const Direction direction{Pattern::four(pattern().x, four.u, four.v),
                              Pattern::four(pattern().y, four.u, four.v)};
    // The slice is the plane that contains the direction to the eye and this one.
    const Lanes far = lanes(8.0F);  // [px]
    const Lanes3 way =
        depths_.wayTo(four.u, four.v, far * direction.x, far * direction.y, four.ray);
    const Lanes3 across = normalized(way - four.to_eye * dot(way, four.to_eye));
    const Lanes along_across = dot(four.normal, across);
    const Lanes along_eye = dot(four.normal, four.to_eye);
    const Lanes size = cv::v_sqrt(along_across * along_across + along_eye * along_eye);
    const Lanes safe = cv::v_max(size, lanes(1e-6F));
    const Angle normal{along_across / safe, along_eye / safe};
    Reaching light{lanes(0.0F), lanes(0.0F)};
    addSide(1.0F, direction, four, normal, light);
    addSide(-1.0F, direction, four, normal, light);
    return {size * light.open, size * light.whole};
  }

  /// The light from angles between the direction to the eye and one to a side of it.
  /// @param cosine  of the angle between the two
  /// @param normal  the angle by which the normal is turned towards side 1
  [[nodiscard]] static Lanes lightUpTo(const Lanes& cosine, float side, const Angle& normal) {
    const Lanes angle = lanes(side) * arcCosine(cosine);
    const Lanes sine =
        lanes(side) * cv::v_sqrt(cv::v_max(lanes(1.0F) - cosine * cosine, lanes(0.0F)));
    const Lanes two = lanes(2.0F);
    const Lanes twice =
        (two * cosine * cosine - lanes(1.0F)) * normal.cosine + two * sine * cosine * normal.sine;
    return lanes(0.25F) * (normal.cosine - twice + two * angle * normal.sine);
  }

  /// Adds the light from one side of the direction to the eye. Starts at the surface: whatever is
  /// seen above everything seen before hides the angles between them.
  void addSide(float side, const Direction& direction, const FourSurfaces& four,
               const Angle& normal, Reaching& light) const {
    Lanes horizon = lanes(-side) * normal.sine;
    Lanes rest = lightUpTo(horizon, side, normal);
    light.whole += rest;
    light.open += rest;
    for (int step = 0; step < kSteps; ++step) {
      const Lanes out = (lanes(static_cast<float>(step)) + four.start) * lanes(1.0F / kSteps);
      const Lanes far = lanes(side) * cv::v_max(lanes(1.0F), out * cv::v_sqrt(out) * four.pixels);
      const FourPixels pixels = beside(four.u, four.v, far * direction.x, far * direction.y);
      const Lanes there = depths_.at(pixels);
      const Lanes3 way = depths_.raysAt(pixels) * there - four.position;
      const Lanes distance = cv::v_max(length(way), lanes(1e-6F));
      const Lanes cosine = clamped(dot(way, four.to_eye) / distance, -1.0F, 1.0F);
      // Ignores a plane's own pixels, which are not exactly in the slice.
      const Lanes is_above = dot(way, four.normal) > lanes(kFlat) * distance;
      const Lanes near =
          clamped((four.radius - distance) / (lanes(kFading) * four.radius), 0.0F, 1.0F);
      const Lanes counts = (there != lanes(0.0F)) & is_above & (near > lanes(0.0F));
      const Lanes hides = counts & (cosine > horizon);
      if (!cv::v_check_any(hides)) continue;
      horizon = cv::v_select(hides, cosine, horizon);
      const Lanes left = cv::v_select(hides, lightUpTo(cosine, side, normal), rest);
      light.open -= near * (rest - left);
      rest = left;
    }
  }

  const OccluderDepths& depths_;
  float focal_;
  float farthest_;
};

/// The light that reaches all pixels of a place, and those within kOccluderMargin around it.
class ReachingLight {
 public:
  explicit ReachingLight(const cv::Rect& place)
      : place_(place),
        open_(place.height + 2 * kOccluderMargin, place.width + 2 * kOccluderMargin + kLaneCount,
              CV_32FC1, cv::Scalar(0.0)),
        whole_(open_.clone()) {}

  void set(int u, int v, const Reaching& four) {
    cv::v_store(at(open_, u, v), four.open);
    cv::v_store(at(whole_, u, v), four.whole);
  }

  /// The share of light that reaches those pixels of a square that see the same surface.
  [[nodiscard]] Lanes shareAt(int u, int v, const OccluderDepths& depths,
                              const std::uint16_t* normals) const {
    const Lanes3 position = depths.raysOfFour(u, v) * depths.four(u, v);
    const Lanes3 normal = normalized(loadHalves(normals).xyz);
    const Lanes thick = lanes(0.01F) * length(position);
    Lanes open = lanes(0.0F);
    Lanes whole = lanes(0.0F);
    for (int dv = -kOcclusionSmoothing; dv < kOcclusionSmoothing; ++dv) {
      for (int du = -kOcclusionSmoothing; du < kOcclusionSmoothing; ++du) {
        const Lanes depth = depths.four(u + du, v + dv);
        const Lanes3 way = depths.raysOfFour(u + du, v + dv) * depth - position;
        const Lanes is_same = (cv::v_abs(dot(way, normal)) <= thick) & (depth != lanes(0.0F));
        open += cv::v_load(at(open_, u + du, v + dv)) & is_same;
        whole += cv::v_load(at(whole_, u + du, v + dv)) & is_same;
      }
    }
    return clamped(open / cv::v_max(whole, lanes(1e-6F)), 0.0F, 1.0F);
  }

 private:
  [[nodiscard]] float* at(cv::Mat& image, int u, int v) const {
    return image.ptr<float>(v - place_.y + kOccluderMargin, u - place_.x + kOccluderMargin);
  }
  [[nodiscard]] const float* at(const cv::Mat& image, int u, int v) const {
    return image.ptr<float>(v - place_.y + kOccluderMargin, u - place_.x + kOccluderMargin);
  }

  cv::Rect place_;
  cv::Mat open_;   ///< CV_32FC1
  cv::Mat whole_;  ///< CV_32FC1
};

/// The image with enough columns that four pixels can be read from any column.
cv::Mat withLanes(const cv::Mat& image) {
  cv::Mat wide;
  cv::copyMakeBorder(image, wide, 0, 0, 0, kLaneCount, cv::BORDER_CONSTANT, cv::Scalar::all(0));
  return wide;
}

/// Calls action(column, row) for every four pixels of which at least one is not 0.
/// @param pixels  CV_8UC1, withLanes()
template <class Action>
void forEachFour(const cv::Mat& pixels, const Action& action) {
  for (int row = 0; row < pixels.rows; ++row) {
    const auto* is_meant = pixels.ptr<std::uint8_t>(row);
    for (int column = 0; column < pixels.cols - kLaneCount; column += kLaneCount) {
      const auto* four = is_meant + column;
      if ((four[0] | four[1] | four[2] | four[3]) != 0) action(column, row);
    }
  }
}

}  // namespace

int occlusionReach(const cv::Size& image) {
  return static_cast<int>(std::ceil(farthest(image))) + kOcclusionSmoothing + 1;
}

cv::Mat occlusionReaches(const Occluders& seen) {
  const OccluderDepths depths(seen);
  const float most = farthest(seen.image);
  const auto focal = static_cast<float>(seen.intrinsics.fx);
  cv::Mat reaches(seen.place.height, seen.place.width + kLaneCount, CV_32FC1);
  for (int row = 0; row < seen.place.height; ++row) {
    for (int column = 0; column < seen.place.width; column += kLaneCount) {
      const int u = seen.place.x + column;
      const int v = seen.place.y + row;
      const Lanes distance =
          cv::v_max(length(depths.raysOfFour(u, v) * depths.four(u, v)), lanes(1e-6F));
      cv::v_store(reaches.ptr<float>(row, column),
                  cv::v_min(lanes(kRadius * focal) / distance, lanes(most)));
    }
  }
  // Pixels share the results of those around them.
  cv::Mat shared;
  const int square = 2 * kOcclusionSmoothing + 1;
  cv::dilate(reaches.colRange(0, seen.place.width), shared, cv::Mat::ones(square, square, CV_8UC1));
  return shared + kOcclusionSmoothing + 1.0;
}

cv::Mat ambientVisibility(const Occluders& seen, const cv::Mat& normals, const cv::Rect& place,
                          const cv::Mat& wanted) {
  const OccluderDepths depths(seen);
  const cv::Mat directions = withLanes(normals);
  const cv::Mat needed = withPixelsAround(wanted, kOcclusionSmoothing);
  const HorizonFinder finder(depths, seen.intrinsics, seen.image);
  ReachingLight light(place);
  forEachFour(withLanes(needed), [&](int column, int row) {
    light.set(
        place.x + column, place.y + row,
        finder.find(place.x + column, place.y + row, directions.ptr<std::uint16_t>(row, column)));
  });
  cv::Mat open(place.height, place.width + kLaneCount, CV_32FC1, cv::Scalar(1.0));
  forEachFour(withLanes(wanted), [&](int column, int row) {
    cv::v_store(open.ptr<float>(row, column),
                light.shareAt(place.x + column, place.y + row, depths,
                              directions.ptr<std::uint16_t>(row, column)));
  });
  return open.colRange(0, place.width);
}

}  // namespace synthetic_dataset::render
