/// The tool `start`: writes a settings file for a recording.
///
///   rosrun synthetic_dataset start BAG... [--world WORLD] [--model NAME=FILE ...] [-o FILE]
///
/// Exit code 0, even with gaps, which are marked; 1 when a file cannot be read or written.

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "base/name_list.h"
#include "base/printable_text.h"
#include "plugins/readback/format.h"
#include "programs/console/command_line.h"
#include "programs/start/draft_inputs.h"
#include "programs/start/settings_draft.h"
#include "programs/start/start_line.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace {

using namespace synthetic_dataset;
namespace fs = std::filesystem;

bool isOnTerminal() { return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1; }

/// Returns the user's answer, or the default if it is empty.
std::string ask(const std::string& question, const std::string& fallback) {
  std::cerr << question << " [" << fallback << "] " << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  return answer.empty() ? fallback : answer;
}

void addObjects(const programs::StartLine& line, programs::DraftInputs& inputs) {
  for (const auto& [name, model] : line.models) {
    inputs.objects.push_back(programs::objectOf(name, model));
  }
  if (!inputs.objects.empty()) return;
  std::vector<std::string> names;
  for (const motion::RobotFrame& robot : motion::robotFrames(inputs.contents)) {
    names.push_back(programs::objectNameOf(robot));
  }
  if (isOnTerminal()) {
    names = programs::wordsIn(ask("Which objects are labelled?", base::listed(names)));
  }
  for (const std::string& name : names) {
    inputs.objects.push_back({name, std::nullopt, 0.0});
    if (!isOnTerminal()) continue;
    const std::string model = ask("The model of " + name + " (URDF, xacro or SDF)?", "leave open");
    if (model == "leave open") continue;
    inputs.objects.back() = programs::objectOf(name, model);
  }
}

std::vector<std::string> formatsOf(const programs::StartLine& line) {
  std::vector<std::string> formats = {"coco", "ultralytics"};
  std::vector<std::string> known;
  for (const auto& [name, type] : formats::formatNames()) known.push_back(name);
  if (line.formats) {
    formats = *line.formats;
  } else if (isOnTerminal()) {
    formats = programs::wordsIn(
        ask("Which formats (of " + base::listed(known) + ")?", base::listed(formats)));
  }
  for (const std::string& format : formats) {
    if (std::find(known.begin(), known.end(), format) != known.end()) continue;
    throw Error("--formats: found '" + format + "'; it should be of " + base::listed(known) +
                didYouMean(format, known));
  }
  return formats;
}

/// Writes a file, but never over an existing one.
void writeNew(const std::string& file, const std::string& text) {
  if (fs::exists(fs::symlink_status(file))) {
    throw Error("-o: '" + file + "' already exists; choose another name");
  }
  std::ofstream stream(file);
  if (!(stream << text << std::flush)) throw Error("-o: '" + file + "' cannot be written");
}

int start(const programs::StartLine& line) {
  programs::DraftInputs inputs = programs::readDraftInputs(line.bag_files, line.world);
  if (line.camera_info) inputs.camera_info = programs::absoluteFile(*line.camera_info);
  addObjects(line, inputs);
  inputs.formats = formatsOf(line);
  const programs::SettingsDraft draft = programs::draftSettings(inputs);
  if (line.output) {
    writeNew(*line.output, draft.text);
    std::cerr << "start: wrote " << *line.output << '\n';
  } else {
    std::cout << draft.text;
  }
  for (const std::string& gap : draft.gaps)
    std::cerr << "start: TODO: " << base::printable(gap) << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  programs::StartLine line;
  try {
    line = programs::parseStartLine({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "start: " << base::printable(error.what()) << '\n' << programs::startUsage();
    return 1;
  }
  if (line.wants_help) {
    std::cout << programs::startUsage();
    return 0;
  }
  return programs::reportingErrors("start", [&] { return start(line); });
}
