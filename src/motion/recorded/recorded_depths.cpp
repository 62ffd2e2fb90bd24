#include "motion/recorded/recorded_depths.h"

#include <optional>
#include <utility>

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include "base/image/depth_picture.h"
#include "motion/bag/message_index.h"
#include "motion/recorded/recorded_pictures.h"

namespace synthetic_dataset::motion {

struct RecordedDepths::Impl {
  std::vector<PictureHead> heads;
  std::optional<MessageIndex> messages;  ///< of heads
};

RecordedDepths::RecordedDepths(const std::vector<std::string>& bag_files, const std::string& topic)
    : impl_(std::make_unique<Impl>()) {
  std::vector<PictureHead> looked_at;
  impl_->messages.emplace(
      bag_files, topic, "depth image",
      TopicSearch::of<sensor_msgs::Image, sensor_msgs::CompressedImage>(topic),
      [&](const BagMessage& message) {
        looked_at.push_back(
            headOf(framedPicture(message), base::depthProblem, [](const PictureFile& file) {
              return base::checkCompressedDepth(file.bytes, file.format);
            }));
        return looked_at.back().stamp;
      });
  impl_->heads = impl_->messages->inOrder(std::move(looked_at));
}

RecordedDepths::~RecordedDepths() = default;
RecordedDepths::RecordedDepths(RecordedDepths&&) noexcept = default;
RecordedDepths& RecordedDepths::operator=(RecordedDepths&&) noexcept = default;

const std::vector<PictureHead>& RecordedDepths::heads() const { return impl_->heads; }

cv::Mat RecordedDepths::read(std::size_t index) const {
  cv::Mat depth;
  impl_->messages->read(index, [&](const BagMessage& message) {
    const RecordedPicture picture = framedPicture(message).picture;
    const auto* file = std::get_if<PictureFile>(&picture);
    depth = file != nullptr ? base::depthOfCompressed(file->bytes, file->format)
                            : base::depthOf(std::get<base::RawPicture>(picture));
  });
  return depth;
}

}  // namespace synthetic_dataset::motion
