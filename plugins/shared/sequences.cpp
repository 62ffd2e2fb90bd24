#include "plugins/shared/sequences.h"

#include <algorithm>
#include <ostream>
#include <set>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

/// The lines, each preceded by the frame number.
std::string withFrame(std::int64_t frame, char separator, const std::string& labels) {
  std::string lines;
  for (std::size_t begin = 0; begin < labels.size();) {
    const std::size_t end = labels.find('\n', begin) + 1;
    lines += std::to_string(frame) + separator + labels.substr(begin, end - begin);
    begin = end;
  }
  return lines;
}

}  // namespace

Sequences::Sequences(const DatasetInfo& dataset, std::int64_t first_frame)
    : motions_(dataset.motions),
      camera_count_(dataset.cameras.size()),
      first_frame_(first_frame),
      splits_(dataset.splitFolders()) {
  if (motions_.empty()) motions_.push_back({});
  for (const std::string& split : splits_) {
    std::set<std::string> taken;
    for (const MotionInfo& motion : motions_) {
      for (std::size_t camera = 0; camera < camera_count_; ++camera) {
        std::string name = safeFileName(dataset.cameras[camera].name);
        if (motions_.size() > 1) name = safeFileName(motion.name) + "_" + name;
        const std::string plain = name;
        for (int i = 2; !taken.insert(name).second; ++i) name = plain + "_" + std::to_string(i);
        sequences_.push_back({split, name, camera, motion.rate});
      }
    }
  }
}

std::size_t Sequences::sequenceOf(const Scene& scene) const {
  const auto split = std::find(splits_.begin(), splits_.end(), scene.splitFolder());
  if (split == splits_.end()) throw Error("the scene is in a split that the dataset does not have");
  std::size_t motion = motions_.size() - 1;
  while (motion > 0 && motions_[motion].first_instant > scene.instant) --motion;
  const auto place = static_cast<std::size_t>(split - splits_.begin());
  return (place * motions_.size() + motion) * camera_count_ + scene.camera_index;
}

void Sequences::addFrame(const Scene& scene, const std::string& extension,
                         const std::string& labels, SceneOutput& output) const {
  const std::string image = "scenes/" + scene.name + "." + extension;
  output.addImage(image, scene.image);
  noteFrame(scene, image, labels, output);
}

void Sequences::noteFrame(const Scene& scene, const std::string& file, const std::string& labels,
                          SceneOutput& output) const {
  const std::size_t sequence = sequenceOf(scene);
  if (sequences_[sequence].rate <= 0.0) {
    output.addWarning(
        "objects are placed anew in each scene, so nothing can be tracked from image to image");
  }
  output.addRecord(std::to_string(sequence), file + "\n" + labels);
}

void Sequences::forEachFrame(std::size_t sequence, const SceneRecords& records,
                             const Visit& visit) const {
  std::int64_t frame = first_frame_;
  records.forEach(std::to_string(sequence), [&](std::int64_t /*scene*/, const std::string& record) {
    const std::size_t end = record.find('\n');
    visit(frame++, record.substr(0, end), record.substr(end + 1));
  });
}

std::int64_t Sequences::length(std::size_t sequence, const SceneRecords& records) const {
  std::int64_t length = 0;
  forEachFrame(sequence, records,
               [&](std::int64_t /*frame*/, const std::string& /*image*/,
                   const std::string& /*labels*/) { ++length; });
  return length;
}

void Sequences::addLabels(const std::string& path, std::size_t sequence, char separator,
                          const SceneRecords& records, DatasetOutput& output) const {
  output.addFile(path, [&](std::ostream& file) {
    forEachFrame(sequence, records,
                 [&](std::int64_t frame, const std::string& /*image*/, const std::string& labels) {
                   file << withFrame(frame, separator, labels);
                 });
  });
}

void Sequences::addFrameList(const std::vector<std::string>& folders, const SceneRecords& records,
                             DatasetOutput& output) const {
  output.addFile(kFrameList, [&](std::ostream& list) {
    for (std::size_t i = 0; i < folders.size(); ++i) {
      forEachFrame(
          i, records,
          [&](std::int64_t frame, const std::string& image, const std::string& /*labels*/) {
            list << folders[i] << ' ' << frame << ' ' << image << '\n';
          });
    }
  });
}

}  // namespace synthetic_dataset
