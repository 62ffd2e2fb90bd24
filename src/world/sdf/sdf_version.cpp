#include "world/sdf/sdf_version.h"

#include <cstdlib>

namespace synthetic_dataset::world {

bool isSdfVersion(const std::string& text) {
  const std::size_t point = text.find('.');
  const auto isNumber = [](const std::string& digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos;
  };
  return isNumber(text.substr(0, point)) &&
         (point == std::string::npos || isNumber(text.substr(point + 1)));
}

SdfVersion parseSdfVersion(const char* text) {
  if (text == nullptr) return {0, 0};
  char* end = nullptr;
  const long major = std::strtol(text, &end, 10);
  return {major, *end == '.' ? std::strtol(end + 1, nullptr, 10) : 0};
}

}  // namespace synthetic_dataset::world
