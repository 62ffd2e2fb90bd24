#include "plugins/readback/json_text.h"

#include <nlohmann/json.hpp>

namespace synthetic_dataset::formats {

std::string asJsonHasIt(const std::string& text) {
  using nlohmann::json;
  return json::parse(quotedInJson(text)).get<std::string>();
}

std::string quotedInJson(const std::string& text) {
  using nlohmann::json;
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace synthetic_dataset::formats
