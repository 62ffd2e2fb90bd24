#include "plugins/readback/sequence_values.h"

#include <algorithm>
#include <map>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats {

TrueSequences::TrueSequences(const DatasetInfo& dataset)
    : splits_(dataset.splitFolders()),
      motions_(dataset.motions),
      camera_count_(dataset.cameras.size()) {
  if (motions_.empty()) motions_.emplace_back();
  for (const std::string& split : splits_) {
    std::map<std::string, int> counts;  // of the names that are taken
    for (const MotionInfo& motion : motions_) {
      const std::string before = motions_.size() == 1 ? "" : safeFileName(motion.name) + "_";
      for (std::size_t camera = 0; camera < camera_count_; ++camera) {
        const std::string plain = before + safeFileName(dataset.cameras[camera].name);
        std::string name = plain;
        for (int i = 2; counts[name]++ > 0; ++i) name = plain + "_" + std::to_string(i);
        sequences_.push_back({split, name, camera, motion.rate, {}});
      }
    }
  }
}

TrueSequence& TrueSequences::of(const Scene& scene) {
  const auto split = std::find(splits_.begin(), splits_.end(), scene.splitFolder());
  if (split == splits_.end()) throw Error("the scene is of a split that the run does not have");
  const auto after =
      std::find_if(motions_.begin() + 1, motions_.end(),
                   [&](const MotionInfo& motion) { return motion.first_instant > scene.instant; });
  const auto motion = static_cast<std::size_t>(after - motions_.begin() - 1);
  const auto of_split = static_cast<std::size_t>(split - splits_.begin()) * motions_.size();
  return sequences_.at((of_split + motion) * camera_count_ + scene.camera_index);
}

void TrueSequences::addFrame(const TrueScene& truth, const std::string& extension,
                             TrueSequence& sequence, FoundFiles& files) const {
  sequence.images.push_back("scenes/" + truth.scene.name + "." + extension);
  files.compareWithScene(sequence.images.back(), truth);
}

void compareFrames(const TrueSequence& sequence, const std::string& folder, std::int64_t first,
                   const std::string& extension, FoundFiles& files) {
  for (const std::string& image : sequence.images) {
    files.compareBytes(folder + withZeros(first++, 6) + "." + extension, files.folder() / image);
  }
}

std::string withZeros(std::int64_t number, std::size_t digits) {
  std::string text = std::to_string(number);
  text.insert(0, digits - std::min(digits, text.size()), '0');
  return text;
}

}  // namespace synthetic_dataset::formats
