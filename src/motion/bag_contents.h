#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "motion/tf/bag_file.h"
#include "motion/tf/frame_tree.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A frame that transforms move.
struct RecordedFrame {
  std::string name;
  std::vector<std::string> parents;  ///< in order of time; mostly one
  std::string root;                  ///< of its tree
  bool is_static = false;
  std::int64_t count = 0;  ///< of its transforms
  Duration period{0};      ///< from one to the next (median); 0: static
  Stamp first{0};          ///< of its transforms' stamps
  Stamp last{0};
  std::int64_t gap_count = 0;         ///< longer than 10 s and 20 periods
  Duration longest_gap{0};            ///< of these
  Eigen::Vector3d middle_R{0, 0, 0};  ///< of the box that its origin stays in, in the root's
                                      ///< frame [m]
  Eigen::Vector3d extent{0, 0, 0};    ///< of that box [m]
  double way_length = 0.0;            ///< how far it goes, all turns of its way [m]
  Stamp moves_from{0};                ///< when it leaves its first position; `first`: never
  Stamp moves_until{0};               ///< when it reaches its last one
  double turned = 0.0;  ///< by how much it is turned against its first orientation at most [rad]
  std::vector<RecordedTimes> known = {};     ///< from gap to gap; of a static one, all the time
  std::vector<Eigen::Vector3d> way_G = {};   ///< where its origin was, evenly over all times; of
                                             ///< one that moves
  std::vector<std::string> publishers = {};  ///< nodes that sent it
};

/// A camera's calibration that is recorded.
struct RecordedCamera {
  std::string topic;
  std::string frame;
  std::int64_t width = 0;   ///< [px]
  std::int64_t height = 0;  ///< [px]
};

/// A robot's model that is recorded: a text on a topic robot_description.
struct RecordedDescription {
  std::string topic;
  std::string robot;  ///< its name in the model
  std::string urdf;
};

/// What there is in a recording.
struct BagContents {
  RecordedTimes times;
  std::vector<RecordedFrame> frames;  ///< parents before children
  std::vector<std::string> kinds;     ///< of the bags, each once: "ROS 1", "ROS 2 (sqlite3)"
  std::vector<BagTopic> topics;       ///< by name
  std::vector<RecordedCamera> cameras;
  std::vector<RecordedDescription> descriptions;
  std::vector<std::string> pose_topics;  ///< that the frames come from, where there is no TF
  std::vector<std::string> notes;        ///< what was left out, other topics of TF, ...
};

/// Looks through bags that count as one recording.
/// @param global_frame  in which ways are measured, where it is known; else in the tree's root
/// @throws ErrorList with what is wrong with each file; a recording without TF is none
[[nodiscard]] BagContents readContents(const std::vector<std::string>& bag_files,
                                       const std::string& global_frame = "");

/// A frame that may be a robot's: "jackal/base_link".
struct RobotFrame {
  std::string name;    ///< of the robot: the frame's prefix, else "robot"
  std::string prefix;  ///< of its frames, without the slash; may be empty
  std::string frame;
};

/// Frames named base_link or base_footprint, one for each prefix; where there are none, the frames
/// that move against the root of their tree.
[[nodiscard]] std::vector<RobotFrame> robotFrames(const BagContents& contents);

/// The name of the robot that a URDF describes; empty: it is none.
[[nodiscard]] std::string robotOf(const std::string& urdf);

/// Frames whose names say that they are a camera's optical frame.
[[nodiscard]] std::vector<std::string> cameraFrames(const BagContents& contents);

}  // namespace synthetic_dataset::motion
