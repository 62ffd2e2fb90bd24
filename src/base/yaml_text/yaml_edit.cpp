#include "base/yaml_text/yaml_edit.h"

#include <algorithm>

#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

/// One step in changing a tree to another.
struct Step {
  enum class Kind { kSet, kInsert, kRemove };
  Kind kind;
  YamlPath path;
};

class StepFinder {
 public:
  std::vector<Step> between(const Value& from, const Value& to) {
    compare(from, to);
    return std::move(steps_);
  }

 private:
  void compare(const Value& from, const Value& to) {
    const auto* from_map = from.as<Value::Map>();
    const auto* to_map = to.as<Value::Map>();
    const auto* from_list = from.as<Value::List>();
    const auto* to_list = to.as<Value::List>();
    if (saysTheSame(from, to)) return;
    if (from_map != nullptr && to_map != nullptr && !(to_map->empty() && !path_.empty())) {
      compareMaps(*from_map, *to_map);
    } else if (from_list != nullptr && to_list != nullptr && !to_list->empty()) {
      compareLists(*from_list, *to_list);
    } else {
      steps_.push_back({Step::Kind::kSet, path_});
    }
  }

  void compareMaps(const Value::Map& from, const Value::Map& to) {
    for (const auto& [name, value] : to) {
      path_.emplace_back(name);
      const auto found = from.find(name);
      if (found == from.end()) {
        steps_.push_back({Step::Kind::kInsert, path_});
      } else {
        compare(found->second, value);
      }
      path_.pop_back();
    }
    for (const auto& each : from) {
      if (to.count(each.first) != 0) continue;
      path_.emplace_back(each.first);
      steps_.push_back({Step::Kind::kRemove, path_});
      path_.pop_back();
    }
  }

  /// Equal entries at the beginning and the end of the lists stay, with their comments.
  void compareLists(const Value::List& from, const Value::List& to) {
    const std::size_t shorter = std::min(from.size(), to.size());
    std::size_t begin = 0;
    while (begin < shorter && saysTheSame(from[begin], to[begin])) ++begin;
    std::size_t behind = 0;
    while (behind < shorter - begin &&
           saysTheSame(from[from.size() - 1 - behind], to[to.size() - 1 - behind])) {
      ++behind;
    }
    const std::size_t common = shorter - behind;
    for (std::size_t i = begin; i < common; ++i) {
      path_.emplace_back(i);
      compare(from[i], to[i]);
      path_.pop_back();
    }
    for (std::size_t i = from.size() - behind; i > common; --i) add(Step::Kind::kRemove, i - 1);
    for (std::size_t i = common; i + behind < to.size(); ++i) add(Step::Kind::kInsert, i);
  }

  void add(Step::Kind kind, std::size_t index) {
    path_.emplace_back(index);
    steps_.push_back({kind, path_});
    path_.pop_back();
  }

  YamlPath path_;
  std::vector<Step> steps_;
};

/// Reads a text as a group; an empty text is a group without entries.
Value readGroup(const std::string& text, const std::string& origin) {
  Value tree = readYamlText(text, origin);
  if (tree.isNull()) return Value::Map{};
  if (!tree.is<Value::Map>())
    throw Error(origin + ": found " + tree.kind() + "; it should be a group of named values");
  return tree;
}

class Editor {
 public:
  Editor(const std::string& origin, const Value& expected, const NameOrder& order)
      : origin_(origin), expected_(expected), order_(order) {}

  /// @throws Error if the text cannot be made to mean what is expected
  std::string edit(std::string text) const {
    Value tree = readGroup(text, origin_);
    // Each round makes one structural change, or all non-structural ones.
    constexpr std::size_t kMoreRounds = 50;
    std::size_t rounds = kMoreRounds + 4 * StepFinder().between(tree, expected_).size();
    for (; rounds > 0; --rounds) {
      const std::vector<Step> steps = StepFinder().between(tree, expected_);
      if (steps.empty()) return text;
      const std::string changed = changedBy(steps, text, tree);
      if (changed == text) break;
      text = changed;
      tree = readGroup(text, origin_);
    }
    throw Error("no edit of it has this effect");
  }

  /// Rewrites an entry, then edits the rest.
  std::string rewrite(const std::string& text, const YamlPath& path) const {
    const Value* value = valueAt(expected_, path);
    const YamlSplicer splicer(text, origin_);
    if (value == nullptr || !splicer.has(path)) throw Error("there is no such entry");
    return edit(spliced(text, {splicer.replace(path, *value)}));
  }

 private:
  std::string changedBy(const std::vector<Step>& steps, const std::string& text,
                        const Value& tree) const {
    const YamlSplicer splicer(text, origin_);
    std::vector<Splice> splices;
    for (const Step& step : steps) {
      if (step.kind != Step::Kind::kSet || !splicer.has(step.path)) continue;
      const auto aliases = splicer.withoutAliasesOf(step.path, tree);
      if (!aliases.empty()) return spliced(text, aliases);
      splices.push_back(splicer.replace(step.path, *valueAt(expected_, step.path)));
    }
    if (!splices.empty()) return spliced(text, splices);
    return spliced(text, structural(steps.front(), splicer, tree));
  }

  std::vector<Splice> structural(const Step& step, const YamlSplicer& splicer,
                                 const Value& tree) const {
    if (step.kind != Step::Kind::kRemove) return {splicer.insert(step.path, expected_, order_)};
    if (splicer.has(step.path)) {
      const auto aliases = splicer.withoutAliasesOf(step.path, tree);
      if (!aliases.empty()) return aliases;
      return {splicer.remove(step.path)};
    }
    // It comes from an alias or a merge: the entry that contains it is rewritten.
    YamlPath path = step.path;
    while (!path.empty() && !splicer.has(path)) path.pop_back();
    const Value* value = valueAt(expected_, path);
    if (path.empty() || value == nullptr)
      throw Error("it is not written where it could be removed");
    return {splicer.replace(path, *value)};
  }

  const std::string& origin_;
  const Value& expected_;
  const NameOrder& order_;
};

std::string editOne(const std::string& text, const std::string& origin, const YamlChange& change,
                    const NameOrder& order) {
  Value expected = readGroup(text, origin);
  if (change.value) {
    setValue(expected, change.path, *change.value);
  } else {
    removeValue(expected, change.path);
  }
  const Editor editor(origin, expected, order);
  std::string reason;
  try {
    return editor.edit(text);
  } catch (const Error& error) {
    reason = error.what();
  }
  for (std::size_t length = change.path.size(); length-- > 1;) {
    try {
      return editor.rewrite(
          text, {change.path.begin(), change.path.begin() + static_cast<std::ptrdiff_t>(length)});
    } catch (const Error&) {  // try the entry around it
    }
  }
  throw Error(pathText(change.path) + ": cannot be changed in this text (" + reason +
              "); change it by hand");
}

}  // namespace

Value readYamlText(const std::string& text, const std::string& origin) {
  try {
    return parseSettings(text, origin);
  } catch (const Error&) {
    return parseYaml(text, origin);
  }
}

std::string editYaml(const std::string& text, const std::string& origin,
                     const std::vector<YamlChange>& changes, const NameOrder& order) {
  std::string result = text;
  for (const YamlChange& change : changes) {
    if (change.path.empty()) throw Error("a change needs a path");
    result = editOne(result, origin, change, order);
  }
  return result;
}

}  // namespace synthetic_dataset::base
