#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/bag_contents.h"

namespace synthetic_dataset::programs {

/// What a settings file is made of.
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
  std::vector<Object> objects;  ///< none: those that the recording seems to have
};

/// A settings file's text, and what is left to the user, a line each; the text marks it with TODO.
struct SettingsDraft {
  std::string text;
  std::vector<std::string> gaps;
};

/// Writes the shortest settings that run, as far as the inputs determine them, with comments.
[[nodiscard]] SettingsDraft draftSettings(const DraftInputs& inputs);

/// What an object is called that is a robot of the recording: by the robot, unless a group of
/// settings has that name.
[[nodiscard]] std::string objectNameOf(const motion::RobotFrame& robot);

/// The robot of the recording that an object's name means: by the name itself, else the only one.
[[nodiscard]] std::optional<motion::RobotFrame> robotNamed(const std::string& name,
                                                           const motion::BagContents& contents);

}  // namespace synthetic_dataset::programs
