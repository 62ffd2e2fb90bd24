#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The file that lists which frame of which sequence each image is: one line per image with its
/// sequence's folder, its frame number and the scene's image.
inline constexpr const char* kFrameList = "frames.txt";

/// For formats whose images are the frames of sequences, numbered without gaps: one sequence per
/// motion, camera and split. A scene's frame number is only known at the end of a dataset, so its
/// image has a name of its own until then.
class Sequences {
 public:
  /// One sequence.
  struct Sequence {
    std::string split;
    std::string name;  ///< "camera", "hall_camera": unique within its split
    std::size_t camera = 0;
    double rate = 0.0;  ///< images per second [Hz]; 0 if they are unrelated
  };

  Sequences() = default;

  /// @param first_frame  the number of each sequence's first frame
  explicit Sequences(const DatasetInfo& dataset, std::int64_t first_frame = 0);

  /// All sequences in the order of splits, motions and cameras; some may have no image.
  [[nodiscard]] const std::vector<Sequence>& all() const { return sequences_; }

  /// Adds a scene's image and keeps its labels; warns if the scene belongs to no sequence.
  /// @param extension  of the image: "jpg"
  /// @param labels  each with a newline
  void addFrame(const Scene& scene, const std::string& extension, const std::string& labels,
                SceneOutput& output) const;

  /// Notes a frame whose file is not the scene's image.
  /// @param file  of this scene: "scenes/00000000.bin"
  void noteFrame(const Scene& scene, const std::string& file, const std::string& labels,
                 SceneOutput& output) const;

  /// Called for each frame of a sequence, in order.
  using Visit =
      std::function<void(std::int64_t frame, const std::string& image, const std::string& labels)>;
  void forEachFrame(std::size_t sequence, const SceneRecords& records, const Visit& visit) const;

  /// The number of frames in a sequence.
  [[nodiscard]] std::int64_t length(std::size_t sequence, const SceneRecords& records) const;

  /// Writes a sequence's label file, in which each line begins with its frame number.
  void addLabels(const std::string& path, std::size_t sequence, char separator,
                 const SceneRecords& records, DatasetOutput& output) const;

  /// Writes the file kFrameList.
  /// @param folders  of the sequences, in order
  void addFrameList(const std::vector<std::string>& folders, const SceneRecords& records,
                    DatasetOutput& output) const;

 private:
  [[nodiscard]] std::size_t sequenceOf(const Scene& scene) const;

  std::vector<Sequence> sequences_;
  std::vector<MotionInfo> motions_;
  std::size_t camera_count_ = 1;
  std::int64_t first_frame_ = 0;
  std::vector<std::string> splits_;
};

}  // namespace synthetic_dataset
