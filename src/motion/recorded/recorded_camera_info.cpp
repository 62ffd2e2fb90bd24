#include "motion/recorded/recorded_camera_info.h"

#include <cstdint>
#include <optional>

#include "motion/bag/checked_messages.h"
#include "motion/bag/ros_time.h"
#include "motion/bag/topic_search.h"
#include "motion/frame_names.h"

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

std::string sizeOf(const sensor_msgs::CameraInfo& info) {
  return std::to_string(info.width) + " x " + std::to_string(info.height) + " pixels";
}

/// Whether two messages describe the same lens; headers do not matter.
bool isSameCamera(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  return a.distortion_model == b.distortion_model && a.K == b.K && a.D == b.D && a.R == b.R &&
         a.P == b.P && a.binning_x == b.binning_x && a.binning_y == b.binning_y && a.roi == b.roi;
}

/// A topic's calibrations, in the order in which they are recorded.
class Calibrations {
 public:
  void add(const sensor_msgs::CameraInfo& info, Stamp recorded) {
    if (!first_) {
      first_ = last_ = info;
      return;
    }
    const bool has_size = info.width == last_->width && info.height == last_->height;
    if (has_size && isSameCamera(info, *last_)) return;
    if (count_++ < kMost) {
      list_ += (list_.empty() ? "" : ", ") + (has_size ? "in its numbers" : "to " + sizeOf(info)) +
               " at " + secondsText(recorded);
    }
    last_ = info;
  }

  [[nodiscard]] const std::optional<sensor_msgs::CameraInfo>& first() const { return first_; }

  [[nodiscard]] std::vector<std::string> notes(const std::string& topic) const {
    if (count_ == 0) return {};
    const std::string more =
        count_ > kMost ? ", and " + std::to_string(count_ - kMost) + " more times" : "";
    return {"the calibration '" + topic + "' of " + sizeOf(*first_) + " changes " + list_ + more +
            "; all scenes have the first one"};
  }

 private:
  static constexpr std::int64_t kMost = 3;  // changes that are listed

  std::optional<sensor_msgs::CameraInfo> first_;
  std::optional<sensor_msgs::CameraInfo> last_;
  std::int64_t count_ = 0;
  std::string list_;
};

}  // namespace

RecordedCameraInfo readCameraInfo(const std::vector<std::string>& bag_files,
                                  const std::string& topic) {
  auto search = TopicSearch::of<sensor_msgs::CameraInfo>(topic);
  Calibrations calibrations;
  for (const std::string& file : bag_files) {
    search.in(file, [&](BagMessages& messages) {
      while (const auto message = messages.next()) {
        const auto info = message->instantiate<RecordedCalibration>();
        if (info) calibrations.add(info->message, message->recorded);
      }
    });
  }
  const auto& first = calibrations.first();
  if (!first) throw search.notFound();
  return {toValue(*first), withoutLeadingSlashes(first->header.frame_id),
          calibrations.notes(topic)};
}

}  // namespace synthetic_dataset::motion
