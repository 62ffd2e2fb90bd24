#include "plugins/readback/cuboid_lines.h"

#include <optional>

namespace synthetic_dataset::formats {

std::vector<std::array<cv::Point2d, 2>> cuboidLines(const Cuboid& cuboid_O, const Pose& X_CO,
                                                    const CameraModel& camera) {
  constexpr int kPieces = 16;
  std::vector<std::array<cv::Point2d, 2>> lines;
  const std::array<Eigen::Vector3d, 8> corners = cuboid_O.corners();
  const auto drawEdge = [&](const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O) {
    std::optional<Eigen::Vector2d> last;
    for (int i = 0; i <= kPieces; ++i) {
      const double share = static_cast<double>(i) / kPieces;
      const auto place = camera.project(X_CO * (from_O + share * (to_O - from_O)));
      if (last && place) {
        lines.push_back({cv::Point2d(last->x(), last->y()), cv::Point2d(place->x(), place->y())});
      }
      last = place;
    }
  };
  // Corners whose indices differ in one bit share an edge.
  for (unsigned from = 0; from < 8; ++from) {
    for (const unsigned bit : {1U, 2U, 4U}) {
      if ((from & bit) == 0) drawEdge(corners[from], corners[from | bit]);
    }
  }
  return lines;
}

}  // namespace synthetic_dataset::formats
