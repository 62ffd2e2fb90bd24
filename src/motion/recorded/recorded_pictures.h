#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/image/picture_size.h"
#include "base/image/raw_picture.h"
#include "motion/bag/bag.h"
#include "motion/bag/message_index.h"
#include "motion/bag/topic_search.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A picture as a file: sensor_msgs/CompressedImage.
struct PictureFile {
  std::string format;  ///< from the message: "jpeg", "rgb8; jpeg compressed bgr8"
  std::vector<std::uint8_t> bytes;
};

using RecordedPicture = std::variant<base::RawPicture, PictureFile>;

/// A summary of a picture, without its pixels.
struct PictureHead {
  Stamp stamp{0};            ///< of the message's header
  std::string frame = {};    ///< of the header, without leading slashes
  std::uint32_t width = 0;   ///< [px]; 0 where there is a problem
  std::uint32_t height = 0;  ///< [px]; 0 where there is a problem
  std::string problem = {};  ///< why it cannot be read: "has the encoding 'x', which ..."
};

/// The pictures of a topic of type sensor_msgs/Image or sensor_msgs/CompressedImage, in bags that
/// count as one recording.
class RecordedPictures : public RecordedMessages<PictureHead> {
 public:
  /// Reads all messages of the topic, and remembers where they are.
  /// @param bag_files  bags that can be read
  /// @throws Error if no bag has such a topic, its messages are of another type or have no stamps,
  ///     or their stamps go back in time
  RecordedPictures(const std::vector<std::string>& bag_files, const std::string& topic);

  [[nodiscard]] const std::string& topic() const { return topic_; }

  /// Reads a picture of heads(). May be called in any thread.
  /// @throws Error naming the bag, if it cannot be read any more
  [[nodiscard]] RecordedPicture read(std::size_t index) const;

 private:
  std::string topic_;
};

/// "the picture of '/camera/image_raw' at 12.340000000 s", for messages.
[[nodiscard]] std::string pictureName(const std::string& topic, Stamp stamp);

/// A message's picture, with its header.
struct FramedPicture {
  Stamp stamp{0};
  std::string frame;  ///< without leading slashes
  RecordedPicture picture;
};

/// A search for messages of either type.
[[nodiscard]] TopicSearch pictureSearch(const std::string& topic);

/// Reads a sensor_msgs/Image or a sensor_msgs/CompressedImage.
/// @throws Error for any other message
[[nodiscard]] FramedPicture framedPicture(const BagMessage& message);

/// Summarizes a picture without decoding it.
/// @param problem_of  returns why a raw picture cannot be read, if so
/// @param size_of  returns the size of a picture that is a file; throws Error if it cannot be read
[[nodiscard]] PictureHead headOf(
    const FramedPicture& framed,
    const std::function<std::optional<std::string>(const base::RawPicture&)>& problem_of,
    const std::function<base::PictureSize(const PictureFile&)>& size_of);

}  // namespace synthetic_dataset::motion
