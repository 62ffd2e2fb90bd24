#pragma once

#include <cstddef>
#include <vector>

#include <zlib.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::test {

/// Decompresses a zlib stream and checks its checksum; returns nothing if it is damaged or does not
/// have this size.
[[nodiscard]] inline std::vector<uchar> inflated(const std::vector<uchar>& stream,
                                                 std::size_t size) {
  std::vector<uchar> bytes(size);
  uLongf found = size;
  const int problem = uncompress(bytes.data(), &found, stream.data(), stream.size());
  return problem == Z_OK && found == size ? bytes : std::vector<uchar>();
}

}  // namespace synthetic_dataset::test
