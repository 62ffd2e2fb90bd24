#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/JointState.h>
#include <Eigen/Core>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A link of a robot that has joints.
struct JointedLink {
  struct Mimic {
    std::string joint;
    double multiplier = 1.0;
    double offset = 0.0;
  };

  std::string frame;  ///< name of its frame

  /// Index of the parent link, to which its joint connects it; none for a root.
  std::optional<std::size_t> parent = std::nullopt;

  Pose X_PL = Pose::Identity();     ///< in its parent, or in the robot for a root; at rest
  std::string joint = {};           ///< that moves it; empty if none does
  bool slides = false;              ///< along the axis [m]; otherwise it turns about it [rad]
  Eigen::Vector3d axis_L{1, 0, 0};  ///< of length 1
  double rest = 0.0;                ///< the joint's position at rest [m] or [rad]
  std::optional<Mimic> mimic = std::nullopt;
};

/// A robot whose links follow the positions of its joints.
struct JointedRobot {
  std::string object;
  std::string frame;  ///< gives the robot's pose

  /// Index of the link whose pose is that of `frame`; none: it is the pose of the robot's origin.
  std::optional<std::size_t> own_link;
  std::vector<JointedLink> links;
};

/// Computes the frames of a robot's links from the positions of its joints.
class JointFrames {
 public:
  /// @param positions  names of the joints with known positions
  JointFrames(const JointedRobot& robot, const std::set<std::string>& positions);

  /// The names of the frames that move.
  [[nodiscard]] std::vector<std::string> frames() const;

  /// The transforms of all frames whose joints are in the message.
  [[nodiscard]] std::vector<geometry_msgs::TransformStamped> transforms(
      const sensor_msgs::JointState& message) const;

 private:
  /// A frame A and the next one that moves relative to it, B: X_AB = before * displacement * after.
  struct Step {
    std::string from;
    std::string to;
    Pose before;
    std::size_t link;  ///< whose joint lies between them
    bool is_upwards;   ///< from the link to its parent
    Pose after = Pose::Identity();
  };

  void visit(std::size_t link, std::optional<std::size_t> came_from, const std::string& anchor,
             const Pose& X_AL);
  [[nodiscard]] bool isMoved(const JointedLink& link) const;

  JointedRobot robot_;
  std::set<std::string> positions_;
  std::vector<Step> steps_;
};

}  // namespace synthetic_dataset::motion
