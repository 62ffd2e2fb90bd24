#include "base/yaml_text/yaml_splicer.h"

#include <algorithm>
#include <map>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

constexpr std::size_t kWidestFlow = 100;

bool isBlockCollection(const YamlPart& part) {
  return !part.is_flow && (part.kind == YamlPart::Kind::kList || part.kind == YamlPart::Kind::kMap);
}

/// Wraps a value in the levels of the path from `from` on.
Value nested(const YamlPath& path, std::size_t from, const Value& value) {
  Value tree;
  const YamlPath rest(path.begin() + static_cast<std::ptrdiff_t>(from), path.end());
  setValue(tree, rest, value);
  return tree;
}

/// The index at which a new entry belongs in a map: after the nearest one before it in the usual
/// order, else at the end.
std::size_t indexFor(const YamlPart& map, const std::string& name,
                     const std::vector<std::string>& order) {
  const auto rank = [&](const std::string& each) {
    return std::find(order.begin(), order.end(), each) - order.begin();
  };
  const std::ptrdiff_t own = rank(name);
  if (own == static_cast<std::ptrdiff_t>(order.size())) return map.entries.size();
  std::size_t index = map.entries.size();
  std::ptrdiff_t nearest = -1;
  for (std::size_t i = 0; i < map.entries.size(); ++i) {
    const std::ptrdiff_t other = rank(map.entries[i].name);
    if (other >= own || other < nearest) continue;
    nearest = other;
    index = i + 1;
  }
  return index;
}

using Visitor = std::function<void(const YamlPart& part, const YamlPath& path)>;

void visitParts(const YamlPart& part, YamlPath& path, const Visitor& visitor) {
  visitor(part, path);
  for (std::size_t i = 0; i < part.entries.size(); ++i) {
    const bool is_map = part.kind == YamlPart::Kind::kMap;
    path.push_back(is_map ? YamlStep(part.entries[i].name) : YamlStep(i));
    visitParts(part.entries[i].value, path, visitor);
    path.pop_back();
  }
}

}  // namespace

std::string spliced(const std::string& text, std::vector<Splice> splices) {
  std::sort(splices.begin(), splices.end(),
            [](const Splice& a, const Splice& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t done = 0;
  for (const Splice& each : splices) {
    if (each.begin < done) continue;  // within a piece that was already replaced
    result += text.substr(done, each.begin - done) + each.text;
    done = each.end;
  }
  return result + text.substr(done);
}

YamlSplicer::YamlSplicer(const std::string& text, const std::string& origin)
    : text_(text), scan_(text), root_(outlineYaml(text, origin)) {
  const std::size_t line = text.find('\n');
  if (line != std::string::npos && line > 0 && text[line - 1] == '\r') layout_.line_break = "\r\n";
  layout_.indentation = layout_.list_indentation = std::string::npos;
  measureLayout(root_);
  if (layout_.indentation == std::string::npos) layout_.indentation = 2;
  if (layout_.list_indentation == std::string::npos) layout_.list_indentation = layout_.indentation;
}

std::size_t YamlSplicer::column(const YamlPart& block) const {
  return block.entries.empty() ? 0 : scan_.column(block.entries.front().begin);
}

void YamlSplicer::measureLayout(const YamlPart& part) {
  for (const YamlEntry& entry : part.entries) {
    if (part.kind == YamlPart::Kind::kMap && !part.is_flow && isBlockCollection(entry.value)) {
      std::size_t& indentation =
          entry.value.kind == YamlPart::Kind::kMap ? layout_.indentation : layout_.list_indentation;
      if (indentation == std::string::npos) indentation = column(entry.value) - column(part);
    }
    measureLayout(entry.value);
  }
}

YamlSplicer::Found YamlSplicer::find(const YamlPath& path) const {
  Found found{{&root_}, {}};
  for (const YamlStep& step : path) {
    const YamlPart& part = *found.parts.back();
    std::size_t index = part.entries.size();
    if (const auto* name = std::get_if<std::string>(&step)) {
      if (part.kind != YamlPart::Kind::kMap) return found;
      for (std::size_t i = 0; i < part.entries.size(); ++i) {  // the last of equal names counts
        if (part.entries[i].name == *name) index = i;
      }
    } else if (part.kind == YamlPart::Kind::kList) {
      index = std::get<std::size_t>(step);
    }
    if (index >= part.entries.size()) return found;
    found.entry_indices.push_back(index);
    found.parts.push_back(&part.entries[index].value);
  }
  return found;
}

bool YamlSplicer::has(const YamlPath& path) const {
  const Found found = find(path);
  return !path.empty() && found.parts.size() == path.size() + 1;
}

Splice YamlSplicer::replace(const YamlPath& path, const Value& value) const {
  const Found found = find(path);
  return replaceEntry(*found.parts[found.parts.size() - 2], found.entry(), value);
}

Splice YamlSplicer::replaceEntry(const YamlPart& parent, const YamlEntry& entry,
                                 const Value& value) const {
  if (parent.is_flow) return replaceInFlow(entry, value);
  if (isReplacedByLines(parent, entry, value)) return replaceByLines(parent, entry, value);
  const YamlPart& old = entry.value;
  const std::string earlier = old.kind == YamlPart::Kind::kScalar
                                  ? text_.substr(old.content, old.end - old.content)
                                  : std::string();
  return replaceByLine(entry, scalarLike(value, earlier, false));
}

Splice YamlSplicer::replaceInFlow(const YamlEntry& entry, const Value& value) const {
  const YamlPart& old = entry.value;
  const std::string earlier = text_.substr(old.content, old.end - old.content);
  const std::string text = scalarLike(value, earlier, true);
  if (old.end > old.begin) return {old.begin, old.end, text};
  const bool has_colon = entry.indicator > 0 && text_[entry.indicator - 1] == ':';
  return {entry.indicator, entry.indicator, (has_colon ? " " : ": ") + text};
}

/// Replaces by a value on one line. A comment after the name stays there.
Splice YamlSplicer::replaceByLine(const YamlEntry& entry, const std::string& line) const {
  const YamlPart& old = entry.value;
  if (old.end == old.begin) return {entry.indicator, entry.indicator, " " + line};
  const std::size_t line_end = scan_.lineEnd(entry.indicator);
  if (old.begin <= line_end) return {old.begin, old.end, line};
  const std::string comment = text_.substr(entry.indicator, line_end - entry.indicator);
  std::string above = text_.substr(line_end, scan_.lineBegin(old.begin) - line_end);
  while (!above.empty() && (above.back() == '\n' || above.back() == '\r')) above.pop_back();
  return {entry.indicator, old.end, " " + line + comment + above};
}

bool YamlSplicer::isReplacedByLines(const YamlPart& parent, const YamlEntry& entry,
                                    const Value& value) const {
  const auto* list = value.as<Value::List>();
  const auto* map = value.as<Value::Map>();
  if ((list == nullptr || list->empty()) && (map == nullptr || map->empty())) return false;
  const YamlPart& old = entry.value;
  if (isBlockCollection(old)) return true;
  const std::size_t start = scan_.column(entry.indicator) + 1;
  const bool fits = start + flowYaml(value, false).size() <= kWidestFlow;
  const bool was_flow = old.is_flow && !old.entries.empty();
  if (was_flow && fits) return false;
  if (parent.kind == YamlPart::Kind::kList) return !fits;
  return wantsLines(value, start);
}

Splice YamlSplicer::replaceByLines(const YamlPart& parent, const YamlEntry& entry,
                                   const Value& value) const {
  const YamlPart& old = entry.value;
  if (isBlockCollection(old)) {
    return {old.content, old.end, blockYaml(value, scan_.column(old.content), layout_)};
  }
  if (parent.kind == YamlPart::Kind::kList) {
    constexpr std::size_t kDash = 2;
    return {entry.indicator, old.end,
            " " + blockYaml(value, scan_.column(entry.begin) + kDash, layout_)};
  }
  const std::size_t below =
      scan_.column(entry.begin) +
      (value.is<Value::List>() ? layout_.list_indentation : layout_.indentation);
  const std::size_t line_end = scan_.lineEnd(old.end);
  const std::string comment = text_.substr(old.end, line_end - old.end);
  return {
      entry.indicator, line_end,
      comment + layout_.line_break + std::string(below, ' ') + blockYaml(value, below, layout_)};
}

Splice YamlSplicer::insert(const YamlPath& path, const Value& expected,
                           const NameOrder& order) const {
  const Found found = find(path);
  const YamlPart& deepest = *found.parts.back();
  const std::size_t depth = found.parts.size() - 1;
  const auto prefix = [&](std::size_t length) {
    return YamlPath(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(length));
  };
  const auto* name = std::get_if<std::string>(&path[depth]);
  const bool fits =
      deepest.kind == (name != nullptr ? YamlPart::Kind::kMap : YamlPart::Kind::kList);
  const bool is_empty_flow = deepest.is_flow && deepest.entries.empty();
  if (depth > 0 && (!fits || is_empty_flow)) {
    const Value* value = valueAt(expected, prefix(depth));
    if (value == nullptr) throw Error(pathText(path) + ": should not be there");
    return replaceEntry(*found.parts[depth - 1], found.entry(), *value);
  }
  const Value value = nested(path, depth + 1, *valueAt(expected, path));
  if (depth == 0 && deepest.kind == YamlPart::Kind::kNothing && name != nullptr) {
    const bool at_line_begin = text_.empty() || text_.back() == '\n';
    return {text_.size(), text_.size(),
            (at_line_begin ? "" : layout_.line_break) + entryYaml(*name, value, 0, layout_) +
                layout_.line_break};
  }
  if (!fits) throw Error(pathText(path) + ": the file's values are not a group");
  const std::size_t index =
      name != nullptr
          ? indexFor(deepest, *name, order ? order(prefix(depth)) : std::vector<std::string>())
          : std::min(std::get<std::size_t>(path[depth]), deepest.entries.size());
  return insertInto(deepest, index, path[depth], value);
}

Splice YamlSplicer::insertInto(const YamlPart& parent, std::size_t index, const YamlStep& step,
                               const Value& value) const {
  const auto* name = std::get_if<std::string>(&step);
  if (parent.is_flow) {
    const std::string text =
        (name != nullptr ? nameYaml(*name, true) + ": " : "") + flowYaml(value, true);
    if (parent.entries.empty()) return {parent.content + 1, parent.content + 1, text};
    const std::size_t at =
        index == 0 ? parent.entries.front().begin : parent.entries[index - 1].value.end;
    return {at, at, index == 0 ? text + ", " : ", " + text};
  }
  const std::size_t indentation = column(parent);
  const std::string text = name != nullptr ? entryYaml(*name, value, indentation, layout_)
                                           : dashYaml(value, indentation, layout_);
  const std::string line = layout_.line_break + std::string(indentation, ' ');
  if (index == 0) {
    const std::size_t at = parent.entries.front().begin;
    return {at, at, text + line};
  }
  // After comments that are indented deeper: they belong to the entry before.
  std::size_t at = scan_.lineEnd(parent.entries[index - 1].value.end);
  for (std::size_t next = scan_.nextLine(at); next < text_.size(); next = scan_.nextLine(next)) {
    const std::size_t word = text_.find_first_not_of(' ', next);
    if (word >= text_.size() || text_[word] != '#' || word - next <= indentation) break;
    at = scan_.lineEnd(next);
  }
  return {at, at, line + text};
}

Splice YamlSplicer::remove(const YamlPath& path) const {
  Found found = find(path);
  while (found.parts.size() > 2 && found.parts[found.parts.size() - 2]->entries.size() == 1 &&
         found.parts[found.parts.size() - 2]->kind == YamlPart::Kind::kMap &&
         found.parts[found.parts.size() - 3]->kind == YamlPart::Kind::kMap) {
    found.parts.pop_back();
    found.entry_indices.pop_back();
  }
  const YamlPart& parent = *found.parts[found.parts.size() - 2];
  const std::size_t index = found.entry_indices.back();
  if (parent.is_flow) return removeFlowEntry(parent, index);
  const YamlEntry& entry = parent.entries[index];
  const std::size_t line_begin = scan_.lineBegin(entry.begin);
  const bool is_alone = text_.find_first_not_of(' ', line_begin) == entry.begin;
  if (parent.entries.size() == 1 && &parent != &root_) {
    const bool is_map = parent.kind == YamlPart::Kind::kMap;
    found.parts.pop_back();
    found.entry_indices.pop_back();
    return replaceByLine(found.entry(), is_map ? "{}" : "[]");
  }
  if (is_alone) return {line_begin, scan_.nextLine(entry.value.end), ""};
  // The first entry after a dash: the next one takes its place.
  if (index + 1 == parent.entries.size()) throw Error(pathText(path) + ": cannot be removed");
  return {entry.begin, parent.entries[index + 1].begin, ""};
}

Splice YamlSplicer::removeFlowEntry(const YamlPart& parent, std::size_t index) const {
  const YamlEntry& entry = parent.entries[index];
  if (index + 1 < parent.entries.size()) {
    const std::size_t next = parent.entries[index + 1].begin;
    if (text_.substr(entry.value.end, next - entry.value.end).find('#') == std::string::npos) {
      return {entry.begin, next, ""};
    }
    const std::size_t comma = scan_.afterGap(entry.value.end, "");
    return {entry.begin, comma + 1, ""};
  }
  if (index == 0) return {entry.begin, entry.value.end, ""};
  const std::size_t before = parent.entries[index - 1].value.end;
  if (text_.substr(before, entry.begin - before).find('#') == std::string::npos) {
    return {before, entry.value.end, ""};
  }
  return {entry.begin, entry.value.end, ""};  // YAML allows the comma before it
}

std::vector<Splice> YamlSplicer::withoutAliasesOf(const YamlPath& path, const Value& tree) const {
  const YamlPart& removed = *find(path).parts.back();
  std::map<std::size_t, YamlPath> anchors;
  YamlPath at = path;
  visitParts(removed, at, [&](const YamlPart& part, const YamlPath& place) {
    if (part.anchor != 0 && part.kind != YamlPart::Kind::kAlias) anchors[part.anchor] = place;
  });
  std::vector<Splice> splices;
  at.clear();
  visitParts(root_, at, [&](const YamlPart& part, const YamlPath& place) {
    const bool is_outside = part.begin < removed.begin || part.begin >= removed.end;
    if (part.kind != YamlPart::Kind::kAlias || anchors.count(part.anchor) == 0 || !is_outside)
      return;
    const Value* value = valueAt(tree, anchors.at(part.anchor));
    if (value == nullptr) throw Error(pathText(place) + ": merges what is to be changed");
    splices.push_back(replace(place, *value));
  });
  return splices;
}

}  // namespace synthetic_dataset::base
