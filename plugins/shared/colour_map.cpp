#include "plugins/shared/colour_map.h"

namespace synthetic_dataset {

std::vector<cv::Vec3b> vocColourMap() {
  constexpr unsigned kColours = 256;
  std::vector<cv::Vec3b> colours;
  for (unsigned number = 0; number < kColours; ++number) {
    cv::Vec3b colour;
    for (unsigned bit = 0; bit < 8; ++bit) {
      for (unsigned channel = 0; channel < 3; ++channel) {  // red, green, blue
        const unsigned value = (number >> (3 * bit + channel)) & 1U;
        colour[static_cast<int>(2 - channel)] |= static_cast<uchar>(value << (7 - bit));
      }
    }
    colours.push_back(colour);
  }
  return colours;
}

}  // namespace synthetic_dataset
