#include "base/image/depth_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/image/picture_decoder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

constexpr double kMillimetre = 1e-3;  // [m]

/// The header before the PNG file (compressed_depth_image_transport/compression_common.h): an enum
/// of 4 bytes, and the two parameters by which inverse depths were quantised.
constexpr std::size_t kHeaderSize = 12;

struct DepthQuantisation {
  float a = 0.0F;
  float b = 0.0F;
};

bool isMillimetres(const std::string& encoding) {
  return encoding == "16UC1" || encoding == "mono16";
}

/// The encoding of the pixels before compression, with which the format begins.
std::string encodingOf(const std::string& format) { return format.substr(0, format.find(';')); }

/// Sets unmeasured pixels, which are NaN, infinite or negative, to 0.
cv::Mat withoutGaps(cv::Mat_<float> depth) {
  for (float& each : depth) {
    if (!(each > 0.0F) || !std::isfinite(each)) each = 0.0F;
  }
  return std::move(depth);
}

cv::Mat ofMillimetres(const cv::Mat& numbers) {
  cv::Mat depth;
  numbers.convertTo(depth, CV_32F, kMillimetre);
  return depth;
}

/// The pixels without gaps between rows, in this machine's byte order.
cv::Mat rowsOf(const RawPicture& picture, int type) {
  cv::Mat pixels(static_cast<int>(picture.height), static_cast<int>(picture.width), type);
  const std::size_t size = pixels.elemSize();
  for (std::size_t row = 0; row < picture.height; ++row) {
    uchar* const begin = pixels.ptr(static_cast<int>(row));
    std::copy_n(picture.data.begin() + static_cast<std::ptrdiff_t>(row * picture.step),
                picture.width * size, begin);
    if (!picture.is_bigendian) continue;
    for (uchar* value = begin; value != begin + picture.width * size; value += size) {
      std::reverse(value, value + size);
    }
  }
  return pixels;
}

std::vector<std::uint8_t> pngOf(const std::vector<std::uint8_t>& file, const std::string& format) {
  const std::string encoding = encodingOf(format);
  if (format.find("compressedDepth") == std::string::npos) {
    throw Error("has the format '" + format +
                "'; it should be '16UC1; compressedDepth png' or '32FC1; compressedDepth png' (the "
                "topic .../compressedDepth), as JPEG and others do not keep depths");
  }
  if (format.find("rvl") != std::string::npos ||
      (!isMillimetres(encoding) && encoding != "32FC1")) {
    throw Error("has the format '" + format +
                "'; it should be '16UC1; compressedDepth png' or '32FC1; compressedDepth png'");
  }
  if (file.size() <= kHeaderSize) {
    throw Error("has " + std::to_string(file.size()) +
                " bytes of compressedDepth; its header has " + std::to_string(kHeaderSize));
  }
  return {file.begin() + kHeaderSize, file.end()};
}

}  // namespace

std::optional<std::string> depthProblem(const RawPicture& picture) {
  if (isMillimetres(picture.encoding)) return pictureProblem(picture);
  if (picture.encoding != "32FC1") {
    return "has the encoding '" + picture.encoding +
           "'; depth should be 32FC1 [m] or 16UC1 [mm] (REP 118)";
  }
  const std::size_t row = picture.width * sizeof(float);
  if (picture.step < row) {
    return "has rows of " + std::to_string(picture.step) + " bytes (step); " +
           std::to_string(picture.width) + " depths of encoding 32FC1 need " + std::to_string(row);
  }
  const std::size_t needed =
      picture.height == 0 ? 0 : picture.step * (picture.height - std::size_t{1}) + row;
  if (picture.data.size() < needed) {
    return "has " + std::to_string(picture.data.size()) + " bytes; its " +
           std::to_string(picture.width) + " x " + std::to_string(picture.height) +
           " depths need " + std::to_string(needed);
  }
  const std::uint32_t longest = std::max(picture.width, picture.height);
  if (picture.width > 0 && picture.height > 0 && longest <= kLongestPictureSide) {
    return std::nullopt;
  }
  return "has " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
         " pixels; a side should be 1 to " + std::to_string(kLongestPictureSide) + " pixels";
}

cv::Mat depthOf(const RawPicture& picture) {
  if (const auto problem = depthProblem(picture)) throw Error(*problem);
  if (isMillimetres(picture.encoding)) return ofMillimetres(rowsOf(picture, CV_16UC1));
  return withoutGaps(rowsOf(picture, CV_32FC1));
}

PictureSize checkCompressedDepth(const std::vector<std::uint8_t>& file, const std::string& format) {
  return checkPicture(pngOf(file, format), "depth.png");
}

cv::Mat depthOfCompressed(const std::vector<std::uint8_t>& file, const std::string& format) {
  const cv::Mat numbers = decodePixels(pngOf(file, format), "depth.png");
  if (numbers.type() != CV_16UC1) {
    throw Error("of format '" + format + "' is not a 16-bit PNG with one channel");
  }
  if (isMillimetres(encodingOf(format))) return ofMillimetres(numbers);
  DepthQuantisation quantisation;
  std::memcpy(&quantisation.a, file.data() + sizeof(std::uint32_t), sizeof quantisation.a);
  std::memcpy(&quantisation.b, file.data() + 2 * sizeof(std::uint32_t), sizeof quantisation.b);
  cv::Mat_<float> depth(numbers.size(), 0.0F);
  std::transform(numbers.begin<std::uint16_t>(), numbers.end<std::uint16_t>(), depth.begin(),
                 [&](std::uint16_t each) {
                   return each == 0 ? 0.0F : quantisation.a / (each - quantisation.b);
                 });
  return withoutGaps(depth);
}

}  // namespace synthetic_dataset::base
