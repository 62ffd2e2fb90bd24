#include "label/keypoint_states.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

namespace synthetic_dataset::label {
namespace {

/// What the camera sees, pixel by pixel.
struct SeenSurfaces {
  const cv::Mat& ids;
  const RangeAt& at;

  /// How much farther away the same surface is at a neighbour; nothing if that shows another
  /// object.
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
      // Both farther: a ridge or something thin, of which the middle is nearest. Both nearer: a
      // groove. Otherwise the less steep side, so that the step to what lies behind an edge does
      // not count.
      return *ahead * *back > 0.0 ? 0.0 : std::min(std::abs(*ahead), std::abs(*back));
    }
    if (!ahead && !back) return 0.0;
    const cv::Point inwards = ahead ? direction : -direction;
    return slopeByOutline(std::abs(ahead ? *ahead : *back), step(pixel + inwards, inwards));
  }

  /// The neighbour in a direction of the image, or in the opposite one, that continues the pixel's
  /// surface: the one with the smaller step. Nothing if neither does, or if the pixel shows a
  /// ridge.
  [[nodiscard]] std::optional<cv::Point> continuation(const cv::Point& pixel,
                                                      const cv::Point& direction) const {
    const auto ahead = step(pixel, direction);
    const auto back = step(pixel, -direction);
    if (ahead && back && *ahead * *back > 0.0) return std::nullopt;
    if (!ahead && !back) return std::nullopt;
    const bool takes_ahead = ahead && (!back || std::abs(*ahead) <= std::abs(*back));
    return takes_ahead ? pixel + direction : pixel - direction;
  }

  /// @param first  the step to the pixel's only neighbour
  /// @param next  the step from there to the pixel beyond, if that shows the same object
  static double slopeByOutline(double first, const std::optional<double>& next) {
    // A round surface turns away faster at its outline than a pixel farther in: for sqrt(2 r d), at
    // a distance d from the outline, a step is at most 1 / (sqrt(2) - 1) times the next. A larger
    // step leads to another surface of the object.
    constexpr double kTurning = 2.0;
    constexpr double kSteepest = 2.5;
    return kTurning * (next ? std::min(first, kSteepest * std::abs(*next)) : first);
  }
};

/// How far away the surface that a pixel shows is along another ray: where that ray meets the plane
/// through the pixel and its neighbours; nothing if it does not meet the plane.
std::optional<double> rangeAlong(const Eigen::Vector3d& ray, const cv::Point& pixel,
                                 const SeenSurfaces& seen, const CameraModel& camera) {
  // Points r d of a plane have m.d = 1 / r, with the same m for all of them.
  Eigen::Matrix3d directions;
  Eigen::Vector3d nearness;
  const cv::Point steps[] = {{1, 0}, {0, 1}};
  for (int i = 0; i < 3; ++i) {
    const auto next = i == 0 ? std::optional(pixel) : seen.continuation(pixel, steps[i - 1]);
    const cv::Point at = next ? *next : pixel + steps[i - 1];
    const auto direction = camera.ray({static_cast<double>(at.x), static_cast<double>(at.y)});
    if (!direction) return seen.at(pixel);
    directions.row(i) = direction->transpose();
    nearness[i] = 1.0 / (next ? seen.at(at) : seen.at(pixel));  // none: like the pixel
  }
  const double along = ray.dot(directions.inverse() * nearness);
  return along > 0.0 ? std::optional(1.0 / along) : std::nullopt;
}

/// Whether the surface that the pixel shows hides a point from the camera.
///
/// A surface of the object itself may be the one that the point is on, so a difference that its
/// slope explains within the pixel is tolerated. For anything else, what matters is where it lies
/// on the ray to the point: ground that an object stands on begins there, a wall in front of the
/// object does not.
bool isHidden(const Eigen::Vector3d& p_C, const cv::Point& pixel, bool shows_itself,
              const SeenSurfaces& seen, const CameraModel& camera, double tolerance) {
  const double range = seen.at(pixel);
  if (!(range > 0.0)) return false;
  const double distance = p_C.norm() - tolerance;
  if (shows_itself) {
    return range < distance - seen.slope(pixel, {1, 0}) - seen.slope(pixel, {0, 1});
  }
  const auto along = rangeAlong(p_C.normalized(), pixel, seen, camera);
  return along && *along < distance;
}

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
    const bool shows_itself = ids.at<int>(pixel) == instance;
    if (!isHidden(p_C[i], pixel, shows_itself, seen, camera, tolerance)) {
      keypoint.state = KeypointState::kVisible;
    } else {
      keypoint.state =
          shows_itself ? KeypointState::kHiddenByItself : KeypointState::kHiddenByAnother;
    }
  }
}

}  // namespace synthetic_dataset::label
