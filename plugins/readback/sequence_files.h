#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plugins/readback/written_scene.h"

namespace synthetic_dataset::formats {

/// The place of a scene's image in its format.
struct SequenceFrame {
  std::string sequence;  ///< the sequence's folder, relative to the writer's
  std::string number;    ///< as in the label files
  std::string name;      ///< the number with six digits, as in the pictures' names
};

/// The list of all frames (plugins/shared/sequences.h), read once.
class FrameList {
 public:
  explicit FrameList(const std::filesystem::path& file);

  /// @param image  relative to the writer's folder: "scenes/00000000.jpg"
  /// @throws Error if the list does not contain it
  [[nodiscard]] const SequenceFrame& of(const std::string& image) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, SequenceFrame> frames_;  ///< by image
};

/// A file with the labels of a whole sequence, each on a line that begins with its frame number.
class SequenceLabels {
 public:
  explicit SequenceLabels(const std::filesystem::path& file);

  /// The words of each of a frame's lines, without the frame number. They are separated by `,` if
  /// the frame number is followed by one, otherwise by blanks.
  /// @param columns  how many words each line should have
  /// @throws Error if a line has a different number
  [[nodiscard]] const std::vector<std::vector<std::string>>& of(const SequenceFrame& frame,
                                                                std::size_t columns) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::vector<std::vector<std::string>>> lines_;
};

/// The frame of a scene's image.
/// @param image  absolute
[[nodiscard]] SequenceFrame frameOf(const WrittenScene& scene, const std::filesystem::path& image);

}  // namespace synthetic_dataset::formats
