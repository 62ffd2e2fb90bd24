#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::motion {

/// Where objects and frames come from.
enum class MotionSource {
  kBag,        ///< a recording's TF
  kPlacement,  ///< placed at random, scene by scene
};

/// A topic, besides TF, whose messages say where frames are.
struct PoseTopic {
  std::string topic;
  std::optional<std::string> frame;  ///< that it moves; none: its messages name it
  std::optional<std::string>
      object;  ///< for joint states: the object whose joints they are; none: all objects
};

struct MotionOptions {
  MotionSource source = MotionSource::kBag;
  std::vector<std::string> bag_files;  ///< with kPlacement: only for recorded maps and calibrations
  std::vector<std::string>
      tf_topics;  ///< empty: /tf and /tf_static, or those of the only namespace that has TF
  std::vector<PoseTopic> pose_topics;
  std::int64_t scenes = 0;           ///< with kPlacement: the number of times at which pictures are
                                     ///< taken
  double rate = 30.0;                ///< [Hz]
  double start_offset = 0.0;         ///< [s]
  std::optional<double> duration;    ///< [s]
  std::optional<double> max_tf_gap;  ///< [s], may be infinite; none: the default of each frame
  std::optional<std::size_t>
      stretch;  ///< of a recording in which time goes back; none: the longest
};

}  // namespace synthetic_dataset::motion
