#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// What the arguments of `setup_assistant` ask for.
struct AssistantOptions {
  bool wants_help = false;
  std::string file = "settings.yaml";
  std::vector<std::string> bag_files;  ///< of a file that is not there yet
  std::vector<std::string> folders;
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;   ///< 0: one that is free
  std::string page_folder;  ///< empty: the page that is part of the program
};

/// @param arguments  without the program's name
/// @throws Error for what is not known
[[nodiscard]] AssistantOptions parseAssistantLine(const std::vector<std::string>& arguments);

/// What `setup_assistant --help` prints.
[[nodiscard]] std::string assistantUsage();

/// Makes sure that the settings file is there: a new one is a draft for the bags.
/// @throws Error when a bag cannot be read or the file not be written
void makeSettingsFile(const AssistantOptions& options);

}  // namespace synthetic_dataset::programs
