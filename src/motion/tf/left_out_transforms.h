#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// Whether a transform holds at its time or at all times: `/tf` or `/tf_static`.
enum class TransformKind { kMoving, kStatic };

/// Why a transform cannot be used, if so. Its frames' names must not have leading slashes.
///
/// The checks are those of tf2's `BufferCore::setTransform`, which logs and drops such transforms
/// one by one, and two more: infinite numbers, and stamps of zero, which means "the latest" to tf2.
[[nodiscard]] std::optional<std::string> reasonToLeaveOut(
    const geometry_msgs::TransformStamped& transform, TransformKind kind);

/// Counts what was left out, so that a bag with thousands of bad transforms is reported in a few
/// lines.
class LeftOutTransforms {
 public:
  /// @param bag_file  empty if several bags are involved
  void add(const std::string& bag_file, const std::string& parent, const std::string& child,
           const std::string& reason, Stamp stamp);

  /// One sentence for each bag, pair of frames and reason, in order of their first occurrence.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct Entry {
    std::string bag_file, parent, child, reason;
    Stamp first;
    std::int64_t count = 1;
  };
  std::vector<Entry> entries_;                                  ///< in the order in which they were
                                                                ///< found
  std::map<std::array<std::string, 4>, std::size_t> place_of_;  ///< by bag, parent, child, reason
};

}  // namespace synthetic_dataset::motion
