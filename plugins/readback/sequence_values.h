#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plugins/readback/found_files.h"
#include "synthetic_dataset/label_writer.h"

/// What files of formats should hold whose images are the frames of sequences.
namespace synthetic_dataset::formats {

/// What is known of a sequence: the scenes of one split, one motion and one camera.
struct TrueSequence {
  std::string split;
  std::string name;  ///< unique in its split
  std::size_t camera = 0;
  double rate = 0.0;                ///< as MotionInfo::rate
  std::vector<std::string> images;  ///< of its frames, below the writer's folder
  std::string labels = {};          ///< of all frames, as the format has them
};

/// All sequences of a dataset, which get their frames scene by scene.
class TrueSequences {
 public:
  explicit TrueSequences(const DatasetInfo& dataset);

  /// In the order of splits, motions and cameras; some may have no frame.
  [[nodiscard]] const std::vector<TrueSequence>& all() const { return sequences_; }

  /// The one whose next frame a scene is.
  [[nodiscard]] TrueSequence& of(const Scene& scene);

  /// Holds a scene's image against the truth and adds it to its sequence.
  /// @param extension  of the image: "jpg"
  void addFrame(const TrueScene& truth, const std::string& extension, TrueSequence& sequence,
                FoundFiles& files) const;

 private:
  std::vector<std::string> splits_;
  std::vector<MotionInfo> motions_;
  std::size_t camera_count_ = 1;
  std::vector<TrueSequence> sequences_;
};

/// Holds a folder with a sequence's images against those of its scenes.
/// @param folder  below the writer's, with a `/` at its end
/// @param first  the number of its first frame
void compareFrames(const TrueSequence& sequence, const std::string& folder, std::int64_t first,
                   const std::string& extension, FoundFiles& files);

/// A number with zeros before it.
[[nodiscard]] std::string withZeros(std::int64_t number, std::size_t digits);

}  // namespace synthetic_dataset::formats
