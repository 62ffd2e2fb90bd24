#include "programs/console/command_line.h"

#include <exception>
#include <filesystem>
#include <iostream>
#include <utility>

#include "base/printable_text.h"
#include "config/settings_file.h"
#include "run/setup/package_index.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

const std::string kConfig = "--config";
const std::string kOut = "--out";

bool startsWith(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

class Parser {
 public:
  CommandLine parse(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) read(argument);
    if (awaited_) throw Error(*awaited_ + ": no name follows");
    if (result_.as_json && result_.wants_check) throw Error("--json: found with --check");
    if (result_.out && !result_.wants_check) throw Error("--out: found without --check");
    if (!result_.config) result_.settings.clear();  // remappings, which ROS reads
    for (const auto& [name, value] : result_.settings) {
      if (value.empty()) throw Error(name + ":=: no value follows ('' is an empty text)");
    }
    return result_;
  }

 private:
  void read(const std::string& argument) {
    const std::size_t sign = argument.find('=');
    const std::string name = argument.substr(0, sign);
    if (awaited_) {
      setName(*std::exchange(awaited_, std::nullopt), argument);
    } else if (argument == kConfig || argument == kOut) {
      awaited_ = argument;
    } else if (name == kConfig || name == kOut) {
      setName(name, argument.substr(sign + 1));
    } else if (argument == "--check") {
      result_.wants_check = true;
    } else if (argument == "--settings") {
      result_.wants_settings = true;
    } else if (argument == "--json") {
      result_.as_json = true;
    } else if (argument == "--help" || argument == "-h") {
      result_.wants_help = true;
    } else {
      readSetting(argument);
    }
  }

  void setName(const std::string& option, const std::string& name) {
    std::optional<std::string>& given = option == kConfig ? result_.config : result_.out;
    const std::string kind = option == kConfig ? "settings file" : "folder";
    if (name.empty()) throw Error(option + ": found an empty name; it should be a " + kind + "'s");
    if (given) throw Error(option + ": found '" + name + "', a second " + kind);
    given = name;
  }

  void readSetting(const std::string& argument) {
    const std::size_t sign = argument.find(":=");
    if (startsWith(argument, "-") || sign == std::string::npos) {
      throw Error("found '" + argument + "', which is neither an option nor name:=value");
    }
    // roslaunch passes every node its name and log file; they are not settings.
    if (startsWith(argument, "__")) return;
    if (sign == 0) throw Error("found '" + argument + "'; a name should stand before ':='");
    result_.settings.emplace_back(argument.substr(0, sign), argument.substr(sign + 2));
  }

  CommandLine result_;
  std::optional<std::string> awaited_;  ///< the option whose value comes next
};

}  // namespace

CommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  return Parser().parse(arguments);
}

CommandLine parseCheckLine(const std::vector<std::string>& arguments) {
  std::vector<std::string> as_of_generate = {"--check"};
  bool is_of_option = false;
  bool has_file = false;
  for (const std::string& argument : arguments) {
    const bool is_file = !is_of_option && !has_file && !startsWith(argument, "-") &&
                         argument.find(":=") == std::string::npos;
    if (is_file) as_of_generate.push_back(kConfig);
    has_file = has_file || is_file;
    is_of_option = argument == kOut;
    as_of_generate.push_back(argument);
  }
  const CommandLine line = parseCommandLine(as_of_generate);
  if (!line.config && !line.wants_help) throw Error("found no settings file; one is needed");
  return line;
}

std::string picturesFolder(const CommandLine& line) {
  if (line.out) return *line.out;
  const std::string beside = std::filesystem::path(line.config.value_or("")).parent_path().string();
  return beside.empty() ? "." : beside;
}

std::string usage() {
  return R"(usage: generate --config FILE [NAME:=VALUE ...] [--json | --check [--out DIR]]
       generate [ROS remappings] [--json | --check [--out DIR]]
       generate --settings [--json]
       generate --config FILE [NAME:=VALUE ...] --settings [--json]

Makes a dataset. With --config, the settings are those of a YAML file, as
config/params.yaml documents them, and no ROS master is needed; without it, they are
the node's private parameters.

  NAME:=VALUE  overrides the file: a setting's name, such as output_folder or
               shard/index, and its value in YAML ('' is an empty text)
  --check      makes no dataset: prints what the run would be and what is odd about it,
               and leaves check.png (some scenes with their labels) and map.png (the
               world from above) in DIR, or beside FILE
  --json       prints lines for scripts: with a FILE the run's progress, and at the end the result
               (done, stopped or failed), what was made, the warnings and the errors
  --settings   prints every setting with its default; with --json as a JSON schema. With a FILE:
               its settings, with presets and other short forms written out
  --help       prints this

  generate --config my.yaml output_folder:=/data/run_7

The same command again continues a stopped run.
Exit codes: 0 done (the last line says if labels are missing), 1 refused or failed,
128 + N after signal N (130 SIGINT, 143 SIGTERM, 129 SIGHUP); of --check, 3 if
something is odd.
)";
}

std::string checkUsage() {
  return R"(usage: check FILE [NAME:=VALUE ...] [--out DIR]

Looks at the run of a settings file before it is made: prints its times, scenes,
cameras and formats, how much disk, time and memory it takes, and what is odd about it,
each with its figure and a remedy. Makes about nine scenes, and no dataset. Leaves
check.png (these scenes with their labels) and map.png (the world, the paths of objects
and the cameras from above) in DIR, or beside FILE.

  NAME:=VALUE  overrides the file, as with generate
  --help       prints this

  check my.yaml --out /tmp/look

Exit codes: 0 nothing is odd, 3 something is, 1 the run is not possible.
)";
}

int reportingErrors(const std::string& name, const std::function<int()>& work) {
  try {
    return work();
  } catch (const ErrorList& errors) {
    for (const std::string& message : errors.messages())
      std::cerr << name << ": " << base::printable(message) << '\n';
  } catch (const std::exception& error) {
    std::cerr << name << ": " << base::printable(error.what()) << '\n';
  }
  return 1;
}

Value settingsOf(const CommandLine& command_line, const base::Remark& remark) {
  Value::Map settings = config::loadSettings(*command_line.config, run::rosPackageFinder(), remark);
  for (const auto& [name, text] : command_line.settings) {
    config::overrideBy(config::settingOf(name, text), settings);
  }
  return settings;
}

}  // namespace synthetic_dataset::programs
