#include "motion/bag_file.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "motion/bag_check.h"
#include "motion/checked_messages.h"
#include "motion/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// The topic as a bag may have it, with or without the slash.
std::optional<TransformKind> transformTopic(const std::string& topic) {
  if (topic == "/tf" || topic == "tf") return TransformKind::kMoving;
  if (topic == "/tf_static" || topic == "tf_static") return TransformKind::kStatic;
  return std::nullopt;
}

std::string reindexAdvice(const std::string& file) {
  return "; `rosbag reindex " + file + "` mends a bag whose recording was cut off";
}

/// Checks what librosbag's own messages leave unsaid.
void checkIsBag(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status)) throw Error("bag " + file + ": no such file");
  if (fs::is_directory(status)) throw Error("bag " + file + ": is a folder; a bag file is needed");
  if (!fs::is_regular_file(status)) throw Error("bag " + file + ": is no file but a device");

  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("bag " + file + ": cannot be opened for reading");
  // http://wiki.ros.org/Bags/Format: every bag starts with "#ROSBAG V2.0\n" (V1.2: an older one).
  const std::string magic = "#ROSBAG V";
  std::string line(magic.size() + 3, '\0');
  stream.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(stream.gcount()));
  if (line.empty()) throw Error("bag " + file + ": the file is empty");
  if (line.compare(0, magic.size(), magic) != 0) {
    throw Error("bag " + file + ": is not a bag: a bag starts with \"#ROSBAG V2.0\"");
  }
  const std::string version = line.substr(magic.size());
  if (version.size() == 3 && version != "2.0" && version != "1.2") {
    throw Error("bag " + file + ": has format version " + version +
                "; versions 2.0 and 1.2 can be read");
  }
}

}  // namespace

BagFile::BagFile(const std::string& file) : file_(file) {
  checkIsBag(file);
  try {
    checkBag(file, [](const std::string& topic) { return transformTopic(topic).has_value(); });
    open();
  } catch (const EncryptedBag& error) {
    throw Error("bag " + file + ": " + error.what());
  } catch (const rosbag::BagUnindexedException&) {
    throw Error("bag " + file + ": has no index" + reindexAdvice(file));
  } catch (const std::exception& error) {
    throw Error("bag " + file + ": is truncated or damaged (" + error.what() + ")" +
                reindexAdvice(file));
  }
  checkTypes();
}

void BagFile::open() {
  bag_.open(file_);
  all_.addQuery(bag_);
  if (all_.size() > 0) times_ = {toStamp(all_.getBeginTime()), toStamp(all_.getEndTime())};
  transforms_.addQuery(bag_, [](const rosbag::ConnectionInfo* connection) {
    return transformTopic(connection->topic).has_value();
  });
  message_ = transforms_.begin();
  end_ = transforms_.end();
}

void BagFile::checkTypes() {
  using Traits = ros::message_traits::MD5Sum<tf2_msgs::TFMessage>;
  for (const rosbag::ConnectionInfo* connection : all_.getConnections()) {
    // By its checksum, as librosbag does: tf/tfMessage of tf version 1 has the same content.
    if (!transformTopic(connection->topic) || connection->md5sum == Traits::value()) continue;
    throw Error("bag " + file_ + ": topic " + connection->topic + " has messages of type " +
                connection->datatype + " (md5sum " + connection->md5sum +
                "); tf2_msgs/TFMessage (md5sum " + Traits::value() + ") is needed");
  }
}

std::string BagFile::topics() {
  std::map<std::string, std::string> types;
  for (const rosbag::ConnectionInfo* connection : all_.getConnections()) {
    types[connection->topic] = connection->datatype;
  }
  std::string list;
  for (const auto& [topic, type] : types) {
    list += (list.empty() ? "" : ", ") + topic + " (" + type + ")";
  }
  return list;
}

Stamp BagFile::messageTime() const { return toStamp(message_->getTime()); }

TransformKind BagFile::messageKind() const { return *transformTopic(message_->getTopic()); }

std::vector<geometry_msgs::TransformStamped> BagFile::takeMessage() {
  try {
    const auto recorded = message_->instantiate<RecordedTransforms>();
    ++message_;
    return std::move(recorded->message.transforms);
  } catch (const std::exception& error) {
    throw Error("bag " + file_ + ": a message of " + message_->getTopic() +
                " cannot be read: the file is damaged (" + error.what() + ")" +
                reindexAdvice(file_));
  }
}

}  // namespace synthetic_dataset::motion
