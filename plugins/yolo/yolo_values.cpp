#include "plugins/yolo/yolo_values.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "plugins/yolo/yolo_options.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::yolo {
namespace {

class YoloValues : public ValueCheck {
 public:
  YoloValues(YoloOptions options, std::string main_list, const DatasetInfo& dataset)
      : options_(options), main_list_(std::move(main_list)), dataset_(dataset) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    files.compareWithScene(scene.name + ".png", truth);
    std::string lines;
    for (const SceneObject& object : scene.objects) {
      if (object.in_view && !object.dropped && object.loose_box) {
        lines += lineOf(object, scene.camera);
      }
    }
    files.compareText(scene.name + ".txt", lines);
    const std::string path = (files.folder() / (scene.name + ".png")).string() + "\n";
    list_ += path;
    lists_[scene.splitFolder()] += path;
  }

  void checkDataset(FoundFiles& files) override {
    // In the writer's folder, or anywhere else.
    const std::filesystem::path path = (files.folder() / main_list_).lexically_normal();
    const std::filesystem::path below = path.lexically_relative(files.folder());
    const std::string main_list = *below.begin() == ".." ? path.string() : below.string();
    files.compareText(main_list, list_);
    const std::vector<std::string> splits = dataset_.splitFolders();
    for (const std::string& split : splits) {
      const bool is_only = dataset_.splits.size() < 2;
      if (is_only && main_list == split + ".txt") continue;  // it is the same list
      files.compareText(split + ".txt", is_only ? list_ : lists_[split]);
    }
    const std::vector<std::string> names = dataset_.classNamesWithoutGaps();
    std::string lines;
    for (const std::string& name : names) lines += name + "\n";
    files.compareText(kYoloNames, lines);
    const bool has_val = std::find(splits.begin(), splits.end(), "val") != splits.end();
    const std::string folder = files.folder().string();
    files.compareText(
        "obj.data", "classes = " + std::to_string(names.size()) + "\ntrain = " + folder +
                        splits.front() + ".txt\nvalid = " + folder +
                        (has_val ? "val" : splits.back()) + ".txt\nnames = " + folder + kYoloNames +
                        "\nbackup = backup\n");
  }

 private:
  [[nodiscard]] std::string lineOf(const SceneObject& object, const CameraModel& camera) const {
    const double width = camera.width();
    const double height = camera.height();
    const auto box = yoloBox(*object.loose_box, options_, width, height);
    if (!box) return "";
    std::string line = yoloClass(object, options_);
    for (const double fraction :
         {0.5 * (box->left + box->right) / width, 0.5 * (box->top + box->bottom) / height,
          (box->right - box->left) / width, (box->bottom - box->top) / height}) {
      line += " " + fixed(fraction, kYoloDecimals);
    }
    return line + "\n";
  }

  YoloOptions options_;
  std::string main_list_;
  DatasetInfo dataset_;
  std::string list_;                          ///< of all images
  std::map<std::string, std::string> lists_;  ///< by split
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  const YoloOptions options = readYoloOptions(parameters);
  return std::make_unique<YoloValues>(options, parameters.required<std::string>("main_list"),
                                      dataset);
}

}  // namespace synthetic_dataset::formats::yolo
