#include "programs/start/start_line.h"

#include <algorithm>

#include "plugins/readback/format.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

void setOnce(std::optional<std::string>& value, const std::string& option,
             const std::string& text) {
  if (value) throw Error(option + ": found '" + text + "', a second one");
  value = text;
}

void addModel(const std::string& text, StartLine& line) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) {
    throw Error("--model: found '" + text + "'; it should be NAME=FILE, such as husky=husky.urdf");
  }
  line.models.emplace_back(text.substr(0, sign), text.substr(sign + 1));
}

void setOption(const std::string& option, const std::string& text, StartLine& line) {
  if (text.empty()) throw Error(option + ": found an empty text");
  if (option == "--world") setOnce(line.world, option, text);
  if (option == "--camera") setOnce(line.camera_info, option, text);
  if (option == "-o") setOnce(line.output, option, text);
  if (option == "--formats") line.formats = wordsIn(text);
  if (option == "--model") addModel(text, line);
}

}  // namespace

std::vector<std::string> wordsIn(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text + ",") {
    if (c != ',' && c != ' ' && c != '\t') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(word);
      word.clear();
    }
  }
  return words;
}

StartLine parseStartLine(const std::vector<std::string>& arguments) {
  static const std::vector<std::string> kOptions = {"--world", "--camera", "--model", "--formats",
                                                    "-o"};
  StartLine line;
  std::string awaiting;
  for (const std::string& argument : arguments) {
    const std::string name = argument.substr(0, argument.find('='));
    if (!awaiting.empty()) {
      setOption(awaiting, argument, line);
      awaiting.clear();
    } else if (argument == "--help" || argument == "-h") {
      line.wants_help = true;
    } else if (std::find(kOptions.begin(), kOptions.end(), argument) != kOptions.end()) {
      awaiting = argument;
    } else if (name != argument &&
               std::find(kOptions.begin(), kOptions.end(), name) != kOptions.end()) {
      setOption(name, argument.substr(name.size() + 1), line);
    } else if (argument.empty() || argument.front() == '-') {
      throw Error("found '" + argument + "', which is not an option");
    } else {
      line.bag_files.push_back(argument);
    }
  }
  if (!awaiting.empty()) throw Error(awaiting + ": nothing follows");
  if (line.bag_files.empty() && !line.wants_help) throw Error("found no bag; one is needed");
  return line;
}

std::string startUsage() {
  std::string formats;
  for (const auto& [name, type] : formats::formatNames()) {
    constexpr std::size_t kLineEnd = 66;  // the list's lines are broken before this column
    const std::size_t begin = formats.rfind('\n') == std::string::npos ? 0 : formats.rfind('\n');
    const bool is_full = formats.size() - begin + name.size() > kLineEnd;
    formats += (formats.empty() ? "" : is_full ? ",\n                     " : ", ") + name;
  }
  return R"(usage: start BAG... [--world WORLD] [--model NAME=FILE ...] [--camera INFO]
             [--formats LIST] [-o FILE]

Writes a settings file for a recording, of ROS 1 or ROS 2, with comments: the shortest
that runs. What the recording does not say is marked with TODO, in the file and at the
end.

  --world WORLD      an SDF world; without it, a plain ground and the sun
  --model NAME=FILE  an object to label, by the name that it has in the recording
                     (jackal of jackal/base_link), and its URDF, xacro or SDF model
  --camera INFO      a calibration; without it, the recorded one, or a pinhole
  --formats LIST     such as coco,yolo (default: coco,ultralytics); of
                     )" +
         formats + R"(
  -o FILE            where the settings go, never over a file; else to the standard
                     output
  --help             prints this

On a terminal, it asks what it cannot infer; elsewhere it asks nothing.

  start my.bag --model husky=husky.urdf -o my.yaml && generate --config my.yaml

Exit codes: 0 done, also with TODOs; 1 a file cannot be read or written.
)";
}

}  // namespace synthetic_dataset::programs
