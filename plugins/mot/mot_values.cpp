#include "plugins/mot/mot_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/mot/mot_options.h"
#include "plugins/readback/files.h"
#include "plugins/readback/sequence_values.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::mot {
namespace {

class MotValues : public ValueCheck {
 public:
  MotValues(MotOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), cameras_(dataset.cameras), sequences_(dataset) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    TrueSequence& sequence = sequences_.of(truth.scene);
    sequences_.addFrame(truth, options_.image_format, sequence, files);
    for (const SceneObject& object : truth.scene.objects) {
      sequence.labels += lineOf(object, truth.scene.camera, sequence.images.size());
    }
  }

  void checkDataset(FoundFiles& files) override {
    std::string frames;
    for (const TrueSequence& each : sequences_.all()) {
      const std::string folder = each.split + "/" + each.name;
      std::size_t frame = 0;
      for (const std::string& image : each.images) {
        frames += folder + " " + std::to_string(++frame) + " " + image + "\n";
      }
      if (!each.images.empty()) compareSequence(each, folder + "/", files);
    }
    files.compareText("frames.txt", frames);
  }

 private:
  /// https://arxiv.org/abs/1603.00831, Table 2: frame, track, left, top, width, height, whether it
  /// counts, class, visibility; all begin at 1.
  [[nodiscard]] std::string lineOf(const SceneObject& object, const CameraModel& camera,
                                   std::size_t frame) const {
    const bool is_seen = object.pixels.visible() > 0;
    const auto box = is_seen ? boxOf(object, options_.box, camera) : std::nullopt;
    if (!box) return "";
    std::string line = std::to_string(frame) + "," + std::to_string(object.instance);
    // Half a pixel from the centre to the edge, and one as they count from 1.
    const std::vector<double> numbers = {box->left + 1.5, box->top + 1.5, box->right - box->left,
                                         box->bottom - box->top};
    for (const double number : numbers) line += "," + fixed(number, kMotDecimals);
    return line + "," + std::to_string(object.dropped ? 0 : 1) + "," +
           std::to_string(options_.class_ids.at(object.class_id)) + "," +
           fixed(object.visibility(), kMotDecimals) + "\n";
  }

  void compareSequence(const TrueSequence& sequence, const std::string& folder,
                       FoundFiles& files) const {
    compareFrames(sequence, folder + "img1/", 1, options_.image_format, files);
    compareLabels(folder + "gt/gt.txt", sequence.labels, files);
    std::string names;
    for (const std::string& name : options_.names) names += name + "\n";
    files.compareText(folder + "gt/labels.txt", names);
    const CameraModel& camera = cameras_.at(sequence.camera).model;
    files.compareText(folder + "seqinfo.ini",
                      "[Sequence]\nname=" + sequence.name + "\nimDir=img1\nframeRate=" +
                          std::to_string(std::max(1L, std::lround(sequence.rate))) +
                          "\nseqLength=" + std::to_string(sequence.images.size()) +
                          "\nimWidth=" + std::to_string(camera.width()) +
                          "\nimHeight=" + std::to_string(camera.height()) + "\nimExt=." +
                          options_.image_format + "\n");
  }

  /// Number by number.
  static void compareLabels(const std::string& name, std::string lines, FoundFiles& files) {
    const auto file = files.take(name);
    if (!file) return;
    std::string found = readText(*file);
    if (found.find_first_of(" \t\r") != std::string::npos) {
      files.differences().add(name + ": found a space; numbers should have a comma between them");
    }
    for (std::string* text : {&found, &lines}) std::replace(text->begin(), text->end(), ',', ' ');
    formats::compareText(found, lines, name, files.differences());
  }

  MotOptions options_;
  std::vector<CameraDescription> cameras_;
  TrueSequences sequences_;
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<MotValues>(readMotOptions(parameters, dataset.classes), dataset);
}

}  // namespace synthetic_dataset::formats::mot
