#pragma once

#include <optional>
#include <string>

namespace synthetic_dataset::scene {

/// Which camera of a calibration file is meant.
struct CalibrationChoice {
  std::optional<std::string> camera;  ///< its name in the file; may be left out where it has one

  /// The camera of the same file whose optical frame the picture's pose is that of: the file's
  /// extrinsics then place this one against it.
  std::optional<std::string> reference;
};

}  // namespace synthetic_dataset::scene
