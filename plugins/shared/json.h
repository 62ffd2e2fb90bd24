#pragma once

#include <array>
#include <string>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "plugins/shared/ordered_map.h"
#include "synthetic_dataset/box.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset {

/// Keys are written in the order in which they were added.
using Json = nlohmann::basic_json<OrderedMap>;

/// On one line. Bytes of a name that are not UTF-8 become U+FFFD, as JSON has to be UTF-8.
[[nodiscard]] inline std::string jsonText(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// On several lines, for people to read too.
[[nodiscard]] inline std::string indentedJson(const Json& value) {
  constexpr int kIndent = 2;
  return value.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

[[nodiscard]] inline Json numbersOf(const Eigen::Vector3d& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

/// [x, y, width, height] as COCO has it, in pixels of an image that spans 0 to its width.
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
