#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The file that says which frame of which sequence each image is: a line an image, its sequence's
/// folder, its frame and the scene's image.
inline constexpr const char* kFrameList = "frames.txt";

/// For formats whose images are the frames of sequences, numbered without gaps: those of one
/// motion, one camera and one split. Which number a scene gets is known at the end of a dataset, so
/// a scene's image has a name of its own first.
class Sequences {
 public:
  /// One sequence.
  struct Sequence {
    std::string split;
    std::string name;  ///< "camera", "hall_camera": unique in its split
    std::size_t camera = 0;
    double rate =
        0.0;  ///< images in a second [Hz]; 0 where they have nothing to do with each other
  };

  Sequences() = default;

  /// @param first_frame  the number of each sequence's first frame
  explicit Sequences(const DatasetInfo& dataset, std::int64_t first_frame = 0);

  /// In the order of splits, motions and cameras; some may have no image.
  [[nodiscard]] const std::vector<Sequence>& all() const { return sequences_; }

  /// Gives a scene's image and keeps its labels, and warns where it is of no sequence.
  /// @param extension  of the image: "jpg"
  /// @param labels  each with a newline
  void addFrame(const Scene& scene, const std::string& extension, const std::string& labels,
                SceneOutput& output) const;

  /// The same of a frame that is another file than the scene's image.
  /// @param file  of this scene: "scenes/00000000.bin"
  void noteFrame(const Scene& scene, const std::string& file, const std::string& labels,
                 SceneOutput& output) const;

  /// Calls `visit` for each frame of a sequence in its order.
  using Visit =
      std::function<void(std::int64_t frame, const std::string& image, const std::string& labels)>;
  void forEachFrame(std::size_t sequence, const SceneRecords& records, const Visit& visit) const;

  /// How many frames a sequence has.
  [[nodiscard]] std::int64_t length(std::size_t sequence, const SceneRecords& records) const;

  /// The file of a sequence's labels, each line with its frame before it.
  void addLabels(const std::string& path, std::size_t sequence, char separator,
                 const SceneRecords& records, DatasetOutput& output) const;

  /// The file kFrameList.
  /// @param folders  of the sequences, in their order
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
