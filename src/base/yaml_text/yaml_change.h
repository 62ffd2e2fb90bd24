#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// A step into a map by name, or into a list by index.
using YamlStep = std::variant<std::string, std::size_t>;
using YamlPath = std::vector<YamlStep>;

/// A path for messages: "camera/pose/0".
[[nodiscard]] std::string pathText(const YamlPath& path);

/// The value at a path; nullptr if there is none.
[[nodiscard]] const Value* valueAt(const Value& tree, const YamlPath& path);

/// Sets a value: missing groups are created, and what is not a group is replaced by one; the index
/// after a list's last appends to it.
/// @throws Error for an index beyond that
void setValue(Value& tree, const YamlPath& path, const Value& value);

/// Removes a value, and the groups that are then empty; does nothing if there is no value.
void removeValue(Value& tree, const YamlPath& path);

/// Whether two trees mean the same: 3 equals 3.0, NaN equals NaN, an angle's text equals its value,
/// and null equals an empty group.
[[nodiscard]] bool saysTheSame(const Value& a, const Value& b);

/// The outermost entries in which two trees differ; lists of different lengths differ as a whole.
[[nodiscard]] std::vector<YamlPath> differences(const Value& a, const Value& b);

}  // namespace synthetic_dataset::base
