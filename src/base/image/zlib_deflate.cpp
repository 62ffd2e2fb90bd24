#include "base/image/zlib_deflate.h"

#include <algorithm>

#include <zlib.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {

std::vector<uchar> zlibDeflated(const cv::Mat& bytes, int compression) {
  constexpr int kQuickest = 1;  // 0 would store the bytes as they are
  const auto size = static_cast<uLong>(bytes.total());
  uLongf result_size = compressBound(size);
  std::vector<uchar> result(result_size);
  if (compress2(result.data(), &result_size, bytes.data, size, std::max(compression, kQuickest)) !=
      Z_OK) {
    throw Error("too little memory to compress an image");
  }
  result.resize(result_size);
  return result;
}

}  // namespace synthetic_dataset::base
