#include "base/json_value.h"

#include <limits>

#include <nlohmann/json.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

Value textOrNumber(const std::string& text) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (text == ".inf") return kInfinity;
  if (text == "-.inf") return -kInfinity;
  if (text == ".nan") return std::numeric_limits<double>::quiet_NaN();
  return text;
}

Value valueOf(const nlohmann::json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_string()) return textOrNumber(json.get<std::string>());
  if (json.is_number_unsigned() &&
      json.get<std::uint64_t>() >
          static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return json.get<double>();
  }
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_array()) {
    Value::List list;
    for (const auto& entry : json) list.push_back(valueOf(entry));
    return list;
  }
  if (!json.is_object()) return {};
  Value::Map map;
  for (const auto& [name, entry] : json.items()) map[name] = valueOf(entry);
  return map;
}

}  // namespace

Value parseJson(const std::string& text, const std::string& origin) {
  try {
    return valueOf(nlohmann::json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw Error(origin + ": found no JSON: " + error.what());
  }
}

}  // namespace synthetic_dataset::base
