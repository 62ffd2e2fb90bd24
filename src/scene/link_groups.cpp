#include "scene/link_groups.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/name_pattern.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::scene {
namespace {

using LinkSet = std::vector<std::size_t>;  // indices in the world's links

/// The result of matching links against patterns.
struct Grouping {
  std::vector<std::uint16_t> numbers;                       ///< by link
  std::vector<std::pair<std::string, std::string>> unused;  ///< group and pattern

  /// A link's name with the two groups that match it: "house::roof", "floor", "wall".
  std::vector<std::array<std::string, 3>> contested;
};

/// @param fits  whether a pattern matches a link
/// @param nameOf  name of a link, for messages
void group(const LinkGroups& groups, const LinkSet& links,
           const std::function<bool(std::size_t link, const std::string& pattern)>& fits,
           const std::function<std::string(std::size_t link)>& nameOf, Grouping& grouping) {
  std::map<std::size_t, std::string> taken;
  std::uint16_t number = 0;
  for (const auto& [name, patterns] : groups) {
    ++number;
    for (const std::string& pattern : patterns) {
      bool is_used = false;
      for (const std::size_t link : links) {
        if (!fits(link, pattern)) continue;
        is_used = true;
        const auto [other, is_new] = taken.emplace(link, name);
        if (!is_new && other->second != name) {
          grouping.contested.push_back({nameOf(link), other->second, name});
        }
        grouping.numbers[link] = number;
      }
      if (!is_used) grouping.unused.emplace_back(name, pattern);
    }
  }
}

}  // namespace

std::vector<std::uint16_t> worldClassNumbers(const WorldClasses& classes,
                                             const std::vector<world::LinkInstance>& links,
                                             base::Diagnostics& diagnostics) {
  Grouping grouping;
  grouping.numbers.resize(links.size());
  LinkSet of_world;
  LinkSet of_objects;  // in the world itself: patterns may match these, but they get no class
  std::set<std::string> models;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool is_object = links[i].object >= 0;
    const bool is_own =
        links[i].role == world::Role::kStatic || links[i].role == world::Role::kProp;
    if (is_object && !is_own) continue;
    (is_object ? of_objects : of_world).push_back(i);
    models.insert(links[i].model);
  }
  const auto nameOf = [&](std::size_t i) { return links[i].model + "::" + links[i].link->name; };
  const auto fits = [&](std::size_t i, const std::string& pattern) {
    if (links[i].link->label && std::to_string(*links[i].link->label) == pattern) return true;
    return base::matchesPattern(links[i].model, pattern) ||
           base::matchesPattern(nameOf(i), pattern);
  };
  group(classes, of_world, fits, nameOf, grouping);
  for (const auto& [link, first, second] : grouping.contested) {
    diagnostics.error("world_classes", "'" + link + "' is in '" + first + "' and in '" + second +
                                           "'; each thing should be in one class");
  }
  for (const auto& [name, unused] : grouping.unused) {
    const std::string& pattern = unused;
    if (std::any_of(of_objects.begin(), of_objects.end(),
                    [&](std::size_t i) { return fits(i, pattern); })) {
      continue;
    }
    diagnostics.warning("world_classes/" + name,
                        "nothing in the world is called or labelled '" + pattern + "'" +
                            didYouMean(pattern, {models.begin(), models.end()}));
  }
  return std::move(grouping.numbers);
}

std::vector<std::uint16_t> partNumbers(const std::vector<ObjectOptions>& objects,
                                       const std::vector<world::LinkInstance>& links,
                                       base::Diagnostics& diagnostics) {
  Grouping grouping;
  grouping.numbers.resize(links.size());
  for (std::size_t object = 0; object < objects.size(); ++object) {
    const ObjectOptions& options = objects[object];
    if (options.parts.empty() || !options.takes_part) continue;
    LinkSet own;
    std::set<std::string> names;
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (links[i].object != static_cast<int>(object)) continue;
      own.push_back(i);
      names.insert(links[i].link->name);
    }
    grouping.unused.clear();
    grouping.contested.clear();
    group(
        options.parts, own,
        [&](std::size_t i, const std::string& pattern) {
          return base::matchesPattern(links[i].link->name, pattern);
        },
        [&](std::size_t i) { return links[i].link->name; }, grouping);
    for (const auto& [link, first, second] : grouping.contested) {
      diagnostics.error(options.name + "/parts", "the link '" + link + "' is in '" + first +
                                                     "' and in '" + second +
                                                     "'; it should be in one part");
    }
    for (const auto& [name, pattern] : grouping.unused) {
      diagnostics.error(options.name + "/parts/" + name,
                        "its model has no link '" + pattern + "'" +
                            didYouMean(pattern, {names.begin(), names.end()}));
    }
  }
  return std::move(grouping.numbers);
}

}  // namespace synthetic_dataset::scene
