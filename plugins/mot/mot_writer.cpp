#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/mot/mot_options.h"
#include "plugins/shared/pose_formats.h"
#include "plugins/shared/sequences.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// MOTChallenge's tracking: `<split>/<sequence>/` with `img1/NNNNNN.jpg`, `gt/gt.txt` and
/// `seqinfo.ini`. Frames, tracks and pixels count from 1. https://motchallenge.net/instructions,
/// https://arxiv.org/abs/1906.04567
class MotWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    options_ = readMotOptions(parameters, dataset.classes);
    sequences_ = Sequences(dataset, 1);
    cameras_ = dataset.cameras;
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.visible_masks = true;
    requirements.visibility = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    std::string labels;
    for (const SceneObject& object : scene.objects) labels += label(object, scene.camera);
    sequences_.addFrame(scene, options_.image_format, labels, output);
  }

  /// An object's line without the frame number. Objects that are dropped for being barely visible
  /// have 0 in the seventh column: neither a hit nor a miss in the evaluation.
  [[nodiscard]] std::string label(const SceneObject& object, const CameraModel& camera) const {
    if (object.pixels.visible() == 0) return "";
    const auto box = boxOf(object, options_.box, camera);
    if (!box) return "";
    std::string line = std::to_string(object.instance);
    // The first pixel is 1, and the box's edges are the outer edges of its pixels.
    for (const double number : {box->left + 1.5, box->top + 1.5, box->width(), box->height()}) {
      line += "," + fixed(number, kMotDecimals);
    }
    return line + (object.dropped ? ",0," : ",1,") +
           std::to_string(options_.class_ids.at(object.class_id)) + "," +
           fixed(object.visibility(), kMotDecimals) + "\n";
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    std::vector<std::string> folders;
    for (const Sequences::Sequence& each : sequences_.all()) {
      folders.push_back(each.split + "/" + each.name);
      addSequence(folders.size() - 1, folders.back() + "/", records, output);
    }
    sequences_.addFrameList(folders, records, output);
  }

  void addSequence(std::size_t sequence, const std::string& folder, const SceneRecords& records,
                   DatasetOutput& output) const {
    const std::int64_t length = sequences_.length(sequence, records);
    if (length == 0) return;
    sequences_.forEachFrame(
        sequence, records,
        [&](std::int64_t frame, const std::string& image, const std::string& /*labels*/) {
          output.addLink(folder + "img1/" + sixDigits(frame) + "." + options_.image_format, image);
        });
    sequences_.addLabels(folder + "gt/gt.txt", sequence, ',', records, output);
    output.addFile(folder + "gt/labels.txt", [&](std::ostream& file) {
      for (const std::string& name : options_.names) file << name << '\n';
    });
    output.addFile(folder + "seqinfo.ini",
                   [&](std::ostream& file) { writeInfo(sequence, length, file); });
  }

  void writeInfo(std::size_t sequence, std::int64_t length, std::ostream& file) const {
    const Sequences::Sequence& each = sequences_.all()[sequence];
    const CameraModel& camera = cameras_.at(each.camera).model;
    file << "[Sequence]\nname=" << each.name
         << "\nimDir=img1\nframeRate=" << std::max(std::llround(each.rate), 1LL)
         << "\nseqLength=" << length << "\nimWidth=" << camera.width()
         << "\nimHeight=" << camera.height() << "\nimExt=." << options_.image_format << '\n';
  }

  MotOptions options_;
  Sequences sequences_;
  std::vector<CameraDescription> cameras_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::MotWriter, synthetic_dataset::LabelWriter)
