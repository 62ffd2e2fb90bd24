#include "base/image/raw_picture.h"

#include <algorithm>
#include <map>

#include <opencv2/imgproc.hpp>

#include "base/image/picture_decoder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

constexpr int kAsItIs = -1;

struct Encoding {
  int type;                  ///< of OpenCV
  int conversion = kAsItIs;  ///< to blue, green, red
};

/// http://docs.ros.org/en/noetic/api/sensor_msgs/html/image__encodings_8h_source.html. OpenCV names
/// a Bayer mosaic by the second row's second and third pixel, ROS by the first two.
const std::map<std::string, Encoding>& encodings() {
  static const std::map<std::string, Encoding> kEncodings = {
      {"mono8", {CV_8UC1, cv::COLOR_GRAY2BGR}},
      {"8UC1", {CV_8UC1, cv::COLOR_GRAY2BGR}},
      {"mono16", {CV_16UC1, cv::COLOR_GRAY2BGR}},
      {"16UC1", {CV_16UC1, cv::COLOR_GRAY2BGR}},
      {"bgr8", {CV_8UC3}},
      {"8UC3", {CV_8UC3}},
      {"bgr16", {CV_16UC3}},
      {"16UC3", {CV_16UC3}},
      {"rgb8", {CV_8UC3, cv::COLOR_RGB2BGR}},
      {"rgb16", {CV_16UC3, cv::COLOR_RGB2BGR}},
      {"bgra8", {CV_8UC4, cv::COLOR_BGRA2BGR}},
      {"8UC4", {CV_8UC4, cv::COLOR_BGRA2BGR}},
      {"bgra16", {CV_16UC4, cv::COLOR_BGRA2BGR}},
      {"16UC4", {CV_16UC4, cv::COLOR_BGRA2BGR}},
      {"rgba8", {CV_8UC4, cv::COLOR_RGBA2BGR}},
      {"rgba16", {CV_16UC4, cv::COLOR_RGBA2BGR}},
      {"bayer_rggb8", {CV_8UC1, cv::COLOR_BayerBG2BGR}},
      {"bayer_bggr8", {CV_8UC1, cv::COLOR_BayerRG2BGR}},
      {"bayer_gbrg8", {CV_8UC1, cv::COLOR_BayerGR2BGR}},
      {"bayer_grbg8", {CV_8UC1, cv::COLOR_BayerGB2BGR}},
      {"bayer_rggb16", {CV_16UC1, cv::COLOR_BayerBG2BGR}},
      {"bayer_bggr16", {CV_16UC1, cv::COLOR_BayerRG2BGR}},
      {"bayer_gbrg16", {CV_16UC1, cv::COLOR_BayerGR2BGR}},
      {"bayer_grbg16", {CV_16UC1, cv::COLOR_BayerGB2BGR}},
      {"yuv422", {CV_8UC2, cv::COLOR_YUV2BGR_UYVY}},
      {"uyvy", {CV_8UC2, cv::COLOR_YUV2BGR_UYVY}},
      {"yuv422_yuy2", {CV_8UC2, cv::COLOR_YUV2BGR_YUY2}},
      {"yuyv", {CV_8UC2, cv::COLOR_YUV2BGR_YUY2}}};
  return kEncodings;
}

std::string sizeText(const RawPicture& picture) {
  return std::to_string(picture.width) + " x " + std::to_string(picture.height) + " pixels";
}

/// Reverses the byte order of multi-byte values.
void swapBytes(cv::Mat& pixels) {
  const std::size_t size = pixels.elemSize1();
  for (int row = 0; row < pixels.rows && size > 1; ++row) {
    uchar* const begin = pixels.ptr(row);
    uchar* const end = begin + static_cast<std::size_t>(pixels.cols) * pixels.elemSize();
    for (uchar* value = begin; value != end; value += size) std::reverse(value, value + size);
  }
}

cv::Mat toEightBits(const cv::Mat& colours) {
  if (colours.depth() != CV_16U) return colours;
  cv::Mat bytes;
  colours.convertTo(bytes, CV_8U, 255.0 / 65535.0);
  return bytes;
}

cv::Mat converted(const cv::Mat& pixels, int conversion) {
  if (conversion == kAsItIs) return toEightBits(pixels);
  cv::Mat colours;
  cv::cvtColor(pixels, colours, conversion);
  return toEightBits(colours);
}

/// The pixels in this machine's byte order.
cv::Mat pixelsOf(const RawPicture& picture) {
  const int type = encodings().at(picture.encoding).type;
  cv::Mat pixels(static_cast<int>(picture.height), static_cast<int>(picture.width), type);
  const std::size_t row_size = picture.width * pixels.elemSize();
  for (std::size_t row = 0; row < picture.height; ++row) {
    const auto begin = picture.data.begin() + static_cast<std::ptrdiff_t>(row * picture.step);
    std::copy(begin, begin + static_cast<std::ptrdiff_t>(row_size),
              pixels.ptr(static_cast<int>(row)));
  }
  // Every system that ROS 1 runs on is little endian.
  if (picture.is_bigendian) swapBytes(pixels);
  return pixels;
}

std::optional<std::string> sizeProblem(const RawPicture& picture, const Encoding& encoding) {
  if (picture.width == 0 || picture.height == 0 || picture.width > kLongestPictureSide ||
      picture.height > kLongestPictureSide) {
    return "has " + sizeText(picture) + "; a side should be 1 to " +
           std::to_string(kLongestPictureSide) + " pixels";
  }
  if (encoding.type == CV_8UC2 && picture.width % 2 != 0) {
    return "has " + sizeText(picture) + " of encoding " + picture.encoding +
           ", which are stored in pairs; its width should be even";
  }
  const std::size_t row = picture.width * static_cast<std::size_t>(CV_ELEM_SIZE(encoding.type));
  if (picture.step < row) {
    return "has rows of " + std::to_string(picture.step) + " bytes (step); " +
           std::to_string(picture.width) + " pixels of encoding " + picture.encoding + " need " +
           std::to_string(row);
  }
  const std::size_t needed = picture.step * (picture.height - 1) + row;
  if (picture.data.size() >= needed) return std::nullopt;
  return "has " + std::to_string(picture.data.size()) + " bytes; its " + sizeText(picture) +
         " need " + std::to_string(needed);
}

}  // namespace

std::optional<std::string> pictureProblem(const RawPicture& picture) {
  const auto found = encodings().find(picture.encoding);
  if (found != encodings().end()) return sizeProblem(picture, found->second);
  std::string known;
  for (const auto& [name, encoding] : encodings()) known += (known.empty() ? "" : ", ") + name;
  return "has the encoding '" + picture.encoding + "', which cannot be read; " + known + " can";
}

cv::Mat coloursOf(const RawPicture& picture) {
  if (const auto problem = pictureProblem(picture)) throw Error(*problem);
  const cv::Mat pixels = pixelsOf(picture);
  return converted(pixels, encodings().at(picture.encoding).conversion);
}

cv::Mat coloursOf(const cv::Mat& decoded) {
  switch (decoded.channels()) {
    case 1:
      return converted(decoded, cv::COLOR_GRAY2BGR);
    case 4:
      return converted(decoded, cv::COLOR_BGRA2BGR);
    default:
      return converted(decoded, kAsItIs);
  }
}

}  // namespace synthetic_dataset::base
