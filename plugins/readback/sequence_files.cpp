#include "plugins/readback/sequence_files.h"

#include <algorithm>

#include "plugins/readback/files.h"
#include "plugins/shared/sequences.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {

FrameList::FrameList(const std::filesystem::path& file) : file_(file) {
  for (const std::string& line : readLines(file)) {
    const std::size_t first = line.find(' ');
    const std::size_t second = line.find(' ', std::min(first, line.size() - 1) + 1);
    if (first == std::string::npos || second == std::string::npos) {
      throw Error("'" + file.string() + "': found the line '" + line + "'");
    }
    const std::string number = line.substr(first + 1, second - first - 1);
    const std::string zeros(6 - std::min<std::size_t>(number.size(), 6), '0');
    frames_[line.substr(second + 1)] = {line.substr(0, first), number, zeros + number};
  }
}

const SequenceFrame& FrameList::of(const std::string& image) const {
  const auto found = frames_.find(image);
  if (found == frames_.end()) {
    throw Error("'" + file_.string() + "': it does not list '" + image + "'");
  }
  return found->second;
}

SequenceLabels::SequenceLabels(const std::filesystem::path& file) : file_(file) {
  for (std::string line : readLines(file)) {
    const std::size_t end_of_frame = line.find_first_of(", ");
    const bool has_commas = end_of_frame != std::string::npos && line[end_of_frame] == ',';
    if (has_commas) std::replace(line.begin(), line.end(), ',', ' ');
    std::vector<std::string> words = wordsOf(line);
    if (words.empty()) continue;
    const std::string frame = words.front();
    words.erase(words.begin());
    lines_[frame].push_back(std::move(words));
  }
}

const std::vector<std::vector<std::string>>& SequenceLabels::of(const SequenceFrame& frame,
                                                                std::size_t columns) const {
  static const std::vector<std::vector<std::string>> kNone;
  const auto found = lines_.find(frame.number);
  if (found == lines_.end()) return kNone;
  for (const std::vector<std::string>& words : found->second) {
    if (words.size() == columns) continue;
    throw Error("'" + file_.string() + "': found a line of " + std::to_string(words.size() + 1) +
                " columns");
  }
  return found->second;
}

SequenceFrame frameOf(const WrittenScene& scene, const std::filesystem::path& image) {
  const auto list = scene.kept->get<FrameList>(scene.folder / kFrameList);
  return list->of(image.lexically_relative(scene.folder).string());
}

}  // namespace synthetic_dataset::formats
