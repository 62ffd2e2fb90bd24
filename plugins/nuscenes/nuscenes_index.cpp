#include "plugins/nuscenes/nuscenes_index.h"

#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::nuscenes {

using nlohmann::json;

TokenTable::TokenTable(const std::filesystem::path& file) : file_(file) {
  readJson(file, [&](const json& table) {
    for (const json& each : table) records_[each.at("token").get<std::string>()] = each;
  });
}

const json& TokenTable::at(const std::string& token) const {
  const auto found = records_.find(token);
  if (found == records_.end()) {
    throw Error("'" + file_.string() + "': no record has the token '" + token + "'");
  }
  return found->second;
}

RecordsByKey::RecordsByKey(const std::filesystem::path& file, const char* key) {
  readJson(file, [&](const json& table) {
    for (const json& each : table) records_.emplace(each.at(key).get<std::string>(), each);
  });
}

std::vector<json> RecordsByKey::of(const std::string& text) const {
  std::vector<json> found;
  const auto [begin, end] = records_.equal_range(text);
  for (auto each = begin; each != end; ++each) found.push_back(each->second);
  return found;
}

}  // namespace synthetic_dataset::formats::nuscenes
