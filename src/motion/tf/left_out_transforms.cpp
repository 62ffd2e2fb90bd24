#include "motion/tf/left_out_transforms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/bag/ros_time.h"

namespace synthetic_dataset::motion {
namespace {

/// Tolerance of the squared norm: QUATERNION_NORMALIZATION_TOLERANCE of tf2's buffer_core.cpp.
constexpr double kQuaternionTolerance = 10e-3;

template <std::size_t kCount>
std::optional<std::string> notFinite(const std::array<double, kCount>& numbers) {
  const auto isNan = [](double number) { return std::isnan(number); };
  const auto isInfinite = [](double number) { return std::isinf(number); };
  if (std::any_of(numbers.begin(), numbers.end(), isNan)) return "NaN";
  if (std::any_of(numbers.begin(), numbers.end(), isInfinite)) return "infinity";
  return std::nullopt;
}

std::string nameText(const std::string& frame) { return frame.empty() ? "(no name)" : frame; }

}  // namespace

std::optional<std::string> reasonToLeaveOut(const geometry_msgs::TransformStamped& transform,
                                            TransformKind kind) {
  const auto& t = transform.transform.translation;
  const auto& q = transform.transform.rotation;
  if (transform.child_frame_id.empty()) return "the child frame has no name";
  if (transform.header.frame_id.empty()) return "the parent frame has no name";
  if (transform.child_frame_id == transform.header.frame_id) return "the frame is its own parent";
  if (const auto what = notFinite<3>({t.x, t.y, t.z})) return *what + " in the translation";
  if (const auto what = notFinite<4>({q.x, q.y, q.z, q.w})) return *what + " in the rotation";
  const double squared_norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!(std::abs(squared_norm - 1.0) < kQuaternionTolerance)) {
    return "the rotation is not a quaternion of unit length";
  }
  if (kind == TransformKind::kMoving && !isRosTime(toStamp(transform.header.stamp))) {
    return "the time stamp is zero or out of range";
  }
  return std::nullopt;
}

void LeftOutTransforms::add(const std::string& bag_file, const std::string& parent,
                            const std::string& child, const std::string& reason, Stamp stamp) {
  const auto [place, is_new] =
      place_of_.try_emplace({bag_file, parent, child, reason}, entries_.size());
  if (is_new) {
    entries_.push_back({bag_file, parent, child, reason, stamp, 1});
  } else {
    ++entries_[place->second].count;
  }
}

std::vector<std::string> LeftOutTransforms::notes() const {
  std::vector<std::string> notes;
  for (const Entry& entry : entries_) {
    const std::string where = entry.bag_file.empty() ? "" : "bag " + entry.bag_file + ": ";
    const std::string what =
        entry.count == 1 ? "1 transform" : std::to_string(entry.count) + " transforms";
    notes.push_back(where + what + " of " + nameText(entry.parent) + " -> " +
                    nameText(entry.child) + (entry.count == 1 ? " was" : " were") +
                    " left out: " + entry.reason + " (first at " + secondsText(entry.first) + ")");
  }
  return notes;
}

}  // namespace synthetic_dataset::motion
