#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <ostream>
#include <utility>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/cityscapes/cityscapes_files.h"
#include "plugins/cityscapes/cityscapes_options.h"
#include "plugins/shared/mask_outlines.h"
#include "plugins/shared/pixel_map.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

/// The stem of an image's file names: `<city>_<sequence>_<frame>` with six digits each. The frame
/// is the one of 30 that Cityscapes labels in each sequence.
std::string imageName(const std::string& city, std::int64_t instant) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "_%06lld_000019", static_cast<long long>(instant));
  return city + digits.data();
}

/// The values of one instance's pixels in the pictures.
struct PixelValues {
  uchar label = 0;
  ushort instance = 0;
};

}  // namespace

/// Cityscapes: `leftImg8bit/<split>/<city>/` with images (also in `imgsFine/leftImg8bit/`, as in
/// some releases), `gtFine/<split>/<city>/` with pictures of labels, instances and colours and with
/// polygons, `camera/<split>/<city>/`; a camera is a city.
/// https://github.com/mcordts/cityscapesScripts
class CityscapesWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    cities_ = cityNames(dataset.cameras);
    options_ = readCityscapesOptions(parameters, dataset.classes, dataset.world_classes);
    train_ids_.fill(kCityscapesIgnored);
    for (const CityscapesEntry& each : options_.table) {
      const auto label = static_cast<std::size_t>(each.id);
      const auto channel = [&](std::size_t i) { return static_cast<uchar>(each.colour[i]); };
      train_ids_.at(label) = static_cast<uchar>(each.train_id);
      colours_.at(label) = {channel(2), channel(1), channel(0)};
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.visible_masks = true;
    requirements.world_map = !options_.world.empty();
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    const std::string& city = cities_.at(scene.camera_index);
    const std::string name =
        scene.splitFolder() + "/" + city + "/" + imageName(city, scene.instant);
    std::vector<CityscapesPolygon> polygons;
    const std::vector<PixelValues> values = valuesOf(scene, polygons, output);
    const cv::Mat_<ushort> instances = scene.instance_map();
    auto labels =
        mapped<uchar>(instances, [&](ushort instance) { return values.at(instance).label; });
    auto instance_ids =
        mapped<ushort>(instances, [&](ushort instance) { return values.at(instance).instance; });
    std::vector<CityscapesPolygon> of_world = addWorld(scene, labels, instance_ids);
    polygons.insert(polygons.begin(), of_world.begin(), of_world.end());  // behind the objects

    output.addImage("leftImg8bit/" + name + "_leftImg8bit.png", scene.image);
    output.addImage("imgsFine/leftImg8bit/" + name + "_leftImg8bit.png", scene.image);
    output.addImage("gtFine/" + name + "_gtFine_labelIds.png", labels);
    output.addImage("gtFine/" + name + "_gtFine_labelTrainIds.png",
                    mapped<uchar>(labels, [&](uchar label) { return train_ids_[label]; }));
    output.addImage("gtFine/" + name + "_gtFine_instanceIds.png", instance_ids);
    output.addImage("gtFine/" + name + "_gtFine_color.png",
                    mapped<cv::Vec3b>(labels, [&](uchar label) { return colours_[label]; }));
    output.addText("gtFine/" + name + "_gtFine_polygons.json",
                   polygonsJson(scene.camera, polygons));
    output.addText("camera/" + name + "_camera.json", cameraJson(scene));
    warnOfDistortion(scene.camera, output);
  }

  /// Returns the pixel values of each instance, and adds the polygons of those with a label.
  /// Objects without a label stay unlabeled; objects of one label after the 1000th form a group, as
  /// in Cityscapes.
  [[nodiscard]] std::vector<PixelValues> valuesOf(const Scene& scene,
                                                  std::vector<CityscapesPolygon>& polygons,
                                                  SceneOutput& output) const {
    std::vector<PixelValues> values(scene.objects.size() + 1);
    values[0] = {static_cast<uchar>(options_.world_id), static_cast<ushort>(options_.world_id)};
    std::map<int, int> counts;  // by label
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled()) continue;
      const CityscapesLabel& label = labelOf(object.class_id);
      const int number = counts[label.id]++;
      const bool is_single = number < kCityscapesInstances;
      if (!is_single) {
        output.addWarning(
            "more than 1000 objects of one label in an image: the rest are "
            "written as a group");
      }
      values.at(static_cast<std::size_t>(object.instance)) = {
          static_cast<uchar>(label.id),
          static_cast<ushort>(is_single ? label.id * kCityscapesInstances + number : label.id)};
      masks::Ring ring = masks::centreRing(object.visible_mask());
      if (!ring.empty()) {
        polygons.push_back({label.name + (is_single ? "" : "group"), std::move(ring)});
      }
    }
    return values;
  }

  /// Draws the labels of the world's classes, and returns a polygon for each.
  [[nodiscard]] std::vector<CityscapesPolygon> addWorld(const Scene& scene, cv::Mat_<uchar>& labels,
                                                        cv::Mat_<ushort>& instances) const {
    std::vector<CityscapesPolygon> polygons;
    for (std::size_t i = 0; i < options_.world.size(); ++i) {
      const CityscapesLabel& label = options_.world[i];
      const cv::Mat mask =
          (scene.instance_map() == 0) & (scene.world_map() == static_cast<double>(i + 1));
      labels.setTo(label.id, mask);
      instances.setTo(label.id, mask);
      masks::Ring ring = masks::centreRing(Mask(mask));
      if (!ring.empty()) polygons.push_back({label.name, std::move(ring)});
    }
    return polygons;
  }

  [[nodiscard]] const CityscapesLabel& labelOf(int class_id) const {
    return *std::find_if(options_.labels.begin(), options_.labels.end(),
                         [&](const CityscapesLabel& label) { return label.class_id == class_id; });
  }

  void doFinalize(const SceneRecords& /*records*/, DatasetOutput& output) const override {
    output.addFile("labels.json",
                   [&](std::ostream& file) { writeLabelTable(file, options_.table); });
    output.addFile("label_colors.txt",
                   [&](std::ostream& file) { writeLabelColours(file, options_.table); });
  }

  std::vector<std::string> cities_;  ///< by camera
  CityscapesOptions options_;
  std::array<uchar, 256> train_ids_ = {};    ///< by label
  std::array<cv::Vec3b, 256> colours_ = {};  ///< by label; blue, green, red
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::CityscapesWriter, synthetic_dataset::LabelWriter)
