#pragma once

#include <array>
#include <stdexcept>
#include <string>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "base/nesting.h"
#include "plugins/shared/ordered_map.h"
#include "synthetic_dataset/box.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset {

/// Keys are written in the order in which they were added.
using Json = nlohmann::basic_json<OrderedMap>;

/// JSON that is not as expected, or is nested too deep to be read.
class UnfitJson : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses a text. Use nothing else to parse JSON, as texts may come from anybody.
/// @throws UnfitJson if it is nested too deep, nlohmann's exception if it is not JSON
template <class AnyJson>
[[nodiscard]] AnyJson parsedJson(const std::string& text) {
  if (base::isDeepJson(text)) throw UnfitJson(base::kNestedTooDeep);
  return AnyJson::parse(text);
}

/// The same, but returns a `discarded` value if the text cannot be parsed.
[[nodiscard]] inline nlohmann::json jsonIfAny(const std::string& text) {
  if (base::isDeepJson(text)) return {nlohmann::json::value_t::discarded};
  return nlohmann::json::parse(text, nullptr, false);
}

/// Writes JSON on one line. Bytes that are not UTF-8 become U+FFFD, as JSON has to be UTF-8.
[[nodiscard]] inline std::string jsonText(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Writes JSON on several lines, so that people can read it too.
[[nodiscard]] inline std::string indentedJson(const Json& value) {
  constexpr int kIndent = 2;
  return value.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

[[nodiscard]] inline Json numbersOf(const Eigen::Vector3d& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

/// [x, y, width, height] as in COCO, in pixels of an image that spans 0 to its width.
[[nodiscard]] inline Json cocoBox(const Box& box) {
  return {box.left + 0.5, box.top + 0.5, box.width(), box.height()};
}

/// A pose's 4 x 4 matrix, row by row.
[[nodiscard]] inline Json jsonMatrix(const Pose& pose) {
  Json numbers = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) numbers.push_back(pose.matrix()(row, column));
  }
  return numbers;
}

}  // namespace synthetic_dataset
