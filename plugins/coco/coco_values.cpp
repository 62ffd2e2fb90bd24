#include "plugins/coco/coco_values.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

#include "plugins/coco/coco_index.h"
#include "plugins/coco/coco_options.h"
#include "plugins/coco/coco_rle.h"
#include "plugins/coco/coco_true_keypoints.h"
#include "plugins/readback/json_file.h"
#include "plugins/readback/json_text.h"
#include "plugins/readback/mask_shapes.h"
#include "plugins/readback/true_parts.h"
#include "plugins/shared/colour_map.h"

namespace synthetic_dataset::formats::coco {
namespace {

using nlohmann::json;

int categoryOf(int class_id) { return class_id + 1; }

json boxJson(const Box& box) {
  return {box.left + 0.5, box.top + 0.5, box.right - box.left, box.bottom - box.top};
}

class CocoValues : public ValueCheck {
 public:
  CocoValues(CocoOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), dataset_(dataset), keypoints_(dataset, options_) {
    if (options_.panoptic) stuff_ = dataset_.world_classes;
    if (!options_.background.empty()) stuff_.push_back(options_.background);
  }

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string split = scene.splitFolder();
    const std::string file_name = scene.name + "." + options_.image_format;
    files.compareWithScene("images/" + (dataset_.splits.empty() ? "" : split + "/") + file_name,
                           truth);
    std::vector<Annotation> annotations;
    json segments = json::array();
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (!object.labelled() || !object.visible_box() || !box) continue;
      annotations.push_back(annotationOf(scene, object, *box));
      segments.push_back({{"id", object.instance},
                          {"category_id", categoryOf(object.class_id)},
                          {"area", object.visible_mask().count()},
                          {"bbox", boxJson(*object.visible_box())},
                          {"iscrowd", 0}});
    }
    const auto index = indexOf(instancesOf(split), files);
    compareImage(*index, scene, file_name, files);
    compareAnnotations(*index, scene, annotations, files);
    counts_[instancesOf(split)].images += 1;
    counts_[instancesOf(split)].annotations += annotations.size();
    if (options_.panoptic) comparePanoptic(scene, segments, files);
  }

  void checkDataset(FoundFiles& files) override {
    for (const std::string& split : dataset_.splitFolders()) {
      compareRest(instancesOf(split), instanceCategories(), files);
      if (options_.panoptic) compareRest("panoptic_" + split, panopticCategories(), files);
    }
  }

 private:
  struct Annotation {
    json members;  ///< all but what is a segmentation
    const Mask* mask = nullptr;
    std::vector<TruePart> parts;
  };

  struct Counts {
    std::size_t images = 0;
    std::size_t annotations = 0;
  };

  static std::string pathOf(const std::string& name) { return "annotations/" + name + ".json"; }

  static std::shared_ptr<const CocoIndex> indexOf(const std::string& name,
                                                  const FoundFiles& files) {
    return files.kept().get<CocoIndex>(files.folder() / pathOf(name));
  }

  [[nodiscard]] Annotation annotationOf(const Scene& scene, const SceneObject& object,
                                        const Box& box) const {
    const auto count = static_cast<std::int64_t>(dataset_.objects.size());
    json annotation = {{"id", scene.index * count + object.instance}, {"image_id", scene.index + 1},
                       {"category_id", categoryOf(object.class_id)},  {"bbox", boxJson(box)},
                       {"area", object.visible_mask().count()},       {"iscrowd", 0}};
    if (keypoints_.any()) keypoints_.addTo(annotation, object);
    json more = {{"object", asJsonHasIt(object.name)},
                 {"id", asJsonHasIt(object.id)},
                 {"visibility", object.visibility()},
                 {"truncation", object.truncation()}};
    if (object.silhouette_box()) more["amodal_bbox"] = boxJson(*object.silhouette_box());
    std::vector<TruePart> parts;
    if (!dataset_.objects.at(static_cast<std::size_t>(object.instance - 1)).part_names.empty()) {
      parts = trueParts(scene, object, dataset_);
      more["parts"] = json::array();
      for (const TruePart& each : parts) {
        more["parts"].push_back({{"name", asJsonHasIt(each.name)},
                                 {"bbox", boxJson(each.box())},
                                 {"area", each.mask.count()}});
      }
    }
    annotation["synthetic_dataset"] = std::move(more);
    return {std::move(annotation), &object.visible_mask(), std::move(parts)};
  }

  static void compareImage(const CocoIndex& index, const Scene& scene, const std::string& file_name,
                           FoundFiles& files) {
    const json right = {{"id", scene.index + 1},
                        {"file_name", asJsonHasIt(file_name)},
                        {"width", scene.camera.width()},
                        {"height", scene.camera.height()},
                        {"synthetic_dataset",
                         {{"camera", asJsonHasIt(scene.camera_name)},
                          {"instant", scene.instant},
                          {"stamp_ns", scene.stamp.count()}}}};
    const std::string where = "the image '" + file_name + "'";
    const auto found = index.image(asJsonHasIt(file_name));
    if (found) {
      compareJson(*found, right, where, files.differences());
    } else {
      files.differences().add(where + " is not listed");
    }
  }

  void compareAnnotations(const CocoIndex& index, const Scene& scene,
                          const std::vector<Annotation>& annotations, FoundFiles& files) const {
    std::vector<json> found = index.annotationsOf(scene.index + 1);
    for (const Annotation& annotation : annotations) {
      const json& right = annotation.members;
      const std::string where =
          "the annotation of '" + right["synthetic_dataset"]["object"].get<std::string>() + "'";
      const auto same = std::find_if(found.begin(), found.end(), [&](const json& each) {
        return each.is_object() && each.value("id", json()) == right["id"];
      });
      if (same == found.end()) {
        files.differences().add(where + " has another id than " + right["id"].dump());
        continue;
      }
      compareSegmentation(*same, *annotation.mask, where, files.differences());
      compareParts((*same)["synthetic_dataset"], annotation.parts, where, files.differences());
      compareJson(*same, right, where, files.differences());
      found.erase(same);
    }
    for (const json& each : found) {
      files.differences().add("found an annotation of no object: " + each.dump().substr(0, 100));
    }
  }

  /// @param more  the members that are not COCO's
  void compareParts(json& more, const std::vector<TruePart>& parts, const std::string& where,
                    Differences& differences) const {
    const auto found = more.find("parts");
    if (found == more.end()) return;  // seen among the members where it should be there
    for (std::size_t i = 0; i < std::min(found->size(), parts.size()); ++i) {
      compareSegmentation(found->at(i), parts[i].mask, where + "/parts/" + parts[i].name,
                          differences);
    }
  }

  /// @param holder  of the segmentation, which is taken out
  void compareSegmentation(json& holder, const Mask& mask, const std::string& where,
                           Differences& differences) const {
    const json found = holder.at("segmentation");
    holder.erase("segmentation");
    cv::Mat pixels;
    if (options_.as_polygons) {
      pixels = maskOfEdges(found, mask.imageSize());
    } else {
      const json rest = {{"size", {mask.imageSize().height, mask.imageSize().width}},
                         {"counts", found.at("counts")}};
      compareJson(found, rest, where + "/segmentation", differences);
      pixels = maskOfCocoCounts(found.at("counts").get<std::string>(), mask.imageSize());
    }
    if (cv::countNonZero(pixels != mask.whole()) > 0) {
      differences.add(where + ": its segmentation is not its visible mask");
    }
  }

  void comparePanoptic(const Scene& scene, json segments, FoundFiles& files) {
    const std::string split = scene.splitFolder();
    const std::string file_name = scene.name + ".png";
    cv::Mat ids(scene.camera.height(), scene.camera.width(), CV_8UC3, cv::Scalar::all(0));
    for (std::size_t i = 0; i < stuff_.size(); ++i) addStuff(scene, i, segments, ids);
    for (const SceneObject& object : scene.objects) {
      const bool is_segment = std::any_of(segments.begin(), segments.end(), [&](const json& each) {
        return each["id"] == object.instance;
      });
      if (!is_segment) continue;
      ids.setTo(colourOf(object.instance), object.visible_mask().whole());
    }
    files.comparePicture("annotations/panoptic_" + split + "/" + file_name, ids);
    const auto index = indexOf("panoptic_" + split, files);
    const std::vector<json> found = index->annotationsOf(scene.index + 1);
    const json right = {{"image_id", scene.index + 1},
                        {"file_name", asJsonHasIt(file_name)},
                        {"segments_info", segments}};
    const std::string where = "the panoptic annotation of '" + file_name + "'";
    if (found.size() != 1) {
      files.differences().add(where, std::to_string(found.size()) + " of them", "one");
    } else {
      compareJson(found.front(), right, where, files.differences());
    }
    compareImage(*index, scene, scene.name + "." + options_.image_format, files);
    counts_["panoptic_" + split].images += 1;
    counts_["panoptic_" + split].annotations += 1;
  }

  /// An id is red + 256 green + 256^2 blue.
  static cv::Scalar colourOf(int id) { return cv::Scalar(id / 65536, id / 256 % 256, id % 256); }

  /// The segment of a class of the world, or of the rest of it.
  void addStuff(const Scene& scene, std::size_t index, json& segments, cv::Mat& ids) const {
    const bool is_class = index < dataset_.world_classes.size();
    const cv::Mat pixels = dataset_.world_classes.empty()
                               ? trueWorld(scene)
                               : trueWorldClass(scene, is_class ? index + 1 : 0);
    const Mask mask(pixels);
    if (mask.empty()) return;
    const int id = static_cast<int>(scene.objects.size() + index) + 1;
    ids.setTo(colourOf(id), pixels);
    const cv::Rect bounds = mask.bounds();
    segments.push_back({{"id", id},
                        {"category_id", stuffCategory(index)},
                        {"area", mask.count()},
                        {"bbox", {bounds.x, bounds.y, bounds.width, bounds.height}},
                        {"iscrowd", 0}});
  }

  [[nodiscard]] int stuffCategory(std::size_t index) const {
    return categoryOf(dataset_.classes.back().id + 1 + static_cast<int>(index));
  }

  [[nodiscard]] std::string instancesOf(const std::string& split) const {
    return options_.annotation_file + "_" + split;
  }

  void compareRest(const std::string& name, const json& categories, FoundFiles& files) {
    if (!files.take(pathOf(name))) return;
    const auto index = indexOf(name, files);
    json found = index->rest();
    found["categories"] = index->categories();
    found["images"] = index->imageCount();
    found["annotations"] = index->annotationCount();
    const json right = {
        {"info", {{"description", "Made by synthetic_dataset"}, {"version", "1.0"}}},
        {"licenses", licenses()},
        {"categories", categories},
        {"images", counts_[name].images},
        {"annotations", counts_[name].annotations}};
    compareJson(found, right, pathOf(name), files.differences());
  }

  [[nodiscard]] json licenses() const {
    json all = json::array();
    for (const CreditInfo& credit : dataset_.credits) {
      json files = json::array();
      for (const std::string& each : credit.files) files.push_back(asJsonHasIt(each));
      all.push_back(
          {{"id", all.size() + 1},
           {"name", asJsonHasIt(credit.license)},
           {"url", ""},
           {"synthetic_dataset", {{"author", asJsonHasIt(credit.author)}, {"files", files}}}});
    }
    return all;
  }

  [[nodiscard]] json instanceCategories() const {
    json categories = json::array();
    for (const ClassInfo& each : dataset_.classes) {
      json category = {{"id", categoryOf(each.id)},
                       {"name", asJsonHasIt(each.name)},
                       {"supercategory", "object"}};
      keypoints_.addTo(category, each.id);
      categories.push_back(std::move(category));
    }
    return categories;
  }

  [[nodiscard]] json panopticCategories() const {
    const std::vector<cv::Vec3b> colours = vocColourMap();
    json categories = json::array();
    const auto add = [&](int id, const std::string& name, const std::string& kind) {
      const cv::Vec3b& colour = colours[1 + categories.size() % (colours.size() - 1)];
      categories.push_back({{"id", id},
                            {"name", asJsonHasIt(name)},
                            {"supercategory", kind},
                            {"isthing", kind == "object" ? 1 : 0},
                            {"color", {colour[2], colour[1], colour[0]}}});
    };
    for (const ClassInfo& each : dataset_.classes) add(categoryOf(each.id), each.name, "object");
    for (std::size_t i = 0; i < stuff_.size(); ++i) add(stuffCategory(i), stuff_[i], "world");
    return categories;
  }

  CocoOptions options_;
  DatasetInfo dataset_;
  TrueKeypoints keypoints_;
  std::vector<std::string> stuff_;        ///< names of the world's classes, and of the rest
  std::map<std::string, Counts> counts_;  ///< by annotation file
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<CocoValues>(readCocoOptions(parameters), dataset);
}

}  // namespace synthetic_dataset::formats::coco
