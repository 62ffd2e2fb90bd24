#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plugins/readback/written_scene.h"

namespace synthetic_dataset::formats {

/// Where a scene's image stands in its format.
struct SequenceFrame {
  std::string sequence;  ///< its folder, below the writer's
  std::string number;    ///< in the files of labels
  std::string name;      ///< the same with six digits, as pictures are called
};

/// The list of all frames (plugins/shared/sequences.h), read once.
class FrameList {
 public:
  explicit FrameList(const std::filesystem::path& file);

  /// @param image  below the writer's folder: "scenes/00000000.jpg"
  /// @throws Error where the list does not have it
  [[nodiscard]] const SequenceFrame& of(const std::string& image) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, SequenceFrame> frames_;  ///< by image
};

/// A file with the labels of a whole sequence, each on a line that begins with its frame.
class SequenceLabels {
 public:
  explicit SequenceLabels(const std::filesystem::path& file);

  /// The words of each of a frame's lines, the frame left out. They are separated by `,` where the
  /// frame is, else by blanks.
  /// @param columns  how many words each line should have
  /// @throws Error where one has another number
  [[nodiscard]] const std::vector<std::vector<std::string>>& of(const SequenceFrame& frame,
                                                                std::size_t columns) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::vector<std::vector<std::string>>> lines_;
};

/// The frame that a scene's image is.
/// @param image  absolute
[[nodiscard]] SequenceFrame frameOf(const WrittenScene& scene, const std::filesystem::path& image);

}  // namespace synthetic_dataset::formats
