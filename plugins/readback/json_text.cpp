#include "plugins/readback/json_text.h"

#include <nlohmann/json.hpp>

namespace synthetic_dataset::formats {

std::string asJsonHasIt(const std::string& text) {
  using nlohmann::json;
  const std::string written = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return json::parse(written).get<std::string>();
}

}  // namespace synthetic_dataset::formats
