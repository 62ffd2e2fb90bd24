#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>
#include <string>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/yolo/yolo_options.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// Darknet's YOLO: `N.png` and, with a line an object, `N.txt`: class, then centre and size of the
/// loose box as fractions of the image. The main list names all images, for `train` in Darknet's
/// data file. https://github.com/AlexeyAB/darknet#how-to-train-to-detect-your-custom-objects
class YoloWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    parameters.ignore("tf_timeout");  // of nn_data_collection
    main_list_ = parameters.requiredFile(kMainList);
    options_ = readYoloOptions(parameters);
    output_folder_ = parameters.outputFolder();
    if (!isOfAScene(main_list_.path(), dataset)) return;
    parameters.addError(kMainList, "found '" + main_list_.path() +
                                       "', where a scene's files go; the list should have another "
                                       "name, 'list.txt' for instance");
  }

  /// Whether a path is that of a scene's image or labels, or of a folder that they lie in.
  [[nodiscard]] bool isOfAScene(const std::string& path, const DatasetInfo& dataset) const {
    namespace fs = std::filesystem;
    const fs::path below = fs::path(path).lexically_normal().lexically_relative(output_folder_);
    const auto isCamera = [&](const CameraDescription& camera) { return below == camera.name; };
    if (std::any_of(dataset.cameras.begin(), dataset.cameras.end(), isCamera)) return true;
    const std::string stem = below.stem().string();
    const std::string extension = below.extension().string();
    const bool is_inside = !below.empty() && *below.begin() != "..";
    return is_inside && (extension == ".png" || extension == ".txt") && stem.size() >= 8 &&
           std::all_of(stem.begin(), stem.end(), [](unsigned char c) { return std::isdigit(c); });
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    std::string labels;
    for (const SceneObject& object : scene.objects) labels += label(object, scene.camera);

    output.addImage(scene.name + ".png", scene.image);
    output.addText(scene.name + ".txt", labels);
    output.addRecord(kImages, scene.name + ".png");
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    output.addFileAtParameter(main_list_, [&](std::ostream& list) {
      records.forEach(kImages, [&](std::int64_t /*scene*/, const std::string& image) {
        list << output_folder_ << image << '\n';
      });
    });
  }

  /// An object's line; nothing for one of which no area is in view.
  [[nodiscard]] std::string label(const SceneObject& object, const CameraModel& camera) const {
    if (!object.in_view || object.dropped || !object.loose_box) return "";
    const double width = camera.width();
    const double height = camera.height();
    const auto box = yoloBox(*object.loose_box, options_, width, height);
    if (!box) return "";
    std::string line = object.class_text;
    for (const double fraction :
         {(box->left + box->right) / 2.0 / width, (box->top + box->bottom) / 2.0 / height,
          box->width() / width, box->height() / height}) {
      line += " " + fixed(fraction, kYoloDecimals);
    }
    return line + "\n";
  }

  static constexpr const char* kMainList = "main_list";
  static constexpr const char* kImages = "images";  // of records

  FileParameter main_list_;
  YoloOptions options_;
  std::string output_folder_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::YoloWriter, synthetic_dataset::LabelWriter)
