#include "base/yaml_text/yaml_outline.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include "base/nesting.h"
#include "base/yaml_text/yaml_scan.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

/// Builds the tree with the begins of its parts: yaml-cpp does not report their ends.
class OutlineBuilder : public YAML::EventHandler {
 public:
  explicit OutlineBuilder(std::size_t shift) : shift_(shift) {}

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    put(part(YamlPart::Kind::kNothing, mark, anchor), "");
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    put(part(YamlPart::Kind::kAlias, mark, anchor), "*");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                const std::string& value) override {
    put(part(YamlPart::Kind::kScalar, mark, anchor), value);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(YamlPart::Kind::kList, mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(YamlPart::Kind::kMap, mark, anchor);
  }
  void OnMapEnd() override { close(); }

  YamlPart root;

 private:
  struct Open {
    YamlPart part;
    std::optional<YamlEntry> begun;  ///< in a map: an entry whose name is known but not its value
  };

  [[nodiscard]] YamlPart part(YamlPart::Kind kind, const YAML::Mark& mark,
                              YAML::anchor_t anchor) const {
    YamlPart result;
    result.kind = kind;
    result.begin = static_cast<std::size_t>(mark.pos) + shift_;
    result.anchor = anchor;
    return result;
  }

  void open(YamlPart::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() == kDeepestNesting) throw YAML::ParserException(mark, kNestedTooDeep);
    open_.push_back({part(kind, mark, anchor), std::nullopt});
  }

  void close() {
    YamlPart done = std::move(open_.back().part);
    open_.pop_back();
    put(std::move(done), "");
  }

  void put(YamlPart done, const std::string& text) {
    if (open_.empty()) {
      root = std::move(done);
      return;
    }
    Open& parent = open_.back();
    if (parent.part.kind == YamlPart::Kind::kList) {
      parent.part.entries.push_back({"", 0, 0, std::move(done)});
    } else if (!parent.begun) {
      if (done.kind != YamlPart::Kind::kScalar) throw Error("a name that is not plain text");
      parent.begun = YamlEntry{text, done.begin, 0, {}};
    } else {
      parent.begun->value = std::move(done);
      parent.part.entries.push_back(std::move(*parent.begun));
      parent.begun.reset();
    }
  }

  std::size_t shift_;
  std::vector<Open> open_;
};

/// Finds the ends of the parts.
class EndFinder {
 public:
  explicit EndFinder(const std::string& text) : text_(text), scan_(text) {}

  /// @param indentation  of the block list or map that it is in; -1 if it is in none
  void finish(YamlPart& part, std::ptrdiff_t indentation, bool in_flow) {
    part.content = scan_.afterProperties(part.begin);
    if (part.kind == YamlPart::Kind::kScalar) {
      part.end = scan_.scalarEnd(part.content, indentation, in_flow);
    } else if (part.kind == YamlPart::Kind::kAlias) {
      part.end = scan_.wordEnd(part.content);
    } else if (part.content < text_.size() &&
               text_[part.content] == (part.kind == YamlPart::Kind::kMap ? '{' : '[')) {
      finishFlow(part);
    } else {
      finishBlock(part, in_flow);
    }
  }

 private:
  void finishFlow(YamlPart& part) {
    part.is_flow = true;
    std::size_t cursor = part.content + 1;
    for (YamlEntry& entry : part.entries) {
      if (part.kind == YamlPart::Kind::kMap) {
        cursor = finishName(entry, true);
      } else {
        entry.begin = scan_.afterGap(cursor, ",");
        entry.indicator = entry.begin;
      }
      cursor = finishValue(entry, -1, true);
    }
    cursor = scan_.afterGap(cursor, ",");
    require(cursor, part.kind == YamlPart::Kind::kMap ? '}' : ']');
    part.end = cursor + 1;
  }

  /// Also handles a map of one entry within a flow list, which needs no brackets: [a: 1].
  void finishBlock(YamlPart& part, bool in_flow) {
    part.is_flow = in_flow;
    const auto column = static_cast<std::ptrdiff_t>(scan_.column(part.content));
    std::size_t cursor = part.content;
    for (YamlEntry& entry : part.entries) {
      if (part.kind == YamlPart::Kind::kMap) {
        finishName(entry, in_flow);
      } else {
        entry.begin = scan_.afterGap(cursor, "");
        require(entry.begin, '-');
        entry.indicator = entry.begin + 1;
      }
      cursor = finishValue(entry, column, in_flow);
    }
    part.end = cursor;
  }

  /// @return where its value may begin
  std::size_t finishName(YamlEntry& entry, bool in_flow) {
    const std::size_t name_end = scan_.nameEnd(scan_.afterProperties(entry.begin), in_flow);
    const std::size_t colon = scan_.afterGap(name_end, "");
    const bool has_colon = colon < text_.size() && text_[colon] == ':';
    if (!has_colon && !in_flow) fail(colon);
    entry.begin = scan_.markBefore(entry.begin, '?');
    entry.indicator = has_colon ? colon + 1 : name_end;
    return entry.indicator;
  }

  std::size_t finishValue(YamlEntry& entry, std::ptrdiff_t indentation, bool in_flow) {
    YamlPart& value = entry.value;
    if (value.kind != YamlPart::Kind::kNothing) {
      finish(value, indentation, in_flow);
    } else {
      finishNothing(value, entry.indicator);
    }
    return value.end;
  }

  /// A null may be written as null or ~, have an anchor, or be absent, in which case its mark is
  /// that of whatever comes next.
  void finishNothing(YamlPart& value, std::size_t indicator) const {
    const std::size_t word = std::min(text_.find_first_not_of(" \t", indicator), text_.size());
    const bool is_written = word == value.begin && word < text_.size() &&
                            std::string("~nN&!").find(text_[word]) != std::string::npos;
    value.begin = is_written ? word : indicator;
    value.content = value.begin;
    value.end = is_written ? scan_.lineOfWordsEnd(word) : indicator;
  }

  void require(std::size_t offset, char expected) const {
    if (offset >= text_.size() || text_[offset] != expected) fail(offset);
  }

  [[noreturn]] void fail(std::size_t offset) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text_.size()));
    throw Error("line " + std::to_string(1 + std::count(text_.begin(), end, '\n')) +
                " is laid out in a way that only a text editor can change");
  }

  const std::string& text_;
  YamlScan scan_;
};

}  // namespace

YamlPart outlineYaml(const std::string& text, const std::string& origin) {
  constexpr std::size_t kByteOrderMark = 3;
  const std::size_t shift = text.rfind("\xEF\xBB\xBF", 0) == 0 ? kByteOrderMark : 0;
  OutlineBuilder builder(shift);
  try {
    std::istringstream stream(text.substr(shift));
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    if (builder.root.kind == YamlPart::Kind::kNothing) {
      builder.root.begin = builder.root.content = builder.root.end = text.size();
    } else {
      EndFinder(text).finish(builder.root, -1, false);
    }
  } catch (const YAML::Exception& error) {
    throw Error(origin + ": line " + std::to_string(error.mark.line + 1) + ": " + error.msg);
  } catch (const Error& error) {
    throw Error(origin + ": " + error.what());
  }
  return std::move(builder.root);
}

}  // namespace synthetic_dataset::base
