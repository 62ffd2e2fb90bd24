#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace synthetic_dataset {

/// What neither training nor evaluation looks at has this train id.
inline constexpr int kCityscapesIgnored = 255;

/// A label as cityscapesscripts/helpers/labels.py has it.
struct CityscapesEntry {
  std::string name;
  int id = 0;
  int train_id = kCityscapesIgnored;
  std::string category = "void";
  int category_id = 0;
  bool has_instances = false;
  bool is_ignored = true;            ///< in evaluation
  std::array<int, 3> colour = {{}};  ///< red, green, blue
};

using CityscapesTable = std::vector<CityscapesEntry>;

/// Cityscapes' own labels, 0 to 33 in this order.
[[nodiscard]] const CityscapesTable& cityscapesOwnTable();

/// The label of a number; null where the table has none.
[[nodiscard]] const CityscapesEntry* entryOf(const CityscapesTable& table, int id);

/// The table as JSON, for people and for programs that replace their own by it.
void writeLabelTable(std::ostream& stream, const CityscapesTable& table);

/// Datumaro's `label_colors.txt`: the labels that are trained, in the order of their train ids,
/// each with its colour; names are single words there.
void writeLabelColours(std::ostream& stream, const CityscapesTable& table);

}  // namespace synthetic_dataset
