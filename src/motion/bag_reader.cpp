#include "motion/bag_reader.h"

#include <algorithm>
#include <memory>

#include "motion/bag_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

using Bags = std::vector<std::unique_ptr<BagFile>>;

Bags openBags(const std::vector<std::string>& files) {
  Bags bags;
  std::vector<std::string> errors;
  for (const std::string& file : files) {
    try {
      bags.push_back(std::make_unique<BagFile>(file));
    } catch (const Error& error) {
      errors.emplace_back(error.what());
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
  return bags;
}

/// Bags without transforms are fine beside one that has some.
void checkAnyTransforms(const Bags& bags) {
  std::vector<std::string> errors;
  for (const auto& bag : bags) {
    if (bag->hasMessage()) return;
    errors.push_back("bag " + bag->file() + ": " +
                     (bag->times()
                          ? "no messages of /tf or /tf_static; its topics are " + bag->topics()
                          : std::string("has no messages")));
  }
  throw ErrorList(errors);
}

RecordedTimes timesOf(const Bags& bags) {
  RecordedTimes times{Stamp::max(), Stamp::min()};
  for (const auto& bag : bags) {
    if (!bag->times()) continue;
    times.start = std::min(times.start, bag->times()->start);
    times.end = std::max(times.end, bag->times()->end);
  }
  return times;
}

/// The bag whose next message was recorded first (of equal times the bag named first), if any.
BagFile* nextOf(const Bags& bags) {
  BagFile* next = nullptr;
  for (const auto& bag : bags) {
    if (!bag->hasMessage()) continue;
    if (next == nullptr || bag->messageTime() < next->messageTime()) next = bag.get();
  }
  return next;
}

}  // namespace

RecordedTimes readTransforms(const std::vector<std::string>& bag_files,
                             const TransformVisitor& visit) {
  if (bag_files.empty()) throw ErrorList({"no bag file is named; at least one is needed"});
  Bags bags = openBags(bag_files);
  checkAnyTransforms(bags);
  const RecordedTimes times = timesOf(bags);
  std::vector<std::string> errors;
  while (BagFile* bag = nextOf(bags)) {
    const TransformKind kind = bag->messageKind();
    try {
      for (const auto& transform : bag->takeMessage()) visit(transform, kind, bag->file());
    } catch (const Error& error) {  // read on, to find what is wrong with the other bags
      errors.emplace_back(error.what());
      bags.erase(std::find_if(bags.begin(), bags.end(),
                              [bag](const auto& other) { return other.get() == bag; }));
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
  return times;
}

}  // namespace synthetic_dataset::motion
