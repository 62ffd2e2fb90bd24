#include "programs/embedded/embedded_files.h"

#include <filesystem>
#include <map>
#include <utility>

#include "base/input_file.h"
#include "programs/embedded/embedded_files_content.h"

namespace synthetic_dataset::programs {

EmbeddedFiles::EmbeddedFiles(std::string folder) : folder_(std::move(folder)) {}

std::optional<std::string> EmbeddedFiles::find(const std::string& name) const {
  if (!folder_.empty()) {
    const bool is_name = !name.empty() && name.find('/') == std::string::npos;
    const auto file = std::filesystem::path(folder_) / name;
    if (is_name && std::filesystem::is_regular_file(file)) return base::readInput(file);
  }
  for (const EmbeddedFile& each : kEmbeddedFiles) {
    if (each.name == name) return std::string(each.content);
  }
  return std::nullopt;
}

std::string mediaTypeOf(const std::string& name) {
  static const std::map<std::string, std::string> kTypes = {
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".svg", "image/svg+xml"}};
  const auto type = kTypes.find(std::filesystem::path(name).extension().string());
  return type == kTypes.end() ? "text/plain; charset=utf-8" : type->second;
}

}  // namespace synthetic_dataset::programs
