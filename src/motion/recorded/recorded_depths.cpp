#include "motion/recorded/recorded_depths.h"

#include <variant>

#include "base/image/depth_picture.h"

namespace synthetic_dataset::motion {

RecordedDepths::RecordedDepths(const std::vector<std::string>& bag_files, const std::string& topic)
    : RecordedMessages(
          bag_files, topic, "depth image", pictureSearch(topic), [](const BagMessage& message) {
            return headOf(framedPicture(message), base::depthProblem, [](const PictureFile& file) {
              return base::checkCompressedDepth(file.bytes, file.format);
            });
          }) {}

cv::Mat RecordedDepths::read(std::size_t index) const {
  cv::Mat depth;
  show(index, [&](const BagMessage& message) {
    const RecordedPicture picture = framedPicture(message).picture;
    const auto* file = std::get_if<PictureFile>(&picture);
    depth = file != nullptr ? base::depthOfCompressed(file->bytes, file->format)
                            : base::depthOf(std::get<base::RawPicture>(picture));
  });
  return depth;
}

}  // namespace synthetic_dataset::motion
