#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {

/// A file's or folder's name for formats whose readers look for a class or an object by its exact
/// name, including spaces: the name itself if a file can have it, otherwise as safeFileName.
[[nodiscard]] inline std::string plainFileName(const std::string& name) {
  constexpr std::size_t kLongest = 80;  // [byte]; several such names fit into one path
  const bool has_its_place = !name.empty() && name.size() <= kLongest && name.front() != '.' &&
                             name.front() != ' ' && name.back() != ' ' &&
                             std::none_of(name.begin(), name.end(), [](char c) {
                               const auto byte = static_cast<unsigned char>(c);
                               return c == '/' || c == '\\' || byte < 0x20U || byte == 0x7FU;
                             });
  return has_its_place ? name : safeFileName(name);
}

}  // namespace synthetic_dataset
