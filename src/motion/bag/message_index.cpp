#include "motion/bag/message_index.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// Where a message is: the `rank`-th of its topic with that record time, from 0.
struct IndexedPlace {
  std::size_t bag = 0;
  Stamp recorded{0};
  std::size_t rank = 0;
};

struct FoundMessage {
  Stamp stamp{0};
  std::size_t index = 0;  ///< among those that were looked at
  IndexedPlace place;
};

/// Rejects stamps that go back, as then messages of two different moments may have the same stamp.
void checkOrder(std::vector<FoundMessage>& found, const std::string& noun) {
  constexpr Duration kLate = std::chrono::seconds(1);  // tolerated: such messages are merely late
  std::stable_sort(found.begin(), found.end(), [](const FoundMessage& a, const FoundMessage& b) {
    return a.place.recorded < b.place.recorded;
  });
  Stamp latest{0};
  for (const FoundMessage& each : found) {
    if (each.stamp == Stamp{0}) {
      throw Error("its " + noun + " recorded at " + secondsText(each.place.recorded) +
                  " has no stamp in its header; without one, it is unknown when it was taken");
    }
    if (each.stamp + kLate < latest) {
      throw Error("the stamps of its " + noun + "s go back from " + secondsText(latest) + " to " +
                  secondsText(each.stamp) +
                  ", as when a simulation is reset; bag_file should name a recording without that "
                  "(`rosbag filter` cuts bags)");
    }
    latest = std::max(latest, each.stamp);
  }
}

}  // namespace

struct MessageIndex::Impl {
  /// @param messages  of one bag
  void take(std::size_t bag, BagMessages& messages, const Look& look,
            std::vector<FoundMessage>& found) {
    std::optional<Stamp> last;
    std::size_t rank = 0;
    while (const auto message = messages.next()) {
      names[bag].insert(message->topic);
      rank = message->recorded == last ? rank + 1 : 0;
      last = message->recorded;
      const std::size_t index = found.size();
      found.push_back({look(*message), index, {bag, message->recorded, rank}});
    }
  }

  void keep(std::vector<FoundMessage> found, const std::string& noun) {
    checkOrder(found, noun);
    std::stable_sort(found.begin(), found.end(), [](const FoundMessage& a, const FoundMessage& b) {
      return a.stamp < b.stamp;
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i > 0 && found[i - 1].stamp == found[i].stamp) {
        ++repeated;
        continue;
      }
      order.push_back(found[i].index);
      places.push_back(found[i].place);
    }
  }

  /// @return whether the message is still there
  bool show(const IndexedPlace& place, const std::function<void(const BagMessage& message)>& see) {
    const std::lock_guard<std::mutex> lock(mutex);
    auto& bag = bags[place.bag];
    if (!bag) bag = openBag(files[place.bag]);
    const std::set<std::string>& topics = names.at(place.bag);
    const auto messages = bag->messages(
        [&](const std::string& each) { return topics.count(each) != 0; }, place.recorded);
    std::size_t rank = 0;
    while (const auto message = messages->next()) {
      if (rank++ != place.rank) continue;
      see(*message);
      return true;
    }
    return false;
  }

  std::vector<std::string> files;
  std::string topic;
  std::map<std::size_t, std::set<std::string>> names;  ///< the topic's names, by bag
  std::vector<std::size_t> order;
  std::vector<IndexedPlace> places;  ///< in the order of `order`
  std::int64_t repeated = 0;
  std::mutex mutex;
  std::map<std::size_t, std::unique_ptr<Bag>> bags;  ///< those that were opened
};

MessageIndex::MessageIndex(const std::vector<std::string>& bag_files, const std::string& topic,
                           const std::string& noun, TopicSearch search, const Look& look)
    : impl_(std::make_unique<Impl>()) {
  impl_->files = bag_files;
  impl_->topic = topic;
  std::vector<FoundMessage> found;
  for (std::size_t bag = 0; bag < bag_files.size(); ++bag) {
    search.in(bag_files[bag],
              [&](BagMessages& messages) { impl_->take(bag, messages, look, found); });
  }
  if (found.empty()) throw search.notFound();
  try {
    impl_->keep(std::move(found), noun);
  } catch (const Error& error) {
    throw Error("found '" + topic + "'; " + error.what());
  }
}

MessageIndex::~MessageIndex() = default;
MessageIndex::MessageIndex(MessageIndex&&) noexcept = default;
MessageIndex& MessageIndex::operator=(MessageIndex&&) noexcept = default;

std::int64_t MessageIndex::repeatedCount() const { return impl_->repeated; }

const std::vector<std::size_t>& MessageIndex::order() const { return impl_->order; }

void MessageIndex::read(std::size_t index,
                        const std::function<void(const BagMessage& message)>& see) const {
  const IndexedPlace& place = impl_->places.at(index);
  const std::string bag = "bag " + impl_->files[place.bag] + ": ";
  bool is_there = false;
  try {
    is_there = impl_->show(place, see);
  } catch (const std::exception& error) {
    throw Error(bag + error.what());
  }
  if (is_there) return;
  throw Error(bag + "the message of '" + impl_->topic + "' recorded at " +
              secondsText(place.recorded) + " is no longer there");
}

}  // namespace synthetic_dataset::motion
