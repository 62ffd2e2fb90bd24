#pragma once

#include <fstream>
#include <iterator>
#include <string>

namespace synthetic_dataset::test {

/// A file's bytes; empty if there is no file.
inline std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace synthetic_dataset::test
