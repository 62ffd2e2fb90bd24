#include "motion/recorded_camera_info.h"

#include <cstdint>
#include <optional>

#include "motion/checked_messages.h"
#include "motion/frame_names.h"
#include "motion/topic_search.h"

namespace synthetic_dataset::motion {
namespace {

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

/// The bag's first message of the search's topic, or nothing.
std::optional<sensor_msgs::CameraInfo> firstIn(const std::string& file, TopicSearch& search) {
  std::optional<sensor_msgs::CameraInfo> first;
  search.in(file, [&](rosbag::View& messages) {
    for (const rosbag::MessageInstance& message : messages) {
      const auto info = message.instantiate<RecordedCalibration>();
      if (!info) continue;
      first = info->message;
      return;
    }
  });
  return first;
}

}  // namespace

RecordedCameraInfo readCameraInfo(const std::vector<std::string>& bag_files,
                                  const std::string& topic) {
  auto search = TopicSearch::of<sensor_msgs::CameraInfo>(topic);
  for (const std::string& file : bag_files) {
    const auto message = firstIn(file, search);
    if (message) return {toValue(*message), withoutLeadingSlashes(message->header.frame_id)};
  }
  throw search.notFound();
}

}  // namespace synthetic_dataset::motion
