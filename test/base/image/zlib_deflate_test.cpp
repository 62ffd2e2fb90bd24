#include "base/image/zlib_deflate.h"

#include <gtest/gtest.h>

#include "base/image/inflated.h"

namespace synthetic_dataset::base {
namespace zlib_deflate_test {

cv::Mat noise() {
  cv::Mat bytes(200, 300, CV_8UC1);
  cv::RNG(5).fill(bytes, cv::RNG::NORMAL, 128, 20);
  return bytes;
}

TEST(ZlibDeflate, IsReadBack) {
  const cv::Mat bytes = noise();
  for (const int compression : {0, 1, 6, 9}) {
    const std::vector<uchar> read = test::inflated(zlibDeflated(bytes, compression), bytes.total());
    EXPECT_TRUE(read == std::vector<uchar>(bytes.begin<uchar>(), bytes.end<uchar>()))
        << compression;
  }
}

TEST(ZlibDeflate, IsSmallerTheHigherTheLevel) {
  const cv::Mat bytes = noise();
  EXPECT_LT(zlibDeflated(bytes, 9).size(), zlibDeflated(bytes, 1).size());
  EXPECT_EQ(zlibDeflated(bytes, 0), zlibDeflated(bytes, 1));
}

}  // namespace zlib_deflate_test
}  // namespace synthetic_dataset::base
