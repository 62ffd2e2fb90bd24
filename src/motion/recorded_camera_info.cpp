#include "motion/recorded_camera_info.h"

#include <exception>
#include <optional>
#include <set>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "motion/bag_check.h"
#include "motion/checked_messages.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::motion {
namespace {

using Traits = ros::message_traits::MD5Sum<sensor_msgs::CameraInfo>;

std::string withoutSlash(const std::string& topic) {
  return topic.empty() || topic.front() != '/' ? topic : topic.substr(1);
}

template <class Numbers>
Value listOf(const Numbers& numbers) {
  Value::List list;
  for (const double number : numbers) list.emplace_back(number);
  return Value(list);
}

Value wholeNumber(std::uint32_t number) { return Value(static_cast<std::int64_t>(number)); }

Value toValue(const sensor_msgs::CameraInfo& message) {
  Value::Map map = {{"width", wholeNumber(message.width)},
                    {"height", wholeNumber(message.height)},
                    {"distortion_model", Value(message.distortion_model)},
                    {"K", listOf(message.K)},
                    {"D", listOf(message.D)},
                    {"R", listOf(message.R)},
                    {"P", listOf(message.P)},
                    {"binning_x", wholeNumber(message.binning_x)},
                    {"binning_y", wholeNumber(message.binning_y)}};
  map["roi"] = Value(Value::Map{{"x_offset", wholeNumber(message.roi.x_offset)},
                                {"y_offset", wholeNumber(message.roi.y_offset)},
                                {"width", wholeNumber(message.roi.width)},
                                {"height", wholeNumber(message.roi.height)},
                                {"do_rectify", Value(message.roi.do_rectify != 0)}});
  return Value(map);
}

/// What is known of the bags' topics when the wanted one is sought.
struct Search {
  std::set<std::string> cameras;  ///< topics of the right type
  std::string other_type;         ///< that of the wanted topic, where it is not CameraInfo
};

/// The bag's first message of the topic, or nothing.
std::optional<sensor_msgs::CameraInfo> findIn(const std::string& file, const std::string& topic,
                                              Search& search) {
  const std::string name = withoutSlash(topic);
  checkBag(file, [&](const std::string& other) { return withoutSlash(other) == name; });
  rosbag::Bag bag(file);
  rosbag::View all(bag);
  std::vector<std::string> names;
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    const bool right_type = connection->md5sum == Traits::value();
    if (right_type) search.cameras.insert(connection->topic);
    if (withoutSlash(connection->topic) != name) continue;
    if (right_type) {
      names.push_back(connection->topic);
    } else {
      search.other_type = connection->datatype;
    }
  }
  if (names.empty()) return std::nullopt;
  rosbag::View view(bag, rosbag::TopicQuery(names));
  for (const rosbag::MessageInstance& message : view) {
    if (const auto info = message.instantiate<RecordedCalibration>()) return info->message;
  }
  return std::nullopt;
}

Error notFound(const std::string& topic, const Search& search) {
  if (!search.other_type.empty()) {
    return Error("found '" + topic + "', whose messages are " + search.other_type +
                 "; they should be sensor_msgs/CameraInfo");
  }
  std::string there;
  std::vector<std::string> names;
  for (const std::string& camera : search.cameras) {
    there += (there.empty() ? "" : ", ") + camera;
    names.push_back(camera);
  }
  return Error("found '" + topic + "', a topic that the recording does not have; of type " +
               "sensor_msgs/CameraInfo it has " + (there.empty() ? "none" : there) +
               didYouMean(topic, names));
}

}  // namespace

RecordedCameraInfo readCameraInfo(const std::vector<std::string>& bag_files,
                                  const std::string& topic) {
  Search search;
  for (const std::string& file : bag_files) {
    try {
      const auto message = findIn(file, topic, search);
      if (message) {
        return {toValue(*message), withoutLeadingSlashes(message->header.frame_id)};
      }
    } catch (const std::exception& error) {
      throw Error("bag " + file + ": " + error.what());
    }
  }
  throw notFound(topic, search);
}

}  // namespace synthetic_dataset::motion
