#include "base/image/png_encoder.h"

#include <pthread.h>
#include <sys/mman.h>

#include <cstdint>
#include <functional>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

namespace synthetic_dataset::base {
namespace png_encoder_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;

const std::vector<cv::Vec3b> kPalette = {{0, 0, 0}, {10, 20, 200}, {255, 254, 253}};

/// Indices 0, 1, 2 in turn.
cv::Mat threeIndices(int rows, int columns) {
  cv::Mat indices(rows, columns, CV_8UC1);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      indices.at<uchar>(row, column) = static_cast<uchar>((row + column) % 3);
    }
  }
  return indices;
}

std::uint32_t bigEndian(const std::vector<uchar>& bytes, std::size_t begin) {
  return std::accumulate(
      bytes.begin() + static_cast<std::ptrdiff_t>(begin),
      bytes.begin() + static_cast<std::ptrdiff_t>(begin) + 4, std::uint32_t{0},
      [](std::uint32_t sum, uchar byte) { return sum * 256U + std::uint32_t{byte}; });
}

struct Chunk {
  std::string type;
  std::vector<uchar> data;
};

/// ISO/IEC 15948, 5.3: after a signature of 8 bytes, each chunk has a length, type, data, checksum.
std::vector<Chunk> chunksOf(const std::vector<uchar>& png) {
  std::vector<Chunk> chunks;
  for (std::size_t place = 8; place + 12 <= png.size();) {
    const std::size_t length = bigEndian(png, place);
    const auto type = png.begin() + static_cast<std::ptrdiff_t>(place) + 4;
    const auto data = type + 4;
    chunks.push_back({{type, data}, {data, data + static_cast<std::ptrdiff_t>(length)}});
    place += 12 + length;
  }
  return chunks;
}

/// Noise, a ramp and a plain half, so that every filter is the best one of some row.
cv::Mat mixedPixels(int type, const cv::Size& size) {
  std::mt19937 random(5);
  cv::Mat image(size, type, cv::Scalar::all(200));
  const auto row_bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
  for (int row = 0; row < image.rows; ++row) {
    for (std::size_t i = 0; i < row_bytes && row % 5 != 4; ++i) {
      const auto noise = static_cast<uchar>(random());
      const auto ramp = static_cast<uchar>(static_cast<std::size_t>(row) * 7 + i);
      const uchar above = row > 0 ? image.ptr(row - 1)[i] : noise;
      image.ptr(row)[i] = row % 5 == 0 ? noise : row % 5 == 1 ? ramp : above;
    }
  }
  return image;
}

TEST(Png, HoldsPixelsOfAllKinds) {
  for (const int type : {CV_8UC1, CV_16UC1, CV_8UC3}) {
    for (const cv::Size& size : {cv::Size(1, 1), {3, 1}, {1, 7}, {61, 43}, {640, 48}}) {
      for (const int compression : {0, 1, 3, 6, 9}) {
        const cv::Mat image = mixedPixels(type, size);
        const cv::Mat read = cv::imdecode(encodePng(image, {}, compression), cv::IMREAD_UNCHANGED);
        ASSERT_EQ(read.type(), type) << size;
        ASSERT_EQ(read.size(), size);
        EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0.0) << type << size << compression;
      }
    }
  }
}

TEST(Png, HoldsWhatCannotBeCompressed) {
  cv::Mat noise(480, 640, CV_8UC3);
  cv::theRNG().state = 3;
  cv::randu(noise, 0, 256);
  for (const int compression : {0, 1, 2}) {
    const std::vector<uchar> png = encodePng(noise, {}, compression);
    EXPECT_EQ(cv::norm(cv::imdecode(png, cv::IMREAD_UNCHANGED), noise, cv::NORM_INF), 0.0);
    EXPECT_LT(static_cast<double>(png.size()), 1.01 * 480 * 640 * 3);
  }
}

/// Runs a function in a thread whose stack is at the given place in a fixed piece of memory.
/// @param place  at most 1023
void onStackAt(std::size_t place, const std::function<void()>& function) {
  constexpr std::size_t kStack = std::size_t{1} << 20U;
  static void* const all = mmap(nullptr, 1024 * kStack, PROT_READ | PROT_WRITE,
                                MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(all, MAP_FAILED);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, static_cast<char*>(all) + place * kStack, kStack);
  const auto run = [](void* given) -> void* {
    (*static_cast<const std::function<void()>*>(given))();
    return nullptr;
  };
  pthread_t thread{};
  ASSERT_EQ(pthread_create(&thread, &attributes, run,
                           const_cast<std::function<void()>*>(&function)),  // NOLINT
            0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

TEST(Png, IsTheSameWhereverTheStackIs) {
  // The depth of a wall, for which ISA-L's level 1 wrote a different file at one of 200 stack
  // addresses.
  cv::Mat depth(480, 640, CV_16UC1);
  int millimetres = 748;
  for (int row = 0; row < depth.rows; ++row) {
    if (row % 3 == 0) millimetres += 1 + row / 60;
    depth.row(row).setTo(millimetres);
  }
  const std::vector<uchar> expected = encodePng(depth, {}, 1);
  int others = 0;
  for (std::size_t place = 0; place < 1024; ++place) {
    onStackAt(place, [&] { others += encodePng(depth, {}, 1) != expected ? 1 : 0; });
  }
  EXPECT_EQ(others, 0);
}

TEST(Png, HoldsMasksAndWhatNearlyIsOne) {
  std::mt19937 random(9);
  for (const cv::Size& size : {cv::Size(1, 1), {640, 480}, {97, 3}}) {
    cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
    for (int row = 0; row < mask.rows; ++row) {
      const int first = static_cast<int>(random() % static_cast<unsigned>(mask.cols));
      mask(cv::Rect(first, row, (mask.cols - first + 1) / 2, 1)).setTo(255);
    }
    for (const int last : {0, 255, 254, 127, 1}) {
      mask.at<uchar>(mask.rows - 1, mask.cols - 1) = static_cast<uchar>(last);
      const cv::Mat read = cv::imdecode(encodePng(mask, {}, 1), cv::IMREAD_UNCHANGED);
      EXPECT_EQ(cv::norm(read, mask, cv::NORM_INF), 0.0) << size << last;
    }
  }
}

TEST(Png, HoldsAPartOfALargerImage) {
  const cv::Mat part = mixedPixels(CV_8UC3, {64, 48})(cv::Rect(5, 6, 30, 20));
  const cv::Mat read = cv::imdecode(encodePng(part, {}, 1), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(cv::norm(read, part, cv::NORM_INF), 0.0);
}

TEST(IndexedPng, HasNothingButHeaderPaletteAndPixels) {
  const std::vector<Chunk> chunks = chunksOf(encodePng(threeIndices(5, 7), kPalette, 1));
  ASSERT_EQ(chunks.size(), 4U);
  EXPECT_EQ(chunks[0].type, "IHDR");
  // Width, height, 8 bits, colour type 3, then deflate, filters of kind 0, no interlacing.
  EXPECT_THAT(chunks[0].data, ElementsAre(0, 0, 0, 7, 0, 0, 0, 5, 8, 3, 0, 0, 0));
  EXPECT_EQ(chunks[1].type, "PLTE");
  EXPECT_THAT(chunks[1].data, ElementsAre(0, 0, 0, 200, 20, 10, 253, 254, 255));
  EXPECT_EQ(chunks[2].type, "IDAT");
  EXPECT_EQ(chunks[3].type, "IEND");
}

TEST(IndexedPng, ShowsEachPixelInItsColour) {
  const cv::Mat indices = threeIndices(40, 60);
  const cv::Mat read = cv::imdecode(encodePng(indices, kPalette, 1), cv::IMREAD_COLOR);
  ASSERT_EQ(read.size(), indices.size());
  for (int row = 0; row < read.rows; ++row) {
    for (int column = 0; column < read.cols; ++column) {
      ASSERT_EQ(read.at<cv::Vec3b>(row, column), kPalette[indices.at<uchar>(row, column)]);
    }
  }
}

TEST(IndexedPng, Has256Colours) {
  std::vector<cv::Vec3b> greys;
  for (int i = 0; i < 256; ++i) greys.push_back(cv::Vec3b::all(static_cast<uchar>(i)));
  cv::Mat indices(1, 256, CV_8UC1);
  for (int i = 0; i < 256; ++i) indices.at<uchar>(0, i) = static_cast<uchar>(i);
  const cv::Mat read = cv::imdecode(encodePng(indices, greys, 9), cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(cv::norm(read, indices, cv::NORM_L1), 0.0);
}

TEST(IndexedPng, MakesTheSameBytesOfTheSamePixels) {
  const cv::Mat indices = threeIndices(20, 30);
  cv::Mat with_gaps(20, 37, CV_8UC1, cv::Scalar(9));
  indices.copyTo(with_gaps.colRange(0, 30));
  const std::vector<uchar> bytes = encodePng(indices, kPalette, 1);
  EXPECT_EQ(bytes, encodePng(indices, kPalette, 1));
  EXPECT_EQ(bytes, encodePng(with_gaps.colRange(0, 30), kPalette, 1));
}

TEST(IndexedPng, CompressesAsMuchAsAsked) {
  const cv::Mat pixels = mixedPixels(CV_8UC1, {200, 200});
  EXPECT_LT(encodePng(pixels, kPalette, 9).size(), encodePng(pixels, kPalette, 1).size());
}

TEST(IndexedImageProblem, NamesWhatWouldBeRight) {
  const cv::Mat indices = threeIndices(4, 4);
  EXPECT_EQ(indexedImageProblem("a/b.PNG", indices, kPalette), std::nullopt);
  EXPECT_THAT(indexedImageProblem("a.jpg", indices, kPalette), Optional(HasSubstr(".png")));
  EXPECT_THAT(indexedImageProblem("a.png", {}, kPalette), Optional(HasSubstr("no pixels")));
  EXPECT_THAT(indexedImageProblem("a.png", cv::Mat(2, 2, CV_16UC1), kPalette),
              Optional(HasSubstr("CV_16UC1; they should be CV_8UC1")));
  EXPECT_THAT(indexedImageProblem("a.png", indices, {}), Optional(HasSubstr("0 colours")));
  EXPECT_THAT(indexedImageProblem("a.png", indices, std::vector<cv::Vec3b>(257)),
              Optional(HasSubstr("257 colours; it should have 1 to 256")));
  EXPECT_THAT(indexedImageProblem("a.png", indices, {{0, 0, 0}, {1, 1, 1}}),
              Optional(HasSubstr("a pixel is 2, but there are only 2 colours")));
}

}  // namespace png_encoder_test
}  // namespace synthetic_dataset::base
