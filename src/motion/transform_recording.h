#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include <geometry_msgs/TransformStamped.h>

#include "motion/frame_tree.h"
#include "motion/left_out_transforms.h"

namespace synthetic_dataset::motion {

/// Collects transforms and settles, by tf2's rules, which of them count:
/// - the first transform of a frame decides whether that frame is static or moving, for good;
/// - of a moving frame's transforms with the same stamp, the first counts;
/// - of a static frame's transforms, the last counts.
/// What tf2 would refuse with a log line each is left out and told in notes().
class TransformRecording {
 public:
  /// Transforms are added in the order of their record times.
  /// @param bag_file  where it comes from, for notes
  void add(geometry_msgs::TransformStamped transform, TransformKind kind,
           const std::string& bag_file);

  /// Whether nothing that counts was added.
  [[nodiscard]] bool empty() const { return histories_.empty(); }

  /// Ends the recording, to be called once: which frame hung below which one, when and where.
  /// @throws ErrorList when a frame's stamps are further apart than any recording lasts
  [[nodiscard]] FrameTree finish();

  /// What was left out and why.
  [[nodiscard]] std::vector<std::string> notes() const { return left_out_.notes(); }

 private:
  struct History {
    FrameId child;
    TransformKind kind;
    std::vector<LinkHistory::Sample> samples;
  };

  void sortByStamp(History& history);
  void checkSpans() const;

  FrameTree tree_;
  LeftOutTransforms left_out_;
  std::vector<History> histories_;
  std::unordered_map<FrameId, std::size_t> history_of_;  ///< of a child frame
};

}  // namespace synthetic_dataset::motion
