#pragma once

#include <map>
#include <string>
#include <vector>

namespace synthetic_dataset::scene {

/// Groups of links by name: patterns of what is meant, in which `*` and `?` stand for any text and
/// any character.
using LinkGroups = std::map<std::string, std::vector<std::string>>;

/// Classes of what no object is: patterns of models' names ("wall_*") or of links ("house::roof"),
/// or the numbers that gz-sim's label plugins give them.
using WorldClasses = LinkGroups;

}  // namespace synthetic_dataset::scene
