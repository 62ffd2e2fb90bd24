#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/yaml_text/yaml_change.h"
#include "base/yaml_text/yaml_outline.h"
#include "base/yaml_text/yaml_rendering.h"
#include "base/yaml_text/yaml_scan.h"

namespace synthetic_dataset::base {

/// The names of a group in the order in which they are usually written; empty: not known.
using NameOrder = std::function<std::vector<std::string>(const YamlPath& group)>;

/// A piece of a text that another one replaces.
struct Splice {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};

/// @param splices  which do not overlap
[[nodiscard]] std::string spliced(const std::string& text, std::vector<Splice> splices);

/// Finds which pieces of a YAML text to replace so that its tree changes; comments, order and
/// layout of all else stay. Whether the result says what it should is for the caller to check.
class YamlSplicer {
 public:
  /// @param text  has to outlive this
  /// @throws Error as outlineYaml
  YamlSplicer(const std::string& text, const std::string& origin);

  /// Whether the text has a value at this path that is not empty and comes from no alias or merge.
  [[nodiscard]] bool has(const YamlPath& path) const;

  /// Replaces the value at a path.
  [[nodiscard]] Splice replace(const YamlPath& path, const Value& value) const;

  /// Adds what is not there, in the deepest group of its path that is.
  /// @param expected  what the whole text is to say, for values that are aliases there
  [[nodiscard]] Splice insert(const YamlPath& path, const Value& expected,
                              const NameOrder& order) const;

  /// Removes an entry, or the group of which it is the only one.
  [[nodiscard]] Splice remove(const YamlPath& path) const;

  /// Replaces aliases elsewhere that refer to the value at a path, or to a part of it, by that
  /// value.
  /// @param tree  of the text
  [[nodiscard]] std::vector<Splice> withoutAliasesOf(const YamlPath& path, const Value& tree) const;

 private:
  /// The parts along a path, as far as the text has them.
  struct Found {
    std::vector<const YamlPart*> parts;      ///< from the root
    std::vector<std::size_t> entry_indices;  ///< of parts[i + 1] in parts[i]

    [[nodiscard]] const YamlEntry& entry() const {
      return parts[parts.size() - 2]->entries[entry_indices.back()];
    }
  };

  void measureLayout(const YamlPart& part);
  [[nodiscard]] Found find(const YamlPath& path) const;
  [[nodiscard]] Splice replaceEntry(const YamlPart& parent, const YamlEntry& entry,
                                    const Value& value) const;
  [[nodiscard]] Splice replaceInFlow(const YamlEntry& entry, const Value& value) const;
  [[nodiscard]] Splice replaceByLine(const YamlEntry& entry, const std::string& line) const;
  [[nodiscard]] Splice replaceByLines(const YamlPart& parent, const YamlEntry& entry,
                                      const Value& value) const;
  [[nodiscard]] bool isReplacedByLines(const YamlPart& parent, const YamlEntry& entry,
                                       const Value& value) const;
  [[nodiscard]] Splice insertInto(const YamlPart& parent, std::size_t index, const YamlStep& step,
                                  const Value& value) const;
  [[nodiscard]] Splice removeFlowEntry(const YamlPart& parent, std::size_t index) const;
  [[nodiscard]] std::size_t column(const YamlPart& block) const;

  const std::string& text_;
  YamlScan scan_;
  YamlPart root_;
  YamlLayout layout_;
};

}  // namespace synthetic_dataset::base
