#include "plugins/stvnet/stvnet_folder.h"

#include <algorithm>
#include <cstddef>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

bool isControl(char character) {
  const auto code = static_cast<unsigned char>(character);
  return code < 0x20U || code == 0x7FU;
}

}  // namespace

std::string stvNetFolder(const std::string& name) {
  constexpr std::size_t kLongest = 200;  // [byte] of a part, of 255 that there may be
  bool is_path = std::none_of(name.begin(), name.end(), isControl);
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::size_t length = end - begin;
    is_path = is_path && length > 0 && length <= kLongest && name[begin] != '.';
    begin = end + 1;
  }
  return is_path && name.size() <= 4 * kLongest ? name : safeFileName(name);
}

}  // namespace synthetic_dataset
