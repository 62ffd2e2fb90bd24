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

/// Collects transforms and settles which of them count, by tf2's rules where these say something:
/// - the first transform of a frame decides whether that frame is static or moving, for good;
/// - of a moving frame's transforms with the same stamp, the first counts;
/// - a static transform's first value also holds before it, each later one from its stamp on;
/// - where time goes back, the recording is cut into stretches, of which one counts;
/// - a frame all of whose stamps are zero has the record times in their place.
/// What tf2 would refuse with a log line each is left out and named in notes().
class TransformRecording {
 public:
  /// Transforms are added in the order of their record times.
  void add(RecordedTransform added);

  /// Whether nothing that counts was added.
  [[nodiscard]] bool empty() const { return histories_.empty(); }

  /// Whether a transform of this frame was added.
  [[nodiscard]] bool moves(const std::string& frame) const;

  /// The frames that transforms connect with this one, itself among them, when it is left aside at
  /// which times they are known.
  [[nodiscard]] std::set<std::string> connectedWith(const std::string& frame) const;

  /// Ends the recording, to be called once: which frame hung below which one, when and where.
  /// @param stretch  that counts; nothing: the longest one
  /// @throws ErrorList when there is no such stretch, or when a frame's stamps are further apart
  ///     than any recording lasts
  [[nodiscard]] FrameTree finish(std::optional<std::size_t> stretch = std::nullopt);

  /// What was left out and why.
  [[nodiscard]] std::vector<std::string> notes() const { return left_out_.notes(); }

  // The finished recording:

  /// Several, where time went back.
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
    bool is_moved = false;        ///< a static one, by transforms that are not
    std::vector<std::string> publishers{};
  };

  std::size_t publisherOf(const std::string& name);
  void finishStampsOfZero();
  [[nodiscard]] Duration medianOffset() const;
  void cut(std::optional<std::size_t> stretch);
  [[nodiscard]] static bool lastsOn(const History& history, const LinkHistory::Sample& next,
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
  std::unordered_map<FrameId, std::size_t> history_of_;  ///< of a child frame
  std::vector<std::string> publishers_;
  std::unordered_map<std::uint32_t, std::string> bags_;  ///< their files
  std::vector<Stretch> stretches_;
  std::size_t stretch_ = 0;
  Duration clock_offset_{0};
  std::vector<FrameFinding> findings_;
};

}  // namespace synthetic_dataset::motion
