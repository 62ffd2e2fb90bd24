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

/// The names of a group in the order in which they are usually written; empty if not known.
using NameOrder = std::function<std::vector<std::string>(const YamlPath& group)>;

/// A piece of a text and its replacement.
struct Splice {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};

/// @param splices  which do not overlap
[[nodiscard]] std::string spliced(const std::string& text, std::vector<Splice> splices);

/// Finds the pieces of a YAML text to replace in order to change its tree; comments, order and
/// layout of all else stay. The caller must check that the result means what it should.
class YamlSplicer {
 public:
  /// @param text  must outlive this object
  /// @throws Error as outlineYaml
  YamlSplicer(const std::string& text, const std::string& origin);

  /// Whether the text itself has an entry at this path, not one from an alias or a merge.
  [[nodiscard]] bool has(const YamlPath& path) const;

  /// Replaces the value at a path.
  [[nodiscard]] Splice replace(const YamlPath& path, const Value& value) const;

  /// Adds a missing entry to the deepest existing group of its path.
  /// @param expected  the tree that the whole text should have, for values that are aliases there
  [[nodiscard]] Splice insert(const YamlPath& path, const Value& expected,
                              const NameOrder& order) const;

  /// Removes an entry, or the group of which it is the only entry.
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
