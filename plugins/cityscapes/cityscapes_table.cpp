#include "plugins/cityscapes/cityscapes_table.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "plugins/shared/json.h"

namespace synthetic_dataset {

const CityscapesTable& cityscapesOwnTable() {
  constexpr int kNone = kCityscapesIgnored;
  static const CityscapesTable kTable = {
      {"unlabeled", 0, kNone, "void", 0, false, true, {{0, 0, 0}}},
      {"ego vehicle", 1, kNone, "void", 0, false, true, {{0, 0, 0}}},
      {"rectification border", 2, kNone, "void", 0, false, true, {{0, 0, 0}}},
      {"out of roi", 3, kNone, "void", 0, false, true, {{0, 0, 0}}},
      {"static", 4, kNone, "void", 0, false, true, {{0, 0, 0}}},
      {"dynamic", 5, kNone, "void", 0, false, true, {{111, 74, 0}}},
      {"ground", 6, kNone, "void", 0, false, true, {{81, 0, 81}}},
      {"road", 7, 0, "flat", 1, false, false, {{128, 64, 128}}},
      {"sidewalk", 8, 1, "flat", 1, false, false, {{244, 35, 232}}},
      {"parking", 9, kNone, "flat", 1, false, true, {{250, 170, 160}}},
      {"rail track", 10, kNone, "flat", 1, false, true, {{230, 150, 140}}},
      {"building", 11, 2, "construction", 2, false, false, {{70, 70, 70}}},
      {"wall", 12, 3, "construction", 2, false, false, {{102, 102, 156}}},
      {"fence", 13, 4, "construction", 2, false, false, {{190, 153, 153}}},
      {"guard rail", 14, kNone, "construction", 2, false, true, {{180, 165, 180}}},
      {"bridge", 15, kNone, "construction", 2, false, true, {{150, 100, 100}}},
      {"tunnel", 16, kNone, "construction", 2, false, true, {{150, 120, 90}}},
      {"pole", 17, 5, "object", 3, false, false, {{153, 153, 153}}},
      {"polegroup", 18, kNone, "object", 3, false, true, {{153, 153, 153}}},
      {"traffic light", 19, 6, "object", 3, false, false, {{250, 170, 30}}},
      {"traffic sign", 20, 7, "object", 3, false, false, {{220, 220, 0}}},
      {"vegetation", 21, 8, "nature", 4, false, false, {{107, 142, 35}}},
      {"terrain", 22, 9, "nature", 4, false, false, {{152, 251, 152}}},
      {"sky", 23, 10, "sky", 5, false, false, {{70, 130, 180}}},
      {"person", 24, 11, "human", 6, true, false, {{220, 20, 60}}},
      {"rider", 25, 12, "human", 6, true, false, {{255, 0, 0}}},
      {"car", 26, 13, "vehicle", 7, true, false, {{0, 0, 142}}},
      {"truck", 27, 14, "vehicle", 7, true, false, {{0, 0, 70}}},
      {"bus", 28, 15, "vehicle", 7, true, false, {{0, 60, 100}}},
      {"caravan", 29, kNone, "vehicle", 7, true, true, {{0, 0, 90}}},
      {"trailer", 30, kNone, "vehicle", 7, true, true, {{0, 0, 110}}},
      {"train", 31, 16, "vehicle", 7, true, false, {{0, 80, 100}}},
      {"motorcycle", 32, 17, "vehicle", 7, true, false, {{0, 0, 230}}},
      {"bicycle", 33, 18, "vehicle", 7, true, false, {{119, 11, 32}}},
  };
  return kTable;
}

const CityscapesEntry* entryOf(const CityscapesTable& table, int id) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const CityscapesEntry& each) { return each.id == id; });
  return found == table.end() ? nullptr : &*found;
}

void writeLabelTable(std::ostream& stream, const CityscapesTable& table) {
  Json entries = Json::array();
  for (const CityscapesEntry& each : table) {
    entries.push_back({{"name", each.name},
                       {"id", each.id},
                       {"trainId", each.train_id},
                       {"category", each.category},
                       {"categoryId", each.category_id},
                       {"hasInstances", each.has_instances},
                       {"ignoreInEval", each.is_ignored},
                       {"color", each.colour}});
  }
  stream << indentedJson(entries);
}

void writeLabelColours(std::ostream& stream, const CityscapesTable& table) {
  std::map<int, const CityscapesEntry*> trained;  // classes may share a label
  for (const CityscapesEntry& each : table) {
    if (each.train_id != kCityscapesIgnored) trained.try_emplace(each.train_id, &each);
  }
  std::set<std::string> taken = {"background"};
  for (const auto& [train_id, entry] : trained) {
    std::string name = entry->name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == 0x7F; }, '_');
    if (!taken.insert(name).second) taken.insert(name += "_" + std::to_string(train_id));
    for (const int channel : entry->colour) stream << channel << ' ';
    stream << name << '\n';
  }
  stream << "0 0 0 background\n";
}

}  // namespace synthetic_dataset
