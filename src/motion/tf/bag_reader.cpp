#include "motion/tf/bag_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "motion/tf/tf_topics.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// The bag whose next message was recorded first (for equal times, the bag that is named first), if
/// any.
BagFile* nextOf(const std::vector<BagFile*>& bags) {
  BagFile* next = nullptr;
  std::optional<Stamp> earliest;
  for (BagFile* bag : bags) {
    const auto time = bag->messageTime();
    if (!time || (earliest && *time >= *earliest)) continue;
    next = bag;
    earliest = time;
  }
  return next;
}

}  // namespace

BagReader::BagReader(const std::vector<std::string>& bag_files) {
  if (bag_files.empty()) throw ErrorList({"no bag file is named; at least one is needed"});
  std::vector<std::string> errors;
  for (const std::string& file : bag_files) {
    try {
      bags_.push_back(std::make_unique<BagFile>(file, static_cast<std::uint32_t>(bags_.size())));
    } catch (const Error& error) {
      errors.emplace_back(error.what());
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
}

RecordedTimes BagReader::times() const {
  RecordedTimes times{Stamp::max(), Stamp::min()};
  for (const auto& bag : bags_) {
    if (!bag->times()) continue;
    times.start = std::min(times.start, bag->times()->start);
    times.end = std::max(times.end, bag->times()->end);
  }
  return times;
}

std::vector<BagTopic> BagReader::topics() const {
  std::vector<BagTopic> topics;
  for (const auto& bag : bags_) {
    for (const BagTopic& topic : bag->topics()) {
      const bool is_known = std::any_of(topics.begin(), topics.end(), [&](const BagTopic& each) {
        return each.name == topic.name && each.md5sum == topic.md5sum;
      });
      if (!is_known) topics.push_back(topic);
    }
  }
  return topics;
}

std::vector<std::string> BagReader::notes() const {
  std::vector<std::string> notes;
  for (const auto& bag : bags_) {
    for (std::string& note : bag->notes()) notes.push_back(std::move(note));
  }
  return notes;
}

void BagReader::read(const TopicReaders& readers, const TransformVisitor& visit) {
  std::vector<std::string> errors;
  std::vector<BagFile*> bags;
  for (const auto& bag : bags_) {
    try {
      bag->select(readers);
      bags.push_back(bag.get());
    } catch (const Error& error) {
      errors.emplace_back(error.what());
    }
  }
  while (BagFile* bag = nextOf(bags)) {
    try {
      for (RecordedTransform& each : bag->takeMessage()) visit(std::move(each));
    } catch (const Error& error) {  // read on, to find what is wrong with the other bags
      errors.emplace_back(error.what());
      bags.erase(std::find(bags.begin(), bags.end(), bag));
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
}

RecordedTimes readTransforms(const std::vector<std::string>& bag_files,
                             const TransformVisitor& visit) {
  BagReader bags(bag_files);
  const TfTopics topics = findTfTopics(bags);
  if (topics.readers.empty()) throw ErrorList(noTransforms(bags));
  bags.read(topics.readers, visit);
  return bags.times();
}

}  // namespace synthetic_dataset::motion
