#include "motion/tf/bag_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "base/input_file.h"
#include "motion/bag/ros2_bag.h"
#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

std::string reindexAdvice(const std::string& file) {
  return "; `rosbag reindex " + file + "` mends a bag whose recording was cut off";
}

/// Checks what librosbag's own messages leave unsaid.
void checkIsBag(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status)) throw Error("bag " + file + ": no such file");
  if (isRos2Bag(file)) throw Error("bag " + file + ": " + convertAdvice(file));
  if (fs::is_directory(status)) throw Error("bag " + file + ": is a folder; a bag file is needed");
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

}  // namespace

template <class Read>
auto BagFile::reading(const Read& read) const -> decltype(read()) {
  try {
    return read();
  } catch (const EncryptedBag& error) {
    throw Error("bag " + file_ + ": " + error.what());
  } catch (const rosbag::BagUnindexedException&) {
    throw Error("bag " + file_ + ": has no index" + reindexAdvice(file_));
  } catch (const std::exception& error) {
    throw Error("bag " + file_ + ": is truncated or damaged (" + error.what() + ")" +
                reindexAdvice(file_));
  }
}

BagFile::BagFile(const std::string& file, std::uint32_t number) : file_(file), number_(number) {
  checkIsBag(file);
  reading([&] {
    static_cast<void>(checkBag(file, [](const std::string& /*topic*/) { return false; }));
    open();
  });
}

void BagFile::open() {
  bag_.open(file_);
  all_.addQuery(bag_);
  if (all_.size() > 0) times_ = {toStamp(all_.getBeginTime()), toStamp(all_.getEndTime())};
  for (const rosbag::ConnectionInfo* connection : all_.getConnections()) {
    const BagTopic topic{connection->topic, connection->datatype, connection->md5sum};
    const bool is_known = std::any_of(topics_.begin(), topics_.end(), [&](const BagTopic& each) {
      return each.name == topic.name && each.md5sum == topic.md5sum;
    });
    if (!is_known) topics_.push_back(topic);
  }
  std::sort(topics_.begin(), topics_.end(),
            [](const BagTopic& a, const BagTopic& b) { return a.name < b.name; });
}

void BagFile::select(const TopicReaders& readers) {
  readers_ = &readers;
  reading([&] {
    const MessagePlaces places =
        checkBag(file_, [&](const std::string& topic) { return readers.count(topic) != 0; });
    selected_.emplace(bag_, [&](const rosbag::ConnectionInfo* connection) {
      return readers.count(connection->topic) != 0;
    });
    findArrivals(places);
    message_ = selected_->begin();
    end_ = selected_->end();
  });
}

/// Orders the messages as they lie in the file: the record time of each is at least that of those
/// before it.
void BagFile::findArrivals(const MessagePlaces& places) {
  connections_.clear();
  struct Message {
    Connection* connection;
    std::size_t index;
  };
  std::vector<std::pair<Arrival, Message>> messages;
  std::unordered_map<const void*, const std::vector<MessagePlace>*> places_of;
  for (const rosbag::ConnectionInfo* connection : selected_->getConnections()) {
    const auto found = places.find(connection->id);
    if (found != places.end()) places_of[connection->header.get()] = &found->second;
  }
  MessagePlace in_view = 0;  // where a bag of version 1.2 does not say more
  for (const rosbag::MessageInstance& message : *selected_) {
    const void* header = message.getConnectionHeader().get();
    Connection& connection = connections_[header];
    const std::size_t index = connection.arrivals.size();
    const auto known = places_of.find(header);
    const bool is_known = known != places_of.end() && index < known->second->size();
    const Arrival arrival{toStamp(message.getTime()), number_,
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

Arrival BagFile::nextArrival() {
  Connection& connection = connections_[message_->getConnectionHeader().get()];
  return connection.arrivals.at(connection.next++);
}

Stamp BagFile::messageTime() const { return toStamp(message_->getTime()); }

std::vector<RecordedTransform> BagFile::takeMessage() {
  try {
    const TopicReader& reader = readers_->at(message_->getTopic());
    const Arrival arrival = nextArrival();
    const std::string publisher = message_->getCallerId();
    std::vector<RecordedTransform> transforms;
    for (geometry_msgs::TransformStamped& each : reader.read(*message_)) {
      transforms.push_back(
          {std::move(each), reader.kind, file_, messageTime(), arrival, publisher});
    }
    ++message_;
    return transforms;
  } catch (const std::exception& error) {
    throw Error("bag " + file_ + ": a message of " + message_->getTopic() +
                " cannot be read: the file is damaged (" + error.what() + ")" +
                reindexAdvice(file_));
  }
}

}  // namespace synthetic_dataset::motion
