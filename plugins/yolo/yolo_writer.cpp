#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/yolo/yolo_options.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

constexpr const char* kData = "obj.data";

/// Whether Darknet accepts the text as a class: its data.c reads `fscanf(file, "%d %f %f %f %f",
/// ...)`, and ignores all labels from the first line that does not match.
bool isNumber(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

/// Darknet's YOLO: `N.png` and, with one line per object, `N.txt`: class, then centre and size of
/// the loose box as fractions of the image. The main list names all images; `obj.data` names the
/// list of each split and that of the classes, `obj.names`.
/// https://github.com/AlexeyAB/darknet#how-to-train-to-detect-your-custom-objects
class YoloWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    parameters.ignore("tf_timeout");  // a parameter of nn_data_collection
    main_list_ = parameters.requiredFile(kMainList);
    options_ = readYoloOptions(parameters);
    output_folder_ = parameters.outputFolder();
    names_ = dataset.classNamesWithoutGaps();
    splits_ = dataset.splitFolders();
    has_one_list_ = dataset.splits.size() < 2;
    if (isOfAScene(main_list_.path(), dataset)) {
      parameters.addError(kMainList,
                          "found '" + main_list_.path() +
                              "', where a scene's files go; the list should have another "
                              "name, 'list.txt' for instance");
    } else if (isOfTheDataset(main_list_.path())) {
      parameters.addError(kMainList, "found '" + main_list_.path() +
                                         "', where this writer puts another file for Darknet; the "
                                         "list should have another name, 'list.txt' for instance");
    }
  }

  /// Whether a path is that of a scene's image or labels, or of a folder that contains them.
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

  /// Whether a path is that of another file written by doFinalize.
  [[nodiscard]] bool isOfTheDataset(const std::string& path) const {
    if (path == output_folder_ + kData || path == output_folder_ + kYoloNames) return true;
    return !has_one_list_ && std::any_of(splits_.begin(), splits_.end(),
                                         [&](const auto& split) { return path == listOf(split); });
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    std::string labels;
    for (const SceneObject& object : scene.objects) {
      const std::string line = label(object, scene.camera);
      labels += line;
      if (!line.empty() && !isNumber(yoloClass(object, options_))) {
        output.addWarning(
            "a class is a text, and Darknet ignores an image's labels from there on; "
            "nn_data_collection's readers need it so, Darknet needs `class: number`");
      }
    }

    output.addImage(scene.name + ".png", scene.image);
    output.addText(scene.name + ".txt", labels);
    output.addRecord(kImages, scene.name + ".png");
    if (!has_one_list_) output.addRecord(scene.split, scene.name + ".png");
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    const auto writeList = [&](const std::string& channel) {
      return [this, &records, channel](std::ostream& list) {
        records.forEach(channel, [&](std::int64_t /*scene*/, const std::string& image) {
          list << output_folder_ << image << '\n';
        });
      };
    };
    output.addFileAtParameter(main_list_, writeList(kImages));
    for (const std::string& split : splits_) {
      if (has_one_list_ && main_list_.path() == listOf(split)) continue;  // it is the same list
      output.addFile(split + ".txt", writeList(has_one_list_ ? kImages : split));
    }
    output.addFile(kYoloNames, [&](std::ostream& names) {
      for (const std::string& name : names_) names << name << '\n';
    });
    output.addFile(kData, [&](std::ostream& data) { writeData(data); });
  }

  /// Darknet's data file (its option_list.c): the lists to train with and to evaluate on.
  void writeData(std::ostream& data) const {
    const bool has_val = std::find(splits_.begin(), splits_.end(), "val") != splits_.end();
    data << "classes = " << names_.size() << '\n'
         << "train = " << listOf(splits_.front()) << '\n'
         << "valid = " << listOf(has_val ? "val" : splits_.back()) << '\n'
         << "names = " << output_folder_ << kYoloNames << '\n'
         << "backup = backup\n";
  }

  [[nodiscard]] std::string listOf(const std::string& split) const {
    return output_folder_ + split + ".txt";
  }

  /// An object's line; empty if no area of it is in view.
  [[nodiscard]] std::string label(const SceneObject& object, const CameraModel& camera) const {
    if (!object.inView(camera) || object.dropped) return "";
    const double width = camera.width();
    const double height = camera.height();
    const auto box = yoloBox(*object.loose_box, options_, width, height);
    if (!box) return "";
    std::string line = yoloClass(object, options_);
    for (const double fraction :
         {(box->left + box->right) / 2.0 / width, (box->top + box->bottom) / 2.0 / height,
          box->width() / width, box->height() / height}) {
      line += " " + fixed(fraction, kYoloDecimals);
    }
    return line + "\n";
  }

  static constexpr const char* kMainList = "main_list";
  static constexpr const char* kImages = "images";  // channel of records

  FileParameter main_list_;
  YoloOptions options_;
  std::string output_folder_;
  std::vector<std::string> names_;  ///< of classes, by number
  std::vector<std::string> splits_;
  bool has_one_list_ = true;  ///< all images belong to one split
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::YoloWriter, synthetic_dataset::LabelWriter)
