#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "motion/motion_options.h"
#include "motion/tf/bag_reader.h"
#include "motion/tf/joint_frames.h"
#include "motion/tf/pose_messages.h"
#include "motion/tf/transform_recording.h"

namespace synthetic_dataset::motion {

/// Adds frames from topics other than TF to a recording: from odometry, poses, Gazebo's states, and
/// joint states.
class PoseTopics {
 public:
  /// @param bags, recording  have to outlive this; the recording already contains all of TF
  PoseTopics(BagReader& bags, TransformRecording& recording);

  /// Reads the topics that the settings name.
  /// @param robots  whose joints may be moved by joint states
  /// @throws ErrorList if a topic does not exist, or is of a type that cannot be read; if a frame
  ///     or an object is missing
  void readNamed(const std::vector<PoseTopic>& named, const std::vector<JointedRobot>& robots);

  /// Reads topics that give frames which the recording lacks, if there is only one topic for a
  /// frame.
  /// @param frames  that should be connected with the global frame
  void readLacking(const std::string& global_frame, const std::vector<std::string>& frames);

  /// Reads the joint states of robots whose links have no frames in TF, if only one topic has them.
  void readJoints(const std::vector<JointedRobot>& robots);

  /// Whether the recording has joint states.
  [[nodiscard]] bool hasJointStates() const;

  /// What was read without being named in the settings, for the user.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  /// What could be read in addition, for errors about missing frames.
  [[nodiscard]] const std::vector<std::string>& hints() const { return hints_; }

 private:
  struct Source {
    BagTopic topic;
    const PoseMessage* message;
  };

  [[nodiscard]] std::vector<Source> unreadSources() const;
  void nameTopic(const PoseTopic& named, const std::vector<JointedRobot>& robots);
  void read(const Source& source, const std::string& frame);
  void readJoints(const std::string& topic, const std::vector<JointedRobot>& robots);
  struct GivenFrames {
    std::set<std::string> all;
    std::set<std::string> moved;  ///< of these
  };
  [[nodiscard]] GivenFrames framesOf(const Source& source);
  [[nodiscard]] std::set<std::string> jointsOf(const std::string& topic);
  void choose(const std::string& frame, const std::vector<Source>& sources,
              const std::string& global_frame);
  void readOnlyPose(const std::string& frame);

  BagReader& bags_;
  TransformRecording& recording_;
  std::set<std::string> read_;
  std::map<std::string, std::set<std::string>> joints_;     ///< by topic
  std::map<std::string, std::set<std::string>> unwrapped_;  ///< those of these joints whose angles
                                                            ///< exceed a turn
  std::vector<std::string> notes_;
  std::vector<std::string> hints_;
};

}  // namespace synthetic_dataset::motion
