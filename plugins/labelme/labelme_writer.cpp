#include <ostream>
#include <string>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/labelme/labelme_options.h"
#include "plugins/shared/json.h"
#include "plugins/shared/mask_outlines.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// LabelMe: `<split>/N.json` beside `<split>/N.png`, with a shape for each object, and
/// `labels.txt`. https://github.com/wkentaro/labelme; polygons run through pixel centres, as its
/// utils.shape_to_mask fills them including their rim.
class LabelMeWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    options_ = readLabelMeOptions(parameters);
    for (const ClassInfo& each : dataset.classes) names_.push_back(each.name);
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.visible_masks = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    Json shapes = Json::array();
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled()) continue;
      Json points = pointsOf(object, scene.camera);
      if (points.empty()) continue;
      shapes.push_back({{"label", object.class_name},
                        {"points", std::move(points)},
                        {"group_id", object.instance},
                        {"description", object.name},
                        {"shape_type", options_.as_rectangles ? "rectangle" : "polygon"},
                        {"flags", Json::object()}});
    }
    const std::string base = scene.splitFolder() + "/" + scene.name;
    const std::string image = base + "." + options_.image_format;
    output.addImage(image, scene.image);
    output.addText(base + ".json", indentedJson({{"version", "5.0.1"},
                                                 {"flags", Json::object()},
                                                 {"shapes", std::move(shapes)},
                                                 {"imagePath", image.substr(image.rfind('/') + 1)},
                                                 {"imageData", nullptr},
                                                 {"imageHeight", scene.camera.height()},
                                                 {"imageWidth", scene.camera.width()}}));
  }

  /// A polygon through the centres of the outermost pixels, or two corners of a box in coordinates
  /// in which the image spans 0 to its width.
  [[nodiscard]] Json pointsOf(const SceneObject& object, const CameraModel& camera) const {
    Json points = Json::array();
    if (!options_.as_rectangles) {
      for (const cv::Point& point : masks::centreRing(object.visible_mask())) {
        points.push_back({point.x, point.y});
      }
    } else if (const auto box = boxOf(object, options_.box, camera)) {
      points.push_back({box->left + 0.5, box->top + 0.5});
      points.push_back({box->right + 0.5, box->bottom + 0.5});
    }
    return points;
  }

  /// Writes the list of labels that LabelMe's own converters require.
  void doFinalize(const SceneRecords& /*records*/, DatasetOutput& output) const override {
    output.addFile("labels.txt", [&](std::ostream& file) {
      file << "__ignore__\n_background_\n";
      for (const std::string& name : names_) file << name << '\n';
    });
  }

  LabelMeOptions options_;
  std::vector<std::string> names_;  ///< of the classes
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::LabelMeWriter, synthetic_dataset::LabelWriter)
