#include "motion/recorded/recorded_pictures.h"

#include <utility>

#include "base/image/picture_decoder.h"
#include "motion/bag/checked_messages.h"
#include "motion/bag/ros_time.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// The image size of a file; errors begin with the file's format.
base::PictureSize sizeOf(const PictureFile& file, const std::string& topic) {
  try {
    return base::checkPicture(file.bytes, topic);
  } catch (const Error& error) {
    throw Error("of format '" + file.format + "' " + error.what());
  }
}

}  // namespace

TopicSearch pictureSearch(const std::string& topic) {
  return TopicSearch::of<sensor_msgs::Image, sensor_msgs::CompressedImage>(topic);
}

FramedPicture framedPicture(const BagMessage& message) {
  if (const auto raw = message.instantiate<RecordedImage>()) {
    sensor_msgs::Image& image = raw->message;
    return {toStamp(image.header.stamp), withoutLeadingSlashes(image.header.frame_id),
            base::RawPicture{image.width, image.height, image.encoding, image.is_bigendian != 0,
                             image.step, std::move(image.data)}};
  }
  const auto file = message.instantiate<RecordedImageFile>();
  if (!file) throw Error("a message of '" + message.topic + "' is not a picture");
  return {toStamp(file->message.header.stamp), withoutLeadingSlashes(file->message.header.frame_id),
          PictureFile{file->message.format, std::move(file->message.data)}};
}

PictureHead headOf(
    const FramedPicture& framed,
    const std::function<std::optional<std::string>(const base::RawPicture&)>& problem_of,
    const std::function<base::PictureSize(const PictureFile&)>& size_of) {
  PictureHead head{framed.stamp, framed.frame};
  if (const auto* raw = std::get_if<base::RawPicture>(&framed.picture)) {
    head.problem = problem_of(*raw).value_or("");
    if (!head.problem.empty()) return head;
    head.width = raw->width;
    head.height = raw->height;
    return head;
  }
  try {
    const base::PictureSize size = size_of(std::get<PictureFile>(framed.picture));
    head.width = static_cast<std::uint32_t>(size.width);
    head.height = static_cast<std::uint32_t>(size.height);
  } catch (const Error& error) {
    head.problem = error.what();
  }
  return head;
}

RecordedPictures::RecordedPictures(const std::vector<std::string>& bag_files,
                                   const std::string& topic)
    : RecordedMessages(bag_files, topic, "picture", pictureSearch(topic),
                       [&](const BagMessage& message) {
                         return headOf(
                             framedPicture(message), base::pictureProblem,
                             [&](const PictureFile& file) { return sizeOf(file, topic); });
                       }),
      topic_(topic) {}

RecordedPicture RecordedPictures::read(std::size_t index) const {
  RecordedPicture picture;
  show(index, [&](const BagMessage& message) { picture = framedPicture(message).picture; });
  return picture;
}

std::string pictureName(const std::string& topic, Stamp stamp) {
  return "the picture of '" + topic + "' at " + secondsText(stamp);
}

}  // namespace synthetic_dataset::motion
