#include "output/indexed_png.h"

#include <png.h>
#include <opencv2/core.hpp>

#include "output/image_encoder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

constexpr std::size_t kMostColours = 256;

/// libpng's two structures, freed together.
struct PngWriter {
  PngWriter() {
    // libpng reports by this function, which must not return: an exception leaves its C code, as
    // it does with longjmp in libpng's own way.
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, keepQuiet);
    if (png == nullptr) throw Error("libpng cannot begin a PNG");
    info = png_create_info_struct(png);
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  [[noreturn]] static void fail(png_structp /*png*/, png_const_charp message) {
    throw Error(std::string("the image could not be encoded: ") + message);
  }

  /// In the place of libpng's own, which prints what it warns of.
  static void keepQuiet(png_structp /*png*/, png_const_charp /*message*/) {}

  png_structp png = nullptr;
  png_infop info = nullptr;
};

void append(png_structp png, png_bytep data, png_size_t size) {
  auto& bytes = *static_cast<std::vector<uchar>*>(png_get_io_ptr(png));
  bytes.insert(bytes.end(), data, data + size);
}

void flush(png_structp /*png*/) {}

}  // namespace

std::optional<std::string> indexedImageProblem(const std::string& path, const cv::Mat& indices,
                                               const std::vector<cv::Vec3b>& palette) {
  if (imageFormat(path) != ImageFormat::kPng) return "its name should end in .png";
  if (indices.empty() || indices.dims != 2) return "the image has no pixels";
  if (indices.type() != CV_8UC1) {
    return "the pixels are " + cv::typeToString(indices.type()) + "; they should be CV_8UC1";
  }
  if (palette.empty() || palette.size() > kMostColours) {
    return "it has " + std::to_string(palette.size()) + " colours; it should have 1 to 256";
  }
  double greatest = 0.0;
  cv::minMaxIdx(indices, nullptr, &greatest);
  if (greatest >= static_cast<double>(palette.size())) {
    return "a pixel is " + std::to_string(static_cast<int>(greatest)) + ", but there are only " +
           std::to_string(palette.size()) + " colours";
  }
  return std::nullopt;
}

std::vector<uchar> encodeIndexedPng(const cv::Mat& indices, const std::vector<cv::Vec3b>& palette,
                                    int compression) {
  std::vector<uchar> bytes;
  std::vector<png_color> colours;
  colours.reserve(palette.size());
  for (const cv::Vec3b& colour : palette) colours.push_back({colour[2], colour[1], colour[0]});

  const PngWriter writer;
  png_set_write_fn(writer.png, &bytes, append, flush);
  png_set_compression_level(writer.png, compression);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(indices.cols),
               static_cast<png_uint_32>(indices.rows), 8, PNG_COLOR_TYPE_PALETTE,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_PLTE(writer.png, writer.info, colours.data(), static_cast<int>(colours.size()));
  png_write_info(writer.png, writer.info);
  for (int row = 0; row < indices.rows; ++row) png_write_row(writer.png, indices.ptr(row));
  png_write_end(writer.png, nullptr);
  return bytes;
}

}  // namespace synthetic_dataset::output
