#include "world/shape/height_picture.h"

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/image/picture_decoder.h"
#include "base/input_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {

NumberPicture readNumbers(const std::filesystem::path& file) {
  const std::string name = "picture '" + file.string() + "': ";
  const std::vector<std::uint8_t> bytes = base::readInputBytes(file);
  if (bytes.empty()) throw Error(name + "is empty");
  cv::Mat picture;
  try {
    picture = base::decodePixels(bytes, file.string());
  } catch (const Error& error) {
    throw Error(name + error.what());
  }
  cv::Mat rgb;
  if (picture.channels() == 1) {
    cv::cvtColor(picture, rgb, cv::COLOR_GRAY2RGB);
  } else {
    cv::cvtColor(picture, rgb, picture.channels() == 4 ? cv::COLOR_BGRA2RGB : cv::COLOR_BGR2RGB);
  }
  const bool has_eight_bits = picture.depth() == CV_8U;
  rgb.convertTo(rgb, CV_32F, 1.0 / (has_eight_bits ? 255.0 : 65535.0));
  return {rgb, has_eight_bits};
}

}  // namespace synthetic_dataset::world
