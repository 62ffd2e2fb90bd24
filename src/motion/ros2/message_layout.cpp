#include "motion/ros2/message_layout.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

constexpr std::size_t kLongestDefinition = 1U << 20U;  // [byte]
constexpr std::uint32_t kLargestFixedCount = 1U << 20U;
constexpr std::size_t kDeepest = 32;  // messages within messages

/// The canonical name of a number's type, and its size [byte].
struct NumberType {
  std::string type;
  std::size_t size = 0;
};

NumberType numberTypeOf(const std::string& type) {
  static const std::map<std::string, NumberType> kTypes = {
      {"bool", {"bool", 1}},       {"byte", {"uint8", 1}},    {"char", {"uint8", 1}},
      {"int8", {"int8", 1}},       {"uint8", {"uint8", 1}},   {"int16", {"int16", 2}},
      {"uint16", {"uint16", 2}},   {"int32", {"int32", 4}},   {"uint32", {"uint32", 4}},
      {"int64", {"int64", 8}},     {"uint64", {"uint64", 8}}, {"float32", {"float32", 4}},
      {"float64", {"float64", 8}},
  };
  const auto found = kTypes.find(type);
  return found == kTypes.end() ? NumberType{} : found->second;
}

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// A field as text: "float64[9] k".
std::string textOf(const FieldLayout& field) {
  std::string count;
  if (field.count == FieldLayout::Count::kList) count = "[]";
  if (field.count == FieldLayout::Count::kFixed) {
    count = "[" + std::to_string(field.fixed_count) + "]";
  }
  return field.type + count + " " + field.name;
}

/// Splits "float64[9]" and "string<=10[<=5]" into the type and the count.
void readType(std::string text, FieldLayout& field) {
  const std::size_t bracket = text.find('[');
  if (bracket != std::string::npos) {
    const std::string count = text.substr(bracket + 1, text.size() - bracket - 2);
    if (text.back() != ']') throw Error("its definition has the type '" + text + "'");
    const bool is_number = !count.empty() && count.size() < 8 &&
                           std::all_of(count.begin(), count.end(),
                                       [](unsigned char c) { return std::isdigit(c) != 0; });
    field.count = is_number ? FieldLayout::Count::kFixed : FieldLayout::Count::kList;
    if (is_number) field.fixed_count = static_cast<std::uint32_t>(std::stoul(count));
    if (is_number && (field.fixed_count == 0 || field.fixed_count > kLargestFixedCount)) {
      throw Error("its definition has the type '" + text + "'");
    }
    text.resize(bracket);
  }
  text = text.substr(0, text.find("<="));
  const NumberType number = numberTypeOf(text);
  field.number_size = number.size;
  field.type = number.size > 0 ? number.type : ros1TypeOf(text);
}

/// Reads the layouts of all types in a definition.
class LayoutReader {
 public:
  LayoutReader(const std::string& type, const std::string& definition) {
    if (definition.size() > kLongestDefinition) throw Error("its definition is too long to be one");
    std::istringstream lines(definition);
    std::string section = type;
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("====", 0) == 0) {
        section.clear();
      } else if (section.empty() && line.rfind("MSG: ", 0) == 0) {
        section = ros1TypeOf(line.substr(5, line.find_last_not_of(" \t\r") - 4));
      } else if (!section.empty()) {
        texts_[section] += line + "\n";
      }
    }
  }

  std::shared_ptr<const MessageLayout> layoutOf(const std::string& type) {
    const auto known = layouts_.find(type);
    if (known != layouts_.end()) return known->second;
    const auto text = texts_.find(type);
    if (text == texts_.end()) throw Error("its definition lacks the type " + type);
    if (!open_.insert(type).second) throw Error("its definition has " + type + " within itself");
    if (open_.size() > kDeepest) throw Error("its definition nests too deep");
    auto layout = std::make_shared<MessageLayout>();
    layout->type = type;
    std::istringstream lines(text->second);
    for (std::string line; std::getline(lines, line);) readLine(line, *layout);
    open_.erase(type);
    layouts_[type] = layout;
    return layout;
  }

 private:
  /// Reads a field "type name", with or without a default value; skips constants and comments.
  void readLine(const std::string& line, MessageLayout& layout) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string type;
    FieldLayout field;
    if (!(words >> type)) return;
    if (!(words >> field.name)) throw Error("its definition has the line '" + line + "'");
    std::string rest;
    std::getline(words, rest);
    const std::size_t value = rest.find_first_not_of(" \t");
    const bool is_constant = field.name.find('=') != std::string::npos ||
                             (value != std::string::npos && rest[value] == '=');
    if (is_constant) return;
    readType(type, field);
    std::uint64_t least = field.number_size;
    if (field.type == "wstring") throw Error("has wide texts (wstring), which are not read");
    if (field.type == "string") least = sizeof(std::uint32_t);
    if (least == 0) {
      if (field.type == "Header") field.type = "std_msgs/Header";
      if (field.type.find('/') == std::string::npos) {
        field.type = layout.type.substr(0, layout.type.find('/') + 1) + field.type;
      }
      field.message = layoutOf(field.type);
      least = field.message->least_size;
    }
    if (field.count == FieldLayout::Count::kFixed) least *= field.fixed_count;
    if (field.count == FieldLayout::Count::kList) least = sizeof(std::uint32_t);
    layout.least_size += least;
    if (layout.least_size > std::numeric_limits<std::uint32_t>::max()) {
      throw Error("its definition makes a message too long to be one");
    }
    layout.fields.push_back(std::move(field));
  }

  std::map<std::string, std::string> texts_;
  std::map<std::string, std::shared_ptr<const MessageLayout>> layouts_;
  std::set<std::string> open_;
};

}  // namespace

std::string ros1TypeOf(const std::string& ros2_type) {
  const std::size_t middle = ros2_type.find("/msg/");
  if (middle == std::string::npos) return ros2_type;
  return ros2_type.substr(0, middle) + ros2_type.substr(middle + 4);
}

std::shared_ptr<const MessageLayout> parseLayout(const std::string& type,
                                                 const std::string& definition) {
  return LayoutReader(type, definition).layoutOf(type);
}

std::string differenceOf(const MessageLayout& found, const MessageLayout& known) {
  const std::size_t count = std::max(found.fields.size(), known.fields.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::string here = i < found.fields.size() ? textOf(found.fields[i]) : "nothing";
    const std::string wanted = i < known.fields.size() ? textOf(known.fields[i]) : "nothing";
    if (lowerCase(here) != lowerCase(wanted)) {
      return known.type + " has '" + here + "' for '" + wanted + "'";
    }
    if (!known.fields[i].message) continue;
    std::string inner = differenceOf(*found.fields[i].message, *known.fields[i].message);
    if (!inner.empty()) return inner;
  }
  return "";
}

}  // namespace synthetic_dataset::motion
