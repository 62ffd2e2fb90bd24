#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "motion/tf/frame_findings.h"
#include "motion/tf/frame_tree.h"
#include "motion/tf/left_out_transforms.h"
#include "motion/tf/recorded_transform.h"
#include "motion/tf/stretches.h"

namespace synthetic_dataset::motion {

/// Collects transforms and decides which of them count, by tf2's rules as far as these apply:
/// - the first transform of a frame decides whether that frame is static or moving, for good;
/// - of a moving frame's transforms with the same stamp, the first counts;
/// - a static transform's first value also holds before it, each later one from its stamp on;
/// - where time goes back, the recording is cut into stretches, of which only one counts;
/// - for a frame all of whose stamps are zero, the record times are used instead.
/// Transforms that tf2 would reject with a log line each are left out and named in notes().
class TransformRecording {
 public:
  /// Adds a transform; has to be called in the order of record times.
  void add(RecordedTransform added);

  /// Whether no usable transform was added.
  [[nodiscard]] bool empty() const { return histories_.empty(); }

  /// Whether a transform of this frame was added.
  [[nodiscard]] bool moves(const std::string& frame) const;

  /// The frames that transforms connect with this one, including itself, regardless of when the
  /// transforms are known.
  [[nodiscard]] std::set<std::string> connectedWith(const std::string& frame) const;

  /// Ends the recording and returns its tree; to be called once.
  /// @param stretch  the one that counts; nothing: the longest
  /// @throws ErrorList if there is no such stretch, or if a frame's stamps are further apart than
  ///     any recording lasts
  [[nodiscard]] FrameTree finish(std::optional<std::size_t> stretch = std::nullopt);

  /// What was left out and why.
  [[nodiscard]] std::vector<std::string> notes() const { return left_out_.notes(); }

  // The finished recording:

  /// Several, if time went back.
  [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
  [[nodiscard]] std::size_t stretch() const { return stretch_; }

  /// By how much the stamps are behind the record times: the median of all moving transforms.
  [[nodiscard]] Duration clockOffset() const { return clock_offset_; }

  /// What is odd about single frames.
  [[nodiscard]] const std::vector<FrameFinding>& findings() const { return findings_; }

 private:
  struct Source {
    Stamp recorded;
    Arrival arrival;
    std::size_t publisher;  ///< index in publishers_
  };
  struct History {
    FrameId child;
    TransformKind kind;
    std::vector<LinkHistory::Sample> samples;
    std::vector<Source> sources;  ///< of the samples
    bool is_moved = false;        ///< for a static frame: `/tf` moves it, too
    std::vector<std::string> publishers{};
  };

  std::size_t publisherOf(const std::string& name);
  void finishStampsOfZero();
  [[nodiscard]] Duration medianOffset() const;
  void cut(std::optional<std::size_t> stretch);
  [[nodiscard]] static bool continuesRun(const History& history, const LinkHistory::Sample& next,
                                         Stamp recorded);
  void dropMixedTimes(History& history, const std::vector<Arrival>& steps);
  void findStretches(const Cuts& cuts);
  void keepMoving(const Cuts& cuts, std::size_t index);
  void keepStatic(const Cuts& cuts, History& history);
  void namePublishers(History& history);
  void sortByStamp(History& history);
  void timeStatic(History& history);
  void link(History& history);
  void find(std::optional<FrameFinding> finding);
  void checkSpans() const;

  FrameTree tree_;
  LeftOutTransforms left_out_;
  std::vector<History> histories_;
  std::unordered_map<FrameId, std::size_t> history_of_;  ///< by child frame
  std::vector<std::string> publishers_;
  std::unordered_map<std::uint32_t, std::string> bags_;  ///< their files, by bag number
  std::vector<Stretch> stretches_;
  std::size_t stretch_ = 0;
  Duration clock_offset_{0};
  std::vector<FrameFinding> findings_;
};

}  // namespace synthetic_dataset::motion
