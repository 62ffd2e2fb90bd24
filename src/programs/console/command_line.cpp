#include "programs/console/command_line.h"

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

const std::string kConfig = "--config";

bool startsWith(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

class Parser {
 public:
  CommandLine parse(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) read(argument);
    if (file_is_next_) throw Error("--config: no file follows");
    if (!result_.config) result_.settings.clear();  // remappings, which ROS reads
    for (const auto& [name, value] : result_.settings) {
      if (value.empty()) throw Error(name + ":=: no value follows ('' is an empty text)");
    }
    return result_;
  }

 private:
  void read(const std::string& argument) {
    if (file_is_next_) {
      setConfig(argument);
      file_is_next_ = false;
    } else if (argument == kConfig) {
      file_is_next_ = true;
    } else if (startsWith(argument, kConfig + "=")) {
      setConfig(argument.substr(kConfig.size() + 1));
    } else if (argument == "--help" || argument == "-h") {
      result_.wants_help = true;
    } else {
      readSetting(argument);
    }
  }

  void setConfig(const std::string& file) {
    if (file.empty()) throw Error("--config: found an empty name; it should be a file's");
    if (result_.config) throw Error("--config: found '" + file + "', a second settings file");
    result_.config = file;
  }

  void readSetting(const std::string& argument) {
    const std::size_t sign = argument.find(":=");
    if (startsWith(argument, "-") || sign == std::string::npos) {
      throw Error("found '" + argument + "', which is neither an option nor name:=value");
    }
    // roslaunch tells every node its name and log file; they are no settings.
    if (startsWith(argument, "__")) return;
    if (sign == 0) throw Error("found '" + argument + "'; a name should stand before ':='");
    result_.settings.emplace_back(argument.substr(0, sign), argument.substr(sign + 2));
  }

  CommandLine result_;
  bool file_is_next_ = false;
};

}  // namespace

CommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  return Parser().parse(arguments);
}

std::string usage() {
  return "usage: generate --config FILE [NAME:=VALUE ...]\n"
         "       generate [ROS remappings]\n"
         "\n"
         "Makes a dataset. With --config, the settings are those of a YAML file, as\n"
         "config/params.yaml documents them, and no ROS master is needed; without it, they are\n"
         "the node's private parameters.\n"
         "\n"
         "  NAME:=VALUE  stands over the file: a setting's name, such as output_folder or\n"
         "               shard/index, and its value in YAML ('' is an empty text)\n"
         "  --help       prints this\n"
         "\n"
         "The same command again goes on where a run was stopped.\n"
         "Exit codes: 0 done, 1 failed, 128 + N after signal N (130 SIGINT, 143 SIGTERM,\n"
         "129 SIGHUP).\n";
}

}  // namespace synthetic_dataset::programs
