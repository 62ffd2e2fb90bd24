#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reference/reference_folder.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::test {

/// One recording, and the original tool's output for it.
class GoldenCase {
 public:
  /// The data of an object in one of the original's frames.
  struct ObjectFrame {
    std::array<double, 4> box{};  ///< of the projected bounding shape [px]: left top right bottom
    bool behind_camera = false;
  };
  struct Frame {
    std::int64_t stamp_ns = 0;
    std::map<std::string, ObjectFrame> objects;
  };

  explicit GoldenCase(const std::string& name);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }

  /// The case's own parameters, with a world of boxes and its camera added.
  /// @param output  where the dataset goes, as the original's NN_OUT_DIR
  /// @param world_file  is written here
  [[nodiscard]] Value parameters(const std::filesystem::path& output,
                                 const std::filesystem::path& world_file) const;

 private:
  std::filesystem::path folder_;
  std::vector<Frame> frames_;
};

}  // namespace synthetic_dataset::test
