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
  std::int64_t gap_count = 0;         ///< gaps longer than both 10 s and 20 periods
  Duration longest_gap{0};            ///< of these
  Eigen::Vector3d middle_R{0, 0, 0};  ///< of the bounding box of its origin's positions, in the
                                      ///< root's frame [m]
  Eigen::Vector3d extent{0, 0, 0};    ///< of that box [m]
  double path_length = 0.0;           ///< length of its path [m]
  Stamp moves_from{0};                ///< when it leaves its first position; equal to `first` if
                                      ///< never
  Stamp moves_until{0};               ///< when it reaches its last one
  double turned = 0.0;                ///< largest rotation from its first orientation [rad]
  std::vector<RecordedTimes> known = {};     ///< intervals between gaps; all the time for a static
                                             ///< frame
  std::vector<Eigen::Vector3d> path_G = {};  ///< sampled positions of its origin, evenly over all
                                             ///< times; only for a moving frame
  std::vector<std::string> publishers = {};  ///< nodes that published it
};

/// A recorded calibration of a camera.
struct RecordedCamera {
  std::string topic;
  std::string frame;
  std::int64_t width = 0;   ///< [px]
  std::int64_t height = 0;  ///< [px]
};

/// A recorded model of a robot: a text on a topic robot_description.
struct RecordedDescription {
  std::string topic;
  std::string robot;  ///< its name in the model
  std::string urdf;
};

/// The contents of a recording.
struct BagContents {
  RecordedTimes times;
  std::vector<RecordedFrame> frames;  ///< parents before children
  std::vector<std::string> kinds;     ///< of the bags, each once: "ROS 1", "ROS 2 (sqlite3)"
  std::vector<BagTopic> topics;       ///< by name
  std::vector<RecordedCamera> cameras;
  std::vector<RecordedDescription> descriptions;
  std::vector<std::string> pose_topics;  ///< that the frames come from, if there is no TF
  std::vector<std::string> notes;        ///< what was left out, other topics of TF, ...
};

/// Reads the contents of bags that count as one recording.
/// @param global_frame  in which paths are traced, if it is known; otherwise in the tree's root
/// @throws ErrorList with what is wrong with each file; a recording without TF is not an error
[[nodiscard]] BagContents readContents(const std::vector<std::string>& bag_files,
                                       const std::string& global_frame = "");

/// A frame that may be a robot's: "jackal/base_link".
struct RobotFrame {
  std::string name;    ///< of the robot: the frame's prefix, else "robot"
  std::string prefix;  ///< of its frames, without the slash; may be empty
  std::string frame;
};

/// Frames named base_link or base_footprint, one for each prefix; if there are none, the frames
/// that move relative to the root of their tree.
[[nodiscard]] std::vector<RobotFrame> robotFrames(const BagContents& contents);

/// The name of the robot that a URDF describes; empty if it is not a URDF.
[[nodiscard]] std::string robotOf(const std::string& urdf);

/// Frames whose names indicate a camera's optical frame.
[[nodiscard]] std::vector<std::string> cameraFrames(const BagContents& contents);

}  // namespace synthetic_dataset::motion
