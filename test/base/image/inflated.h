#pragma once

#include <cstddef>
#include <vector>

#include <zlib.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::test {

/// What zlib finds in a stream, whose sum it checks; nothing where it is damaged.
[[nodiscard]] inline std::vector<uchar> inflated(const std::vector<uchar>& stream,
                                                 std::size_t size) {
  std::vector<uchar> bytes(size);
  uLongf found = size;
  const int problem = uncompress(bytes.data(), &found, stream.data(), stream.size());
  return problem == Z_OK && found == size ? bytes : std::vector<uchar>();
}

}  // namespace synthetic_dataset::test
