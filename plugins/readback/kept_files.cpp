#include "plugins/readback/kept_files.h"

#include <fstream>

#include "plugins/readback/format_readers.h"
#include "plugins/readback/json_file.h"

namespace synthetic_dataset::readback {

using nlohmann::json;

LineIndex::LineIndex(const std::filesystem::path& file) : file_(file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("'" + file.string() + "': cannot be read");
  std::int64_t begin = 0;
  readingJson(file, [&] {
    for (std::string text; std::getline(stream, text);) {
      if (!text.empty()) {
        begins_.emplace(json::parse(text).at("file_name").get<std::string>(), begin);
      }
      begin += static_cast<std::int64_t>(text.size()) + 1;
    }
  });
}

json LineIndex::line(const std::string& file_name) const {
  const auto found = begins_.find(file_name);
  if (found == begins_.end()) {
    throw Error("'" + file_.string() + "': no line of '" + file_name + "'");
  }
  std::ifstream stream(file_, std::ios::binary);
  std::string text;
  if (!stream.seekg(found->second) || !std::getline(stream, text)) {
    throw Error("'" + file_.string() + "': cannot be read");
  }
  return readingJson(file_, [&] { return json::parse(text); });
}

const json& KeptFiles::document(const std::filesystem::path& file) {
  constexpr std::size_t kMost = 64;  // three a camera are in use at a time
  const auto found = documents.find(file);
  if (found != documents.end()) return found->second;
  if (documents.size() >= kMost) documents.clear();
  return documents[file] = readJson(file, [](const json& content) { return content; });
}

std::shared_ptr<KeptFiles> keptFiles() { return std::make_shared<KeptFiles>(); }

std::shared_ptr<KeptFiles> keptFilesOf(const WrittenScene& scene) {
  return scene.kept ? scene.kept : keptFiles();
}

}  // namespace synthetic_dataset::readback
