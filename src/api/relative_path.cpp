#include "synthetic_dataset/relative_path.h"

#include <algorithm>

namespace synthetic_dataset {
inline namespace v2 {
namespace {

constexpr std::size_t kLongestName = 255;  // NAME_MAX [bytes]

bool isControl(char character) {
  const auto code = static_cast<unsigned char>(character);
  return code < 0x20 || code == 0x7F;
}

/// Whether temporaryPath() could have made this name.
bool isTemporaryName(std::string_view name) {
  constexpr std::string_view kEnd = ".tmp";
  return name.size() > kEnd.size() && name.front() == '.' &&
         name.substr(name.size() - kEnd.size()) == kEnd;
}

std::optional<std::string> partProblem(std::string_view part) {
  if (part.empty()) return "it has an empty part";
  if (part == "." || part == "..") return "it may not have '.' or '..' as a part";
  if (part.size() > kLongestName) return "a part of it is longer than 255 bytes";
  if (isTemporaryName(part)) return "names like '.x.tmp' are reserved for files being written";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> relativePathProblem(std::string_view path) {
  if (path.empty()) return "it is empty";
  if (path.front() == '/') return "it should be relative to the writer's output folder";
  if (std::any_of(path.begin(), path.end(), isControl)) return "it has a control character";
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    if (auto problem = partProblem(path.substr(begin, end - begin))) return problem;
    begin = end + 1;
  }
  return std::nullopt;
}

}  // namespace v2
}  // namespace synthetic_dataset
