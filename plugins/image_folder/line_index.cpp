#include "plugins/image_folder/line_index.h"

#include <fstream>

#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::image_folder {

using nlohmann::json;

LineIndex::LineIndex(const std::filesystem::path& file) : file_(file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("'" + file.string() + "': cannot be read");
  std::int64_t begin = 0;
  readingJson(file, [&] {
    for (std::string text; std::getline(stream, text);) {
      if (!text.empty()) {
        begins_.emplace(json::parse(text).at("file_name").get<std::string>(), begin);
        ++count_;
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

}  // namespace synthetic_dataset::formats::image_folder
