#include "programs/setup_assistant/start_options.h"

#include <filesystem>
#include <optional>

#include "base/yaml_scalar.h"
#include "motion/bag/bag.h"
#include "programs/setup_assistant/document/settings_document.h"
#include "programs/start/draft_inputs.h"
#include "programs/start/settings_draft.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

std::uint16_t portOf(const std::string& text) {
  const auto port = base::asInteger(text);
  if (port && *port >= 0 && *port <= 65535) return static_cast<std::uint16_t>(*port);
  throw Error("--port: found '" + text + "'; it should be 0 to 65535");
}

DraftInputs inputsOf(const std::vector<std::string>& bag_files) {
  DraftInputs inputs = readDraftInputs(bag_files, std::nullopt);
  inputs.formats = {"coco", "ultralytics"};
  for (const motion::RobotFrame& robot : motion::robotFrames(inputs.contents)) {
    inputs.objects.push_back({objectNameOf(robot), std::nullopt, 0.0});
  }
  return inputs;
}

}  // namespace

AssistantOptions parseAssistantLine(const std::vector<std::string>& arguments) {
  AssistantOptions options;
  bool has_file = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const auto next = [&]() -> const std::string& {
      if (i + 1 == arguments.size()) throw Error(argument + ": found nothing after it");
      return arguments[++i];
    };
    if (argument == "--help" || argument == "-h") {
      options.wants_help = true;
    } else if (argument == "--folder") {
      options.folders.push_back(next());
    } else if (argument == "--port") {
      options.port = portOf(next());
    } else if (argument == "--address") {
      options.address = next();
    } else if (argument == "--page") {
      options.page_folder = next();
    } else if (argument.rfind('-', 0) == 0) {
      throw Error("found '" + argument + "'; there is no such option");
    } else if (motion::isBagPath(argument)) {
      options.bag_files.push_back(argument);
    } else if (has_file) {
      throw Error("found '" + argument + "'; one settings file is enough");
    } else {
      options.file = argument;
      has_file = true;
    }
  }
  return options;
}

std::string assistantUsage() {
  return R"(usage: setup_assistant [FILE] [BAG...] [--folder DIR]... [--port N] [--address A]

Sets up a run in a browser: prints the page's address, and serves it until it is stopped.

  FILE       the settings file, by default settings.yaml; created if it does not exist
  BAG        recordings for a new FILE: .bag, .db3, .mcap, or a folder of ROS 2
  --folder   another folder that the page may read, besides those of FILE, of ROS packages and
             of models; once for each
  --port     by default any free port
  --address  the address to listen on, by default 127.0.0.1, which no other machine reaches
  --page     a folder with the page's files, for developers of the page
  --help     prints this

  setup_assistant rover.yaml rover.bag --folder /data/worlds

From another machine: ssh -L 8080:127.0.0.1:PORT HOST

Exit codes: 0 stopped by a signal, 1 a file cannot be read or written, or it cannot listen there.
)";
}

void makeSettingsFile(const AssistantOptions& options) {
  if (fs::exists(options.file)) {
    if (options.bag_files.empty()) return;
    throw Error("'" + options.file + "' already exists; bags are only for a new file");
  }
  const fs::path folder = fs::absolute(options.file).parent_path();
  if (!fs::is_directory(folder)) throw Error("'" + folder.string() + "': no such folder");
  if (options.bag_files.empty()) {
    writeWhole(options.file,
               "# Settings of synthetic_dataset; config/params.yaml documents every setting.\n");
  } else {
    writeWhole(options.file, draftSettings(inputsOf(options.bag_files)).text);
  }
}

}  // namespace synthetic_dataset::programs
