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

/// The value at a path; nullptr where there is none.
[[nodiscard]] const Value* valueAt(const Value& tree, const YamlPath& path);

/// Sets a value: missing groups are made, and what is not a group is replaced by one; the index
/// behind a list's last appends to it.
/// @throws Error for an index further behind
void setValue(Value& tree, const YamlPath& path, const Value& value);

/// Removes a value, and the groups that are empty then; nothing happens where there is none.
void removeValue(Value& tree, const YamlPath& path);

/// Whether two trees say the same: 3 is 3.0, not-a-number is itself, an angle's text its value,
/// and nothing an empty group.
[[nodiscard]] bool saysTheSame(const Value& a, const Value& b);

/// The entries of two trees that differ, none of them within another: of lists of different
/// lengths, the lists.
[[nodiscard]] std::vector<YamlPath> differences(const Value& a, const Value& b);

}  // namespace synthetic_dataset::base
