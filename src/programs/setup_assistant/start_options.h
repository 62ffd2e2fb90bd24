#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// The parsed arguments of `setup_assistant`.
struct AssistantOptions {
  bool wants_help = false;
  std::string file = "settings.yaml";
  std::vector<std::string> bag_files;  ///< for a settings file that does not exist yet
  std::vector<std::string> folders;
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;   ///< 0: any free port
  std::string page_folder;  ///< empty: the page that is compiled into the program
};

/// @param arguments  without the program's name
/// @throws Error for unknown or invalid arguments
[[nodiscard]] AssistantOptions parseAssistantLine(const std::vector<std::string>& arguments);

/// The output of `setup_assistant --help`.
[[nodiscard]] std::string assistantUsage();

/// Makes sure that the settings file exists: a new one is a draft for the bags.
/// @throws Error when a bag cannot be read or the file cannot be written
void makeSettingsFile(const AssistantOptions& options);

}  // namespace synthetic_dataset::programs
