#include "motion/bag/ros1_bag.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "base/input_file.h"
#include "base/plugin_mutex.h"
#include "motion/bag/bag_check.h"
#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

std::string reindexAdvice(const std::string& file) {
  return "; `rosbag reindex " + file + "` mends a bag whose recording was cut off";
}

/// Checks for faults that librosbag's own messages do not explain.
void checkIsBag(const std::string& file) {
  std::ifstream stream = base::openInput(file);
  // http://wiki.ros.org/Bags/Format: every bag starts with "#ROSBAG V2.0\n" (V1.2: an older one).
  const std::string magic = "#ROSBAG V";
  std::string line(magic.size() + 3, '\0');
  stream.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(stream.gcount()));
  if (line.empty()) throw Error("bag " + file + ": the file is empty");
  if (line.compare(0, magic.size(), magic) != 0) {
    const std::string fault = base::compressionFault(line);
    throw Error("bag " + file + ": " +
                (fault.empty() ? "is not a bag: a bag starts with \"#ROSBAG V2.0\"" : fault));
  }
  const std::string version = line.substr(magic.size());
  if (version.size() == 3 && version != "2.0" && version != "1.2") {
    throw Error("bag " + file + ": has format version " + version +
                "; versions 2.0 and 1.2 can be read");
  }
}

/// Runs something that reads a bag.
/// @throws Error that names the bag
template <class Read>
auto reading(const std::string& file, const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const EncryptedBag& error) {
    throw Error("bag " + file + ": " + error.what());
  } catch (const rosbag::BagUnindexedException&) {
    throw Error("bag " + file + ": has no index" + reindexAdvice(file));
  } catch (const std::exception& error) {
    throw Error("bag " + file + ": is truncated or damaged (" + error.what() + ")" +
                reindexAdvice(file));
  }
}

class Ros1Messages : public BagMessages {
 public:
  Ros1Messages(const rosbag::Bag& bag, const TopicFilter& is_read, std::optional<Stamp> recorded,
               const MessagePlaces& places)
      : view_(
            bag,
            [&](const rosbag::ConnectionInfo* connection) { return is_read(connection->topic); },
            recorded ? toRosTime(*recorded) : ros::TIME_MIN,
            recorded ? toRosTime(*recorded) : ros::TIME_MAX) {
    if (!recorded) findArrivals(places);
    message_ = view_.begin();
    end_ = view_.end();
  }

  [[nodiscard]] std::optional<Stamp> nextTime() const override {
    if (message_ == end_) return std::nullopt;
    return toStamp(message_->getTime());
  }

  [[nodiscard]] std::optional<BagMessage> next() override {
    if (message_ == end_) return std::nullopt;
    BagMessage message{message_->getTopic(), toStamp(message_->getTime())};
    const auto connection = connections_.find(message_->getConnectionHeader().get());
    if (connection != connections_.end()) {
      const Arrival& arrival = connection->second.arrivals.at(connection->second.next++);
      message.not_before = arrival.not_before;
      message.place = arrival.place;
    }
    message.publisher = message_->getCallerId();
    message.ros1 = std::make_shared<rosbag::MessageInstance>(*message_);
    ++message_;
    return message;
  }

 private:
  struct Arrival {
    Stamp not_before{0};
    MessagePlace place = 0;
  };
  struct Connection {
    std::vector<Arrival> arrivals;  ///< of its messages, in the view's order
    std::size_t next = 0;
  };

  /// Finds when each message arrived, by the order in the file: `not_before` never decreases in
  /// that order.
  void findArrivals(const MessagePlaces& places) {
    struct Message {
      Connection* connection;
      std::size_t index;
    };
    std::vector<std::pair<Arrival, Message>> messages;
    std::unordered_map<const void*, const std::vector<MessagePlace>*> places_of;
    for (const rosbag::ConnectionInfo* connection : view_.getConnections()) {
      const auto found = places.find(connection->id);
      if (found != places.end()) places_of[connection->header.get()] = &found->second;
    }
    MessagePlace in_view = 0;  // for bags of version 1.2, which do not give the places
    for (const rosbag::MessageInstance& message : view_) {
      const void* header = message.getConnectionHeader().get();
      Connection& connection = connections_[header];
      const std::size_t index = connection.arrivals.size();
      const auto known = places_of.find(header);
      const bool is_known = known != places_of.end() && index < known->second->size();
      const Arrival arrival{toStamp(message.getTime()),
                            is_known ? (*known->second)[index] : in_view};
      ++in_view;
      connection.arrivals.push_back(arrival);
      messages.push_back({arrival, {&connection, index}});
    }
    std::stable_sort(messages.begin(), messages.end(),
                     [](const auto& a, const auto& b) { return a.first.place < b.first.place; });
    Stamp latest{0};
    for (const auto& [arrival, message] : messages) {
      latest = std::max(latest, arrival.not_before);
      message.connection->arrivals[message.index].not_before = latest;
    }
  }

  rosbag::View view_;
  rosbag::View::iterator message_, end_;
  std::unordered_map<const void*, Connection> connections_;  ///< by their headers
};

struct CloseBag {
  void operator()(rosbag::Bag* bag) const {
    const std::lock_guard<std::mutex> lock(base::pluginMutex());
    delete bag;  // NOLINT(cppcoreguidelines-owning-memory): by the pointer that owns it
  }
};

/// Opens a bag, which may load the plugin that decrypts it.
std::unique_ptr<rosbag::Bag, CloseBag> openedBag(const std::string& file) {
  const std::lock_guard<std::mutex> lock(base::pluginMutex());
  return std::unique_ptr<rosbag::Bag, CloseBag>(new rosbag::Bag(file));
}

class Ros1Bag : public Bag {
 public:
  explicit Ros1Bag(const std::string& file) : file_(file) {
    checkIsBag(file);
    reading(file_, [&] {
      static_cast<void>(checkBag(file_, [](const std::string& /*topic*/) { return false; }));
      open();
    });
  }

  [[nodiscard]] const std::vector<BagTopic>& topics() const override { return topics_; }

  [[nodiscard]] const std::optional<RecordedTimes>& times() const override { return times_; }

  [[nodiscard]] std::unique_ptr<BagMessages> messages(const TopicFilter& is_read,
                                                      std::optional<Stamp> recorded) override {
    return reading(file_, [&]() -> std::unique_ptr<BagMessages> {
      // A search for a single message follows a check of all messages of its topic.
      const MessagePlaces places = recorded ? MessagePlaces{} : checkBag(file_, is_read);
      return std::make_unique<Ros1Messages>(*bag_, is_read, recorded, places);
    });
  }

  [[nodiscard]] std::string kind() const override { return "ROS 1"; }

  [[nodiscard]] std::string advice() const override { return reindexAdvice(file_); }

 private:
  void open() {
    bag_ = openedBag(file_);
    rosbag::View all(*bag_);
    if (all.size() > 0) times_ = {toStamp(all.getBeginTime()), toStamp(all.getEndTime())};
    for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
      const bool is_known = std::any_of(topics_.begin(), topics_.end(), [&](const BagTopic& each) {
        return each.name == connection->topic && each.md5sum == connection->md5sum;
      });
      if (!is_known)
        topics_.push_back({connection->topic, connection->datatype, connection->md5sum});
    }
    std::sort(topics_.begin(), topics_.end(),
              [](const BagTopic& a, const BagTopic& b) { return a.name < b.name; });
  }

  std::string file_;
  std::unique_ptr<rosbag::Bag, CloseBag> bag_;
  std::vector<BagTopic> topics_;
  std::optional<RecordedTimes> times_;
};

}  // namespace

std::unique_ptr<Bag> openRos1Bag(const std::string& file) {
  return std::make_unique<Ros1Bag>(file);
}

}  // namespace synthetic_dataset::motion
