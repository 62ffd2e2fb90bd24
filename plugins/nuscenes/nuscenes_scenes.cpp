#include "plugins/nuscenes/nuscenes_scenes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <string_view>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::nuscenes {
namespace {

/// A range of scene numbers, including both ends.
struct Range {
  int first;
  int last;
};

// nuscenes-devkit 1.2.0, python-sdk/nuscenes/utils/splits.py: 700, 150 and 150 scenes.
constexpr Range kTrain[] = {
    {1, 2},       {4, 11},     {19, 34},   {41, 76},   {120, 135}, {138, 139},  {149, 152},
    {154, 155},   {157, 168},  {170, 185}, {187, 188}, {190, 196}, {199, 200},  {202, 204},
    {206, 214},   {218, 220},  {222, 222}, {224, 264}, {283, 306}, {315, 318},  {321, 321},
    {323, 324},   {328, 328},  {347, 386}, {388, 403}, {405, 408}, {410, 459},  {461, 465},
    {467, 469},   {471, 472},  {474, 480}, {499, 502}, {504, 515}, {517, 518},  {525, 539},
    {541, 546},   {566, 566},  {568, 568}, {570, 578}, {580, 580}, {582, 600},  {639, 679},
    {681, 681},   {683, 689},  {695, 698}, {700, 701}, {703, 719}, {726, 728},  {730, 731},
    {733, 741},   {744, 744},  {746, 747}, {749, 752}, {757, 765}, {767, 769},  {786, 787},
    {789, 792},   {803, 806},  {808, 813}, {815, 817}, {819, 822}, {847, 856},  {858, 858},
    {860, 866},   {868, 873},  {875, 878}, {880, 880}, {882, 903}, {945, 945},  {947, 947},
    {949, 949},   {952, 953},  {955, 961}, {975, 984}, {988, 992}, {994, 1025}, {1044, 1058},
    {1074, 1102}, {1104, 1110}};

constexpr Range kVal[] = {{3, 3},     {12, 18},    {35, 36},   {38, 39},   {92, 110},  {221, 221},
                          {268, 278}, {329, 332},  {344, 346}, {519, 524}, {552, 565}, {625, 627},
                          {629, 630}, {632, 638},  {770, 771}, {775, 775}, {777, 778}, {780, 784},
                          {794, 800}, {802, 802},  {904, 917}, {919, 931}, {962, 963}, {966, 969},
                          {971, 972}, {1059, 1073}};

constexpr Range kTest[] = {{77, 91},   {111, 119}, {140, 140},  {142, 148}, {265, 266},
                           {279, 282}, {307, 314}, {333, 343},  {481, 498}, {547, 551},
                           {601, 604}, {606, 624}, {827, 831},  {833, 842}, {844, 846},
                           {932, 933}, {935, 943}, {1026, 1043}};

/// The devkit's list that provides a split's names.
std::string_view devkitList(const std::string& split) {
  return split == "val" || split == "test" ? std::string_view(split) : "train";
}

std::vector<int> numbersListed(std::string_view list) {
  std::vector<int> numbers;
  const auto add = [&](const Range& range) {
    for (int number = range.first; number <= range.last; ++number) numbers.push_back(number);
  };
  if (list == "val") {
    std::for_each(std::begin(kVal), std::end(kVal), add);
  } else if (list == "test") {
    std::for_each(std::begin(kTest), std::end(kTest), add);
  } else {
    std::for_each(std::begin(kTrain), std::end(kTrain), add);
  }
  return numbers;
}

std::size_t motionCount(const DatasetInfo& dataset) {
  return std::max<std::size_t>(dataset.motions.size(), 1);
}

/// The index in its list of a split's first scene, after those of earlier splits that use the same
/// list.
std::size_t firstPlace(const DatasetInfo& dataset, const std::vector<std::string>& splits,
                       std::size_t split) {
  const auto before = std::count_if(
      splits.begin(), splits.begin() + static_cast<std::ptrdiff_t>(split),
      [&](const std::string& each) { return devkitList(each) == devkitList(splits[split]); });
  return static_cast<std::size_t>(before) * motionCount(dataset);
}

}  // namespace

std::optional<std::string> sceneNameProblem(const DatasetInfo& dataset) {
  const std::vector<std::string> splits = dataset.splitFolders();
  for (std::size_t split = 0; split < splits.size(); ++split) {
    const std::string list(devkitList(splits[split]));
    const std::size_t needed = firstPlace(dataset, splits, split) + motionCount(dataset);
    const std::size_t most = numbersListed(list).size();
    if (needed <= most) continue;
    return "found " + std::to_string(needed) + " nuScenes scenes for " + list + " (one a motion " +
           "and split); it should be " + std::to_string(most) + " at most, for which the devkit " +
           "has names: fewer motions in a dataset would help";
  }
  return std::nullopt;
}

std::string sceneName(const DatasetInfo& dataset, std::int64_t sequence) {
  const std::vector<std::string> splits = dataset.splitFolders();
  const auto index = static_cast<std::size_t>(sequence);
  const std::size_t split = index / motionCount(dataset);
  const std::vector<int> numbers = numbersListed(devkitList(splits.at(split)));
  const std::size_t place = firstPlace(dataset, splits, split) + index % motionCount(dataset);
  if (place >= numbers.size()) throw Error("there are more nuScenes scenes than names");
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "scene-%04d", numbers[place]);
  return name.data();
}

}  // namespace synthetic_dataset::nuscenes
