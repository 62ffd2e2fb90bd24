#include "plugins/labelme/labelme_values.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "plugins/labelme/labelme_options.h"
#include "plugins/readback/json_file.h"
#include "plugins/readback/json_text.h"
#include "plugins/readback/mask_shapes.h"

namespace synthetic_dataset::formats::labelme {
namespace {

using nlohmann::json;

/// A shape as it should be.
struct TrueShape {
  json members;
  const Mask* polygon = nullptr;  ///< what its points enclose, where they are no corners
};

class LabelMeValues : public ValueCheck {
 public:
  LabelMeValues(LabelMeOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), classes_(dataset.classes) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string name = scene.splitFolder() + "/" + scene.name;
    const std::string image = name + "." + options_.image_format;
    files.compareWithScene(image, truth);
    const auto file = files.take(name + ".json");
    if (!file) return;
    const std::vector<TrueShape> shapes = shapesOf(scene);
    json right = {{"version", "5.0.1"},
                  {"flags", json::object()},
                  {"shapes", json::array()},
                  {"imagePath", asJsonHasIt(image.substr(image.rfind('/') + 1))},
                  {"imageData", nullptr},
                  {"imageHeight", scene.camera.height()},
                  {"imageWidth", scene.camera.width()}};
    for (const TrueShape& each : shapes) right["shapes"].push_back(each.members);
    readJson(*file, [&](json found) {
      comparePolygons(found.at("shapes"), shapes, name + ".json", files.differences());
      compareJson(found, right, name + ".json", files.differences());
    });
  }

  void checkDataset(FoundFiles& files) override {
    std::string names = "__ignore__\n_background_\n";
    for (const ClassInfo& each : classes_) names += each.name + "\n";
    files.compareText("labels.txt", names);
  }

 private:
  [[nodiscard]] std::vector<TrueShape> shapesOf(const Scene& scene) const {
    std::vector<TrueShape> shapes;
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled()) continue;
      TrueShape shape;
      shape.members = {{"label", asJsonHasIt(object.class_name)},
                       {"group_id", object.instance},
                       {"description", asJsonHasIt(object.name)},
                       {"shape_type", options_.as_rectangles ? "rectangle" : "polygon"},
                       {"flags", json::object()}};
      if (options_.as_rectangles) {
        const auto box = boxOf(object, options_.box, scene.camera);
        if (!box) continue;
        shape.members["points"] = {{box->left + 0.5, box->top + 0.5},
                                   {box->right + 0.5, box->bottom + 0.5}};
      } else {
        if (object.visible_mask().empty()) continue;
        shape.polygon = &object.visible_mask();
      }
      shapes.push_back(std::move(shape));
    }
    return shapes;
  }

  /// Takes the points of polygons away: others may enclose the same pixels.
  static void comparePolygons(json& found, const std::vector<TrueShape>& shapes,
                              const std::string& where, Differences& differences) {
    for (std::size_t i = 0; i < std::min(found.size(), shapes.size()); ++i) {
      if (shapes[i].polygon == nullptr) continue;
      const std::string problem = outlineProblem(found[i].at("points"), *shapes[i].polygon);
      if (!problem.empty()) {
        differences.add(where + "/shapes/" + std::to_string(i) + ": " + problem);
      }
      found[i].erase("points");
    }
  }

  LabelMeOptions options_;
  std::vector<ClassInfo> classes_;
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<LabelMeValues>(readLabelMeOptions(parameters), dataset);
}

}  // namespace synthetic_dataset::formats::labelme
