#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/bag_contents.h"

namespace synthetic_dataset::programs {

/// The inputs from which a settings file is drafted.
struct DraftInputs {
  std::vector<std::string> bag_files;      ///< absolute
  motion::BagContents contents;            ///< of the bags
  std::optional<std::string> world;        ///< absolute; none: a ground and a sun
  std::vector<std::string> model_folders;  ///< of the world's models
  std::optional<std::string> camera_info;  ///< absolute; none: a recorded one, or a pinhole
  std::vector<std::string> formats;        ///< names of formats::formatNames()

  struct Object {
    std::string name;
    std::optional<std::string> model;  ///< absolute, or a URI
    double size = 0.0;                 ///< of the model [m]; 0: not known
  };
  std::vector<Object> objects;  ///< empty: `robot_list` is a gap that is left to the user
};

/// A settings file's text, and the gaps left to the user, one line each; TODO marks them in the
/// text.
struct SettingsDraft {
  std::string text;
  std::vector<std::string> gaps;
};

/// Writes the shortest settings that run, as far as the inputs determine them, with comments.
[[nodiscard]] SettingsDraft draftSettings(const DraftInputs& inputs);

/// The object's name for a robot of the recording: the robot's own, with a suffix if a group of
/// settings has that name.
[[nodiscard]] std::string objectNameOf(const motion::RobotFrame& robot);

/// The robot of the recording to which an object's name refers: the robot of that name, else the
/// only robot there is.
[[nodiscard]] std::optional<motion::RobotFrame> robotNamed(const std::string& name,
                                                           const motion::BagContents& contents);

}  // namespace synthetic_dataset::programs
