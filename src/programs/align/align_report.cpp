#include "programs/align/align_report.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

constexpr double kVagueShift = 0.05;  // [m] beyond this standard deviation the estimate is vague
constexpr double kVagueTurn = 0.01;   // [rad]

double degrees(double radians) { return radians * 180.0 / std::acos(-1.0); }

double shiftError(const run::CameraAlignment& found) { return found.stddev.head<3>().maxCoeff(); }

double turnError(const run::CameraAlignment& found) {
  return found.stddev.segment<3>(3).maxCoeff();
}

bool knowsPose(const run::CameraAlignment& found) {
  return shiftError(found) <= kVagueShift && turnError(found) <= kVagueTurn;
}

bool knowsFocalLength(const run::CameraAlignment& found, const run::AlignOptions& asked) {
  constexpr double kVague = 0.01;  // of the focal length
  return !asked.focal_length || found.stddev[run::kFocalEntry] <= kVague;
}

bool isBetter(const run::CameraAlignment& found) {
  return found.before && found.after && *found.after >= *found.before;
}

std::string score(const std::optional<double>& alignment) {
  return alignment ? fixed(*alignment, 3) : "none";
}

std::string poseText(const Pose& pose) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  std::string text = "[";
  for (const double each : {p.x(), p.y(), p.z()}) text += fixed(each, 5) + ", ";
  for (const double each : {q.x(), q.y(), q.z()}) text += fixed(each, 7) + ", ";
  return text + fixed(q.w(), 7) + "]";
}

}  // namespace

std::vector<std::string> alignmentLines(const run::CameraAlignment& found,
                                        const run::AlignOptions& asked) {
  const Eigen::AngleAxisd turn(found.X_FD.linear());
  std::vector<std::string> lines = {
      "# " + std::to_string(found.scenes) + " scenes; alignment " + score(found.before) +
          " before, " + score(found.after) + " with these settings",
      "# shifted by " + fixed(found.X_FD.translation().norm(), 4) + " m, turned by " +
          fixed(degrees(turn.angle()), 3) + " degrees",
      "camera:"};
  const std::string time = "  time_offset: " + fixed(toSeconds(found.time_offset), 4);
  lines.push_back(found.knows_time
                      ? time + "  # +- " + fixed(found.stddev[run::kTimeEntry], 4) + " s"
                      : "  # time_offset: too little moves in the pictures to find it");
  if (asked.focal_length) {
    lines.push_back("  focal_scale: " + fixed(found.focal_scale, 5) + "  # +- " +
                    fixed(found.stddev[run::kFocalEntry], 5));
  }
  lines.push_back("  correction: " + poseText(found.X_FD));
  lines.push_back("  # +- " + fixed(shiftError(found), 4) + " m, " +
                  fixed(degrees(turnError(found)), 3) +
                  " degrees (standard deviation of the least "
                  "certain axis)");
  if (!knowsPose(found)) {
    lines.push_back(
        "# The pictures do not determine the correction well: objects at several places and "
        "distances would.");
  }
  if (!knowsFocalLength(found, asked)) {
    lines.push_back(
        "# The pictures do not determine the focal length well: objects at several distances "
        "would. Leave focal_scale out.");
  }
  if (!isBetter(found)) {
    lines.push_back("# The labels do not fit the pictures better with it: do not use it.");
  }
  return lines;
}

bool isFound(const run::CameraAlignment& found, const run::AlignOptions& asked) {
  return isBetter(found) && knowsPose(found) && found.knows_time && knowsFocalLength(found, asked);
}

}  // namespace synthetic_dataset::programs
