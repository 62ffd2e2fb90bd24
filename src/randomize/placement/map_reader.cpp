#include "randomize/placement/map_reader.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/image/picture_decoder.h"
#include "base/input_file.h"
#include "randomize/placement/map_file.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::randomize {
namespace {

/// @param number  a percentage, as in nav_msgs/OccupancyGrid
Cell cellOf(std::int8_t number, const Thresholds& thresholds) {
  if (number < 0 || number > 100) return Cell::kUnknown;
  const double probability = number / 100.0;
  if (probability <= thresholds.free) return Cell::kFree;
  return probability > thresholds.occupied ? Cell::kOccupied : Cell::kUnknown;
}

/// @param shade  0 (black) to 255 (white)
Cell cellOf(double shade, const MapFile& file) {
  if (file.negate) shade = 255.0 - shade;
  if (file.mode == MapMode::kRaw) {
    const auto number = static_cast<std::int8_t>(static_cast<std::uint8_t>(shade));
    return cellOf(number, {file.free_threshold, file.occupied_threshold});
  }
  const double probability = (255.0 - shade) / 255.0;
  if (probability > file.occupied_threshold) return Cell::kOccupied;
  return probability < file.free_threshold ? Cell::kFree : Cell::kUnknown;
}

/// The mean of a pixel's channels as bytes: of 16-bit channels only the upper byte counts.
template <class Number>
double shadeOf(const Number* channels, int count) {
  constexpr unsigned kBelowByte = 8 * (sizeof(Number) - 1);
  int sum = 0;
  for (int i = 0; i < count; ++i) sum += channels[i] >> kBelowByte;
  return static_cast<double>(sum) / count;
}

double shadeAt(const cv::Mat& picture, int row, int column, int channel_count) {
  const int first = column * picture.channels();
  return picture.depth() == CV_8U ? shadeOf(picture.ptr<std::uint8_t>(row) + first, channel_count)
                                  : shadeOf(picture.ptr<std::uint16_t>(row) + first, channel_count);
}

std::vector<Cell> cellsOf(const cv::Mat& picture, const MapFile& file) {
  // According to map_server, "Alpha will be averaged in with color channels when using trinary
  // mode".
  const bool has_alpha = picture.channels() == 4;
  const bool averages_alpha = file.mode == MapMode::kTrinary;
  const int channel_count = picture.channels() - (has_alpha && !averages_alpha ? 1 : 0);
  std::vector<Cell> cells;
  cells.reserve(picture.total());
  for (int row = picture.rows - 1; row >= 0; --row) {
    for (int column = 0; column < picture.cols; ++column) {
      cells.push_back(cellOf(shadeAt(picture, row, column, channel_count), file));
    }
  }
  return cells;
}

/// A warning if unknown cells count as free. map_saver and slam_toolbox give unknown cells this
/// shade; as a probability it is 0.196, which the thresholds of other programs take as free.
std::string unknownTakenForFree(const cv::Mat& picture, const MapFile& file) {
  constexpr int kUnknownShade = 205;
  if (file.mode != MapMode::kTrinary || cellOf(kUnknownShade, file) != Cell::kFree) return "";
  std::size_t count = 0;
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      count += shadeAt(picture, row, column, picture.channels()) == kUnknownShade ? 1 : 0;
    }
  }
  if (count == 0) return "";
  const double share = 100.0 * static_cast<double>(count) / static_cast<double>(picture.total());
  return fixed(share, 0) + " % of its cells have the shade 205 of unknown cells, and count as " +
         "free by its free_thresh of " + Value(file.free_threshold).text() +
         "; `free_thresh: 0.196` leaves them out";
}

cv::Mat readPicture(const std::string& file) {
  std::error_code unknown;
  if (const std::string fault = base::inputFault(file); !fault.empty()) throw Error(fault);
  if (!std::filesystem::exists(file, unknown)) {
    throw Error("is not a file; a relative path starts at the folder of the YAML file");
  }
  return base::decodePixels(base::readInputBytes(file), file);
}

}  // namespace

OccupancyMap readMapFile(const std::string& file,
                         const std::function<void(const std::string&)>& note) {
  const MapFile map = readMapYaml(file);
  try {
    const cv::Mat picture = readPicture(map.image);
    const std::string found = note ? unknownTakenForFree(picture, map) : "";
    if (!found.empty()) note(file + ": " + found);
    return {static_cast<std::size_t>(picture.cols),
            static_cast<std::size_t>(picture.rows),
            map.resolution,
            {map.x, map.y, 0.0, map.yaw},
            cellsOf(picture, map)};
  } catch (const Error& error) {
    throw Error(file + ": image: picture '" + map.image + "' " + error.what());
  }
}

OccupancyMap mapOf(const motion::RecordedMap& recorded, const Thresholds& thresholds) {
  constexpr double kTilt = 1e-6;
  const auto R_FM = recorded.X_FM.linear();
  if (R_FM(2, 2) < 1.0 - kTilt) {
    throw Error("found a map that is tilted in '" + recorded.frame +
                "'; it should be turned about z only");
  }
  const Eigen::Vector3d p_FM = recorded.X_FM.translation();
  std::vector<Cell> cells;
  cells.reserve(recorded.cells.size());
  for (const std::int8_t number : recorded.cells) cells.push_back(cellOf(number, thresholds));
  return {recorded.width,
          recorded.height,
          recorded.resolution,
          {p_FM.x(), p_FM.y(), p_FM.z(), std::atan2(R_FM(1, 0), R_FM(0, 0))},
          std::move(cells)};
}

}  // namespace synthetic_dataset::randomize
