#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plugins/kitti/kitti_options.h"
#include "plugins/readback/found_files.h"

/// What values in files of KITTI's benchmarks of objects and of tracking should be.
namespace synthetic_dataset::formats {

/// What a label's line should have where both benchmarks have the same.
struct TrueKittiLine {
  std::string type;          ///< "DontCare" for an object without a label
  std::string box;           ///< four columns, as all of these with a space before each
  double alpha = 0.0;        ///< [rad]
  int occlusion = 0;         ///< 0 to 2
  std::string columns = "";  ///< from the height to the rotation; empty for DontCare

  [[nodiscard]] bool isDontCare() const { return columns.empty(); }
};

/// The line of an object; nothing where it has none.
[[nodiscard]] std::optional<TrueKittiLine> trueKittiLine(const SceneObject& object,
                                                         const CameraModel& camera,
                                                         const KittiOptions& options);

/// Numbers with the format's decimals and a space before each.
[[nodiscard]] std::string kittiWords(const std::vector<double>& numbers);

/// A file of `calib`.
[[nodiscard]] std::string trueKittiCalibration(const Intrinsics& k);

/// Compares a file of labels, in which a half turn may be pi or -pi.
void compareKittiLabels(const std::string& name, const std::string& lines, FoundFiles& files);

}  // namespace synthetic_dataset::formats
