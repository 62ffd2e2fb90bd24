#include "base/image/image_encoder.h"

#include <algorithm>
#include <cctype>

#include <opencv2/imgcodecs.hpp>

#include "base/image/png_encoder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

constexpr const char* kUnknownFormat =
    "an image file's name should end in .png, .jpg, .jpeg, .tif or .tiff";
constexpr const char* kNoPixels = "the image has no pixels";

}  // namespace

std::optional<ImageFormat> imageFormat(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return std::nullopt;
  std::string extension = path.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (extension == "png") return ImageFormat::kPng;
  if (extension == "jpg" || extension == "jpeg") return ImageFormat::kJpeg;
  if (extension == "tif" || extension == "tiff") return ImageFormat::kTiff;
  return std::nullopt;
}

std::optional<std::string> imageProblem(const std::string& path, const Mask& mask) {
  if (!imageFormat(path)) return kUnknownFormat;
  if (mask.imageSize().empty()) return kNoPixels;
  return std::nullopt;
}

std::optional<std::string> imageProblem(const std::string& path, const cv::Mat& image) {
  const std::optional<ImageFormat> format = imageFormat(path);
  if (!format) return kUnknownFormat;
  if (image.empty()) return kNoPixels;
  if (image.dims != 2) return "the image should have two dimensions";
  const int type = image.type();
  const bool numbers = type == CV_32FC1;
  if (type != CV_8UC1 && type != CV_16UC1 && type != CV_8UC3 && !numbers) {
    return "the pixels are " + cv::typeToString(type) +
           "; they should be CV_8UC1, CV_16UC1, CV_8UC3 or CV_32FC1";
  }
  if (numbers && *format != ImageFormat::kTiff) {
    return "the pixels are CV_32FC1, which only TIFF has; the name should end in .tiff";
  }
  if (*format == ImageFormat::kJpeg && type == CV_16UC1) {
    return "JPEG has no 16 bit pixels; the name should end in .png";
  }
  return std::nullopt;
}

std::vector<uchar> encodeImage(const cv::Mat& image, ImageFormat format,
                               const ImageQuality& quality) {
  if (format == ImageFormat::kPng) return encodePng(image, {}, quality.png_compression);
  std::string extension = ".jpg";
  std::vector<int> settings = {cv::IMWRITE_JPEG_QUALITY, quality.jpeg_quality};
  if (format == ImageFormat::kTiff) {
    // libtiff's COMPRESSION_ADOBE_DEFLATE, which all readers support. OpenCV does not compress
    // floating-point numbers, whatever the option says.
    constexpr int kAdobeDeflate = 8;
    extension = ".tiff";
    settings = {cv::IMWRITE_TIFF_COMPRESSION, kAdobeDeflate};
  }
  std::vector<uchar> bytes;
  try {
    if (cv::imencode(extension, image, bytes, settings)) return bytes;
  } catch (const cv::Exception& exception) {
    throw Error("the image could not be encoded: " + exception.err);
  }
  throw Error("the image could not be encoded");
}

}  // namespace synthetic_dataset::base
