#include "motion/tf/bag_file.h"

#include <exception>
#include <utility>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

void BagFile::select(const TopicReaders& readers) {
  readers_ = &readers;
  messages_ = bag_->messages([&](const std::string& topic) { return readers.count(topic) != 0; });
}

std::vector<RecordedTransform> BagFile::takeMessage() {
  std::string topic;
  try {
    BagMessage message = *messages_->next();
    topic = message.topic;
    const TopicReader& reader = readers_->at(topic);
    std::vector<RecordedTransform> transforms;
    for (geometry_msgs::TransformStamped& each : reader.read(message)) {
      transforms.push_back({std::move(each), reader.kind, file_, message.recorded,
                            Arrival{message.not_before, number_, message.place},
                            message.publisher});
    }
    return transforms;
  } catch (const std::exception& error) {
    throw Error("bag " + file_ + ": a message of " + topic +
                " cannot be read: the file is damaged (" + error.what() + ")" + bag_->advice());
  }
}

}  // namespace synthetic_dataset::motion
