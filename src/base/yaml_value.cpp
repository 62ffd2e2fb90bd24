#include "base/yaml_value.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include "base/angle_expression.h"
#include "base/input_file.h"
#include "base/nesting.h"
#include "base/yaml_scalar.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

/// How many values and characters a text may grow to through its aliases, which multiply: this many
/// times its own length, but at least kSmallContent.
constexpr std::size_t kMostGrowth = 16;
constexpr std::size_t kSmallContent = 1U << 20U;

const std::string kYamlTag = "tag:yaml.org,2002:";

enum class Rules { kAnyFile, kSettings };

/// yaml-cpp marks quoted text with "!" and untagged values with "?".
bool isUntagged(const YAML::Node& node) { return node.Tag().empty() || node.Tag() == "?"; }

bool isMergeKey(const YAML::Node& key) {
  return key.IsScalar() && isUntagged(key) && key.Scalar() == "<<";
}

class Reader {
 public:
  using Entry = std::pair<YAML::Node, YAML::Node>;

  Reader(Rules rules, const std::string& text, const std::string& origin, const Remark& remark)
      : rules_(rules),
        origin_(origin),
        remark_(remark),
        content_left_(std::max(kSmallContent, kMostGrowth * text.size())) {}

  Value convert(const YAML::Node& node, int depth = 0) {
    checkSize(node, depth);
    switch (node.Type()) {
      case YAML::NodeType::Scalar:
        return scalar(node);
      case YAML::NodeType::Sequence:
        return list(node, depth);
      case YAML::NodeType::Map:
        return map(node, depth);
      default:
        if (rules_ == Rules::kSettings && depth > 0) {
          fail(node.Mark(),
               "found nothing (null); it should have a value ({} is an empty group, '' an empty "
               "text)");
        }
        return {};
    }
  }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
    throw Error(placeOf(mark) + ": " + message);
  }

 private:
  [[nodiscard]] std::string placeOf(const YAML::Mark& mark) const {
    return mark.line >= 0 ? origin_ + ": line " + std::to_string(mark.line + 1) : origin_;
  }

  void checkSize(const YAML::Node& node, int depth) {
    if (depth > kDeepestNesting) {
      fail(node.Mark(), std::string(kNestedTooDeep) + " (does it contain itself?)");
    }
    take(1 + (node.IsScalar() ? node.Scalar().size() : 0), node.Mark());
  }

  void take(std::size_t content, const YAML::Mark& mark) {
    if (content > content_left_) fail(mark, "its aliases multiply without bound");
    content_left_ -= content;
  }

  Value list(const YAML::Node& node, int depth) {
    checkTag(node, "seq");
    Value::List list;
    for (const YAML::Node& entry : node) list.push_back(convert(entry, depth + 1));
    return list;
  }

  Value map(const YAML::Node& node, int depth) {
    checkTag(node, "map");
    Value::Map map;
    for (const Entry& entry : entries(node, depth)) {
      map[name(entry.first)] = convert(entry.second, depth + 1);
    }
    return map;
  }

  /// In files other than settings, tags of other collections (sets, objects) are ignored.
  void checkTag(const YAML::Node& node, const std::string& kind) const {
    if (rules_ == Rules::kAnyFile || isUntagged(node) || node.Tag() == "!") return;
    if (node.Tag() != kYamlTag + kind) failForTag(node);
  }

  /// A map's entries in order: those that `<<` merges come before its own, so that its own override
  /// them (https://yaml.org/type/merge.html).
  std::vector<Entry> entries(const YAML::Node& map, int depth) {
    checkSize(map, depth);
    std::vector<Entry> merged;
    std::vector<Entry> own;
    for (const auto& entry : map) {
      if (isMergeKey(entry.first)) {
        merge(entry.second, depth, merged);
      } else {
        own.emplace_back(entry.first, entry.second);
      }
    }
    if (remark_) remarkRepeated(own);
    take(merged.size(), map.Mark());
    merged.insert(merged.end(), own.begin(), own.end());
    return merged;
  }

  /// As in PyYAML, the last of two equal names counts; the first is lost.
  void remarkRepeated(const std::vector<Entry>& entries) const {
    std::map<std::string, YAML::Mark> seen;
    for (const auto& [key, value] : entries) {
      if (!key.IsScalar()) continue;
      const auto [first, is_new] = seen.emplace(key.Scalar(), key.Mark());
      if (is_new) continue;
      remark_(placeOf(key.Mark()) + ": found '" + key.Scalar() +
              "' a second time; its value in line " + std::to_string(first->second.line + 1) +
              " is ignored");
      first->second = key.Mark();
    }
  }

  /// If several maps in a list have the same name, the first one counts.
  void merge(const YAML::Node& source, int depth, std::vector<Entry>& merged) {
    std::vector<YAML::Node> maps;
    if (source.IsMap()) maps.push_back(source);
    if (source.IsSequence()) {
      for (const YAML::Node& each : source) maps.push_back(each);
    }
    if (maps.empty() && !source.IsSequence()) fail(source.Mark(), "'<<' should merge a group");
    for (auto map = maps.rbegin(); map != maps.rend(); ++map) {
      if (!map->IsMap()) fail(map->Mark(), "'<<' should merge groups");
      const std::vector<Entry> found = entries(*map, depth + 1);
      merged.insert(merged.end(), found.begin(), found.end());
    }
  }

  std::string name(const YAML::Node& key) const {
    if (!key.IsScalar()) fail(key.Mark(), "a name should be a text");
    const std::string& text = key.Scalar();
    if (rules_ == Rules::kSettings && !scalar(key).is<std::string>()) {
      fail(key.Mark(),
           "found the name " + text + ", which YAML does not read as a text; put it in quotes");
    }
    return text;
  }

  [[nodiscard]] Value scalar(const YAML::Node& node) const {
    const std::string& text = node.Scalar();
    const std::string& tag = node.Tag();
    if (tag == "!" || tag == kYamlTag + "str") return text;
    if (isUntagged(node)) {
      return rules_ == Rules::kSettings ? untaggedSetting(node) : plainScalar(text);
    }
    return rules_ == Rules::kSettings ? taggedSetting(node) : plainScalar(text);
  }

  [[nodiscard]] Value untaggedSetting(const YAML::Node& node) const {
    const std::string& text = node.Scalar();
    if (isTimestamp(text)) {
      fail(node.Mark(),
           "found the date " + text + ", which settings cannot hold; put it in quotes");
    }
    // rosparam's patterns are ^deg\([^\)]*\)$ and ^rad\([^\)]*\)$.
    const bool closes_once = !text.empty() && text.find(')') == text.size() - 1;
    if (closes_once && text.rfind("deg(", 0) == 0) return angle(node, degrees);
    if (closes_once && text.rfind("rad(", 0) == 0) return angle(node, radians);
    return plainScalar(text);
  }

  [[nodiscard]] Value taggedSetting(const YAML::Node& node) const {
    const std::string& text = node.Scalar();
    const std::string& tag = node.Tag();
    if (tag == "!degrees") return angle(node, degrees);
    if (tag == "!radians") return angle(node, radians);
    if (tag == kYamlTag + "bool") {
      if (const auto value = asBool(text)) return *value;
    } else if (tag == kYamlTag + "int") {
      if (const auto value = asInteger(text)) return *value;
    } else if (tag == kYamlTag + "float") {
      if (const auto value = asFloat(text)) return *value;
      if (const auto value = decimalNumber(text)) return *value;
    }
    failForTag(node);
  }

  /// @param unit  degrees or radians, which read the text between the parentheses, if there are any
  [[nodiscard]] double angle(const YAML::Node& node, double (*unit)(const std::string&)) const {
    std::string text = node.Scalar();
    const std::string start = unit == degrees ? "deg(" : "rad(";
    if (text.rfind(start, 0) == 0 && text.back() == ')') {
      text = text.substr(start.size(), text.size() - start.size() - 1);
    }
    try {
      return unit(text);
    } catch (const Error& error) {
      fail(node.Mark(), error.what());
    }
  }

  [[noreturn]] void failForTag(const YAML::Node& node) const {
    std::string tag = node.Tag();
    if (tag.rfind(kYamlTag, 0) == 0) tag = "!!" + tag.substr(kYamlTag.size());
    std::string found = "found " + tag;
    if (node.IsScalar()) found += " '" + node.Scalar().substr(0, 80) + "'";
    fail(node.Mark(), found + ", which settings cannot hold");
  }

  Rules rules_;
  const std::string& origin_;
  const Remark& remark_;
  std::size_t content_left_;
};

/// yaml-cpp lets the end of a file close an open quote, but not the end of a document.
std::string withEndMark(const std::string& text) {
  const bool is_at_line_start = text.empty() || text.back() == '\n';
  return is_at_line_start ? text + "...\n" : text;
}

/// Remembers where the last parsed document begins, and aborts the parsing of one that nests too
/// deep.
class DocumentStart : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& place) override { mark = place; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {}
  void OnSequenceStart(const YAML::Mark& place, const std::string& /*tag*/,
                       YAML::anchor_t /*anchor*/, YAML::EmitterStyle::value /*style*/) override {
    enter(place);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& place, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {
    enter(place);
  }
  void OnMapEnd() override { --depth_; }

  YAML::Mark mark;

 private:
  void enter(const YAML::Mark& place) {
    if (++depth_ > kDeepestNesting) throw YAML::ParserException(place, kNestedTooDeep);
  }

  int depth_ = 0;
};

/// Where a second document begins, if there is one. (YAML::LoadAll never returns for a stray ',' or
/// '}', from which it makes one empty document after another.)
/// @throws YAML::Exception if the first one cannot be read, or nests too deep for YAML::Load
std::optional<YAML::Mark> secondDocument(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStart start;
  if (!parser.HandleNextDocument(start) || !parser.HandleNextDocument(start)) return std::nullopt;
  return start.mark;
}

/// The number of the first line with a tab in its indentation, from 1; 0 if there is none. YAML
/// forbids them (https://yaml.org/spec/1.1/#id871998), and parsers fail somewhere after them.
int lineWithTab(const std::string& text) {
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t end = line.find_first_not_of(" \t");
    if (end != std::string::npos && line[end] != '#' && line.find('\t') < end) return number;
  }
  return 0;
}

/// yaml-cpp's message about a text that is not YAML, and the most frequent cause.
[[noreturn]] void failToParse(const YAML::Exception& error, const std::string& text,
                              const Reader& reader) {
  if (const std::string fault = textFault(text); !fault.empty()) reader.fail({}, fault);
  if (const int line = lineWithTab(text); line > 0) {
    YAML::Mark mark;
    mark.line = line - 1;
    reader.fail(mark,
                "found a tab in the indentation; YAML takes spaces only, as many as the lines "
                "beside it have");
  }
  const std::string& message = error.msg;
  const bool is_layout =
      message.find("map") != std::string::npos || message.find("sequence") != std::string::npos;
  reader.fail(error.mark,
              message + (is_layout ? " (is the line indented like the others of its group, and is "
                                     "there a space after each colon and dash?)"
                                   : ""));
}

Value parse(const std::string& text, const std::string& origin, Rules rules,
            const Remark& remark = {}) {
  Reader reader(rules, text, origin, remark);
  try {
    const std::string whole = withEndMark(text);
    const auto second = secondDocument(whole);
    const YAML::Node document = YAML::Load(whole);
    if (rules == Rules::kSettings && second) {
      reader.fail(*second, "a second document begins; settings are one document");
    }
    return document.IsNull() ? Value() : reader.convert(document);
  } catch (const YAML::Exception& error) {
    failToParse(error, text, reader);
  }
}

}  // namespace

Value parseYaml(const std::string& text, const std::string& origin) {
  return parse(text, origin, Rules::kAnyFile);
}

Value loadYamlFile(const std::string& file) { return parseYaml(readInput(file), file); }

Value parseSettings(const std::string& text, const std::string& origin, const Remark& remark) {
  return parse(text, origin, Rules::kSettings, remark);
}

}  // namespace synthetic_dataset::base
