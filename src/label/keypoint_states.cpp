#include "label/keypoint_states.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace synthetic_dataset::label {
namespace {

/// What the camera sees, pixel by pixel.
struct SeenSurfaces {
  const cv::Mat& ids;
  const RangeAt& at;

  /// How much farther the same surface is at a neighbour; nothing where that shows another.
  [[nodiscard]] std::optional<double> step(const cv::Point& pixel, const cv::Point& to) const {
    const cv::Point neighbour = pixel + to;
    if (!cv::Rect({0, 0}, ids.size()).contains(neighbour)) return std::nullopt;
    if (ids.at<int>(neighbour) != ids.at<int>(pixel) || !(at(neighbour) > 0.0)) return std::nullopt;
    return at(neighbour) - at(pixel);
  }

  /// How much the surface's distance can change within a pixel in one direction of the image.
  [[nodiscard]] double slope(const cv::Point& pixel, const cv::Point& direction) const {
    const auto ahead = step(pixel, direction);
    const auto back = step(pixel, -direction);
    if (ahead && back) {
      // Both farther: a ridge or something thin, and nothing of it is nearer than its middle. Both
      // nearer: a groove. Else the less steep side, so that the step to what lies behind an edge
      // does not count.
      return *ahead * *back > 0.0 ? 0.0 : std::min(std::abs(*ahead), std::abs(*back));
    }
    if (!ahead && !back) return 0.0;
    const cv::Point inwards = ahead ? direction : -direction;
    return slopeByOutline(std::abs(ahead ? *ahead : *back), step(pixel + inwards, inwards));
  }

  /// @param first  the step to the pixel's only neighbour
  /// @param next  from there to the one beyond, if it shows the same object
  static double slopeByOutline(double first, const std::optional<double>& next) {
    // A round surface turns away faster by its outline than it does a pixel farther in: of
    // sqrt(2 r d), at a distance d from the outline, a step is at most 1 / (sqrt(2) - 1) times the
    // next. What steps farther is another surface of the object.
    constexpr double kTurning = 2.0;
    constexpr double kSteepest = 2.5;
    return kTurning * (next ? std::min(first, kSteepest * std::abs(*next)) : first);
  }
};

}  // namespace

void findKeypointStates(std::vector<Keypoint>& keypoints, const std::vector<Eigen::Vector3d>& p_C,
                        int instance, const cv::Mat& ids, const RangeAt& range,
                        const CameraModel& camera, double tolerance) {
  const SeenSurfaces seen{ids, range};
  const cv::Rect image(0, 0, camera.width(), camera.height());
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    Keypoint& keypoint = keypoints[i];
    keypoint.state = KeypointState::kOutside;
    if (!keypoint.pixel) continue;
    const Eigen::Vector2d nearest = keypoint.pixel->array().round();
    if (!(nearest.x() >= 0.0 && nearest.y() >= 0.0 && nearest.x() < image.width &&
          nearest.y() < image.height)) {
      continue;
    }
    const cv::Point pixel(static_cast<int>(nearest.x()), static_cast<int>(nearest.y()));
    const double slack = tolerance + seen.slope(pixel, {1, 0}) + seen.slope(pixel, {0, 1});
    const bool hidden = seen.at(pixel) > 0.0 && seen.at(pixel) < p_C[i].norm() - slack;
    if (!hidden) {
      keypoint.state = KeypointState::kVisible;
    } else {
      keypoint.state = ids.at<int>(pixel) == instance ? KeypointState::kHiddenByItself
                                                      : KeypointState::kHiddenByAnother;
    }
  }
}

}  // namespace synthetic_dataset::label
