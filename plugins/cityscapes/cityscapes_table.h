#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace synthetic_dataset {

/// The train id of labels that training and evaluation ignore.
inline constexpr int kCityscapesIgnored = 255;

/// A label in the form used by cityscapesscripts/helpers/labels.py.
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

/// The label with a number; null if the table has none.
[[nodiscard]] const CityscapesEntry* entryOf(const CityscapesTable& table, int id);

/// Writes the table as JSON, for people and for programs that replace their own table with it.
void writeLabelTable(std::ostream& stream, const CityscapesTable& table);

/// Writes Datumaro's `label_colors.txt`: the labels used in training, in the order of their train
/// ids, each with its colour; names in that file are single words.
void writeLabelColours(std::ostream& stream, const CityscapesTable& table);

}  // namespace synthetic_dataset
