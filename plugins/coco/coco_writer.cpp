#include <algorithm>
#include <map>
#include <ostream>

#include <opencv2/core.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "plugins/coco/coco_keypoints.h"
#include "plugins/coco/coco_options.h"
#include "plugins/shared/colour_map.h"
#include "plugins/shared/json.h"
#include "plugins/shared/mask_outlines.h"
#include "plugins/shared/mask_rle.h"
#include "plugins/shared/seen_parts.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/mask.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
namespace {

/// The mask as COCO's `segmentation`.
Json segmentationOf(const Mask& mask, bool as_polygons) {
  if (!as_polygons) {
    return {{"size", {mask.imageSize().height, mask.imageSize().width}},
            {"counts", masks::cocoCounts(masks::columnRuns(mask))}};
  }
  Json polygons = Json::array();
  for (const masks::Ring& ring : masks::edgeRings(mask)) {
    Json polygon = Json::array();
    for (const cv::Point& corner : ring) {
      polygon.push_back(corner.x);
      polygon.push_back(corner.y);
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace

/// COCO: instances, keypoints and, if asked for, panoptic segmentation.
/// https://cocodataset.org/#format-data, read by pycocotools. Boxes and polygons have coordinates
/// in which the image spans 0 to its width; keypoints have those in which pixel centres are
/// integers (detectron2's loader adds half a pixel to keypoints only).
class CocoWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    options_ = readCocoOptions(parameters);
    checkNames(parameters, dataset);
    if (options_.keypoints) {
      keypoints_ = CocoKeypoints(dataset, options_.keypoint_classes, options_.pad_keypoints);
    }
    classes_ = dataset.classes;
    if (options_.panoptic) stuff_ = dataset.world_classes;
    has_world_classes_ = !stuff_.empty();
    if (!options_.background.empty()) stuff_.push_back(options_.background);
    checkIds(parameters);
    objects_ = dataset.objects;
    object_count_ = static_cast<std::int64_t>(dataset.objects.size());
    has_splits_ = !dataset.splits.empty();
    splits_ = dataset.splitFolders();
    licenses_ = jsonText(licensesOf(dataset.credits));
  }

  void checkNames(WriterParameters& parameters, const DatasetInfo& dataset) const {
    std::vector<std::string> names;
    for (const ClassInfo& each : dataset.classes) names.push_back(each.name);
    const auto isClass = [&](const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const std::string& name : options_.keypoint_classes) {
      if (isClass(name)) continue;
      parameters.addError("keypoint_classes", "found '" + name + "', and no object has this class" +
                                                  didYouMean(name, names));
    }
    const std::vector<std::string>& of_world = dataset.world_classes;
    if (isClass(options_.background) ||
        std::find(of_world.begin(), of_world.end(), options_.background) != of_world.end()) {
      parameters.addError("background", "found '" + options_.background +
                                            "', which is also a class; the rest of the world "
                                            "should have another name");
    }
  }

  /// Checks that each category has an id of its own.
  void checkIds(WriterParameters& parameters) const {
    std::map<int, std::string> names;
    std::vector<std::string> all;
    const auto add = [&](const std::string& name, int id) {
      all.push_back(name);
      const auto [same, added] = names.emplace(id, name);
      if (added) return;
      parameters.addError("category_ids", "found " + std::to_string(id) + " for '" + name +
                                              "', which is also that of '" + same->second +
                                              "'; each category should have its own");
    };
    for (const ClassInfo& each : classes_) add(each.name, categoryId(each.id));
    for (std::size_t i = 0; i < stuff_.size(); ++i) add(stuff_[i], stuffId(i));
    for (const auto& [name, id] : options_.category_ids) {
      if (std::find(all.begin(), all.end(), name) != all.end()) continue;
      parameters.addError("category_ids",
                          "found '" + name + "', which is no category" + didYouMean(name, all));
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.visibility = true;
    requirements.keypoint_states = keypoints_.any();
    requirements.world_map = has_world_classes_;
    requirements.part_map =
        std::any_of(objects_.begin(), objects_.end(),
                    [](const ObjectInfo& each) { return !each.part_names.empty(); });
    requirements.visible_masks = requirements.visible_masks || requirements.part_map;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    const std::string split = scene.splitFolder();
    const std::string file_name = scene.name + "." + options_.image_format;
    output.addImage("images/" + (has_splits_ ? split + "/" : "") + file_name, scene.image);
    output.addRecord(channelOf(kImages, split), jsonText(imageOf(scene, file_name)));

    std::vector<const SceneObject*> labelled;
    std::string annotations;
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (!object.labelled() || !object.visibleBox() || !box) continue;
      labelled.push_back(&object);
      annotations +=
          (annotations.empty() ? "" : ",\n") + jsonText(annotationOf(scene, object, *box));
    }
    if (!annotations.empty()) output.addRecord(channelOf(kAnnotations, split), annotations);
    if (options_.panoptic) writePanoptic(scene, labelled, output);
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    for (const std::string& split : splits_) {
      writeAnnotationFile(options_.annotation_file + "_" + split, split, kAnnotations,
                          instanceCategories(), records, output);
      if (!options_.panoptic) continue;
      writeAnnotationFile(panopticName(split), split, kPanoptic, panopticCategories(), records,
                          output);
    }
  }

  [[nodiscard]] static std::string panopticName(const std::string& split) {
    return std::string(kCocoPanoptic) + "_" + split;
  }

  // The lists in the files to which a scene's records belong as entries.
  static constexpr const char* kImages = "images";
  static constexpr const char* kAnnotations = "annotations";
  static constexpr const char* kPanoptic = "panoptic";

  [[nodiscard]] static std::string channelOf(const std::string& list, const std::string& split) {
    return list + " " + split;
  }

  [[nodiscard]] static std::int64_t imageId(const Scene& scene) { return scene.index + 1; }

  [[nodiscard]] int categoryId(int class_id) const {
    const auto each =
        std::find_if(classes_.begin(), classes_.end(),
                     [&](const ClassInfo& candidate) { return candidate.id == class_id; });
    return each == classes_.end() ? class_id + 1 : idOf(each->name, class_id + 1);
  }

  [[nodiscard]] int idOf(const std::string& name, int fallback) const {
    const auto given = options_.category_ids.find(name);
    return given == options_.category_ids.end() ? fallback : given->second;
  }

  [[nodiscard]] static Json imageOf(const Scene& scene, const std::string& file_name) {
    return {{"id", imageId(scene)},
            {"file_name", file_name},
            {"width", scene.camera.width()},
            {"height", scene.camera.height()},
            {"synthetic_dataset",
             {{"camera", scene.camera_name},
              {"instant", scene.instant},
              {"stamp_ns", scene.stamp.count()}}}};
  }

  /// Ids are unique in all splits together and do not depend on other scenes, so that parts of a
  /// dataset can be made separately and merged.
  [[nodiscard]] Json annotationOf(const Scene& scene, const SceneObject& object,
                                  const Box& box) const {
    Json annotation = {
        {"id", scene.index * object_count_ + object.instance},
        {"image_id", imageId(scene)},
        {"category_id", categoryId(object.class_id)},
        {"bbox", cocoBox(box)},
        {"area", object.visible_mask().count()},
        {"iscrowd", 0},
        {"segmentation", segmentationOf(object.visible_mask(), options_.as_polygons)}};
    // COCOeval requires keypoints in all annotations or in none.
    if (keypoints_.any()) addKeypoints(object, annotation);
    Json more = {{"object", object.name},
                 {"id", object.id},
                 {"visibility", object.visibility()},
                 {"truncation", object.truncation()}};
    if (object.silhouette_box()) more["amodal_bbox"] = cocoBox(*object.silhouette_box());
    addParts(scene, object, more);
    annotation["synthetic_dataset"] = std::move(more);
    return annotation;
  }

  /// Adds the visible portions of the object's parts, if it has any.
  void addParts(const Scene& scene, const SceneObject& object, Json& more) const {
    const ObjectInfo& info = objects_.at(static_cast<std::size_t>(object.instance) - 1);
    if (info.part_names.empty()) return;
    Json parts = Json::array();
    for (const SeenPart& part : seenParts(scene, object, info)) {
      parts.push_back({{"name", part.name},
                       {"bbox", cocoBox(part.box())},
                       {"area", part.mask.count()},
                       {"segmentation", segmentationOf(part.mask, options_.as_polygons)}});
    }
    more["parts"] = std::move(parts);
  }

  void addKeypoints(const SceneObject& object, Json& annotation) const {
    Json numbers = Json::array();
    int count = 0;
    for (const std::size_t place :
         keypoints_.places(static_cast<std::size_t>(object.instance - 1))) {
      const Keypoint keypoint =
          place == CocoKeypoints::kNone ? Keypoint() : object.keypoints[place];
      const int flag = cocoFlag(keypoint);
      const Eigen::Vector2d pixel = flag > 0 ? *keypoint.pixel : Eigen::Vector2d::Zero();
      numbers.insert(numbers.end(), {pixel.x(), pixel.y(), flag});
      if (flag > 0) ++count;
    }
    annotation["keypoints"] = std::move(numbers);
    annotation["num_keypoints"] = count;
  }

  /// A segment's id encoded as the colour of a panoptic picture: blue, green, red.
  [[nodiscard]] static cv::Vec3b panopticColour(int id) {
    return {static_cast<uchar>(id >> 16), static_cast<uchar>(id >> 8), static_cast<uchar>(id)};
  }

  /// A segment's id in the image is the object's number among all objects, from 1; those of the
  /// world's classes follow.
  void writePanoptic(const Scene& scene, const std::vector<const SceneObject*>& labelled,
                     SceneOutput& output) const {
    std::vector<cv::Vec3b> colours(scene.objects.size() + 1);  // 0: void
    Json segments = Json::array();
    for (const SceneObject* object : labelled) {
      const int id = object->instance;
      colours[static_cast<std::size_t>(id)] = panopticColour(id);
      segments.push_back({{"id", id},
                          {"category_id", categoryId(object->class_id)},
                          {"area", object->visible_mask().count()},
                          {"bbox", cocoBox(*object->visibleBox())},
                          {"iscrowd", 0}});
    }
    cv::Mat_<cv::Vec3b> ids(scene.instance_map().size());
    const cv::Mat_<std::uint16_t> instances = scene.instance_map();
    std::transform(instances.begin(), instances.end(), ids.begin(),
                   [&](std::uint16_t instance) { return colours[instance]; });
    for (std::size_t i = 0; i < stuff_.size(); ++i) {
      const cv::Mat mask = stuffMask(scene, i);
      const cv::Rect bounds = maskBounds(mask);
      if (bounds.empty()) continue;
      const int id = static_cast<int>(scene.objects.size() + i) + 1;
      ids.setTo(panopticColour(id), mask);
      segments.push_back({{"id", id},
                          {"category_id", stuffId(i)},
                          {"area", cv::countNonZero(mask)},
                          {"bbox", {bounds.x, bounds.y, bounds.width, bounds.height}},
                          {"iscrowd", 0}});
    }

    const std::string split = scene.splitFolder();
    const std::string file_name = scene.name + ".png";
    output.addImage("annotations/" + panopticName(split) + "/" + file_name, ids);
    output.addRecord(channelOf(kPanoptic, split), jsonText({{"image_id", imageId(scene)},
                                                            {"file_name", file_name},
                                                            {"segments_info", segments}}));
  }

  /// The visible mask of one of the world's classes or, for the last one, of the rest of the world.
  [[nodiscard]] cv::Mat stuffMask(const Scene& scene, std::size_t stuff) const {
    cv::Mat mask = scene.instance_map() == 0;
    if (!has_world_classes_) return mask;
    const bool is_rest = stuff + 1 == stuff_.size() && !options_.background.empty();
    const double number = is_rest ? 0.0 : static_cast<double>(stuff + 1);
    return mask & (scene.world_map() == number);
  }

  /// The categories of the world's classes come after all others.
  [[nodiscard]] int stuffId(std::size_t stuff) const {
    return idOf(stuff_[stuff], classes_.back().id + 2 + static_cast<int>(stuff));
  }

  [[nodiscard]] Json instanceCategories() const {
    Json categories = Json::array();
    for (const ClassInfo& each : classes_) {
      Json category = {
          {"id", categoryId(each.id)}, {"name", each.name}, {"supercategory", "object"}};
      const ClassKeypoints& keypoints = keypoints_.of(each.id);
      if (!keypoints.names.empty()) {
        category["keypoints"] = keypoints.names;
        category["skeleton"] = Json::array();
        for (const auto& [from, to] : keypoints.skeleton) {
          category["skeleton"].push_back({from + 1, to + 1});
        }
      }
      categories.push_back(std::move(category));
    }
    return categories;
  }

  [[nodiscard]] Json panopticCategories() const {
    const std::vector<cv::Vec3b> colours = vocColourMap();  // the first is black, which means void
    Json categories = Json::array();
    const auto add = [&](int id, const std::string& name, bool is_thing) {
      const cv::Vec3b& colour = colours[1 + categories.size() % (colours.size() - 1)];
      categories.push_back({{"id", id},
                            {"name", name},
                            {"supercategory", is_thing ? "object" : "world"},
                            {"isthing", is_thing ? 1 : 0},
                            {"color", {colour[2], colour[1], colour[0]}}});
    };
    for (const ClassInfo& each : classes_) add(categoryId(each.id), each.name, true);
    for (std::size_t i = 0; i < stuff_.size(); ++i) add(stuffId(i), stuff_[i], false);
    return categories;
  }

  /// The licences of the files from which scenes are made. Images refer to none of them, as each
  /// shows several.
  [[nodiscard]] static Json licensesOf(const std::vector<CreditInfo>& credits) {
    Json licenses = Json::array();
    for (const CreditInfo& credit : credits) {
      licenses.push_back(
          {{"id", licenses.size() + 1},
           {"name", credit.license},
           {"url", ""},
           {"synthetic_dataset", {{"author", credit.author}, {"files", credit.files}}}});
    }
    return licenses;
  }

  void writeAnnotationFile(const std::string& name, const std::string& split,
                           const std::string& annotation_list, const Json& categories,
                           const SceneRecords& records, DatasetOutput& output) const {
    const auto writeList = [&](std::ostream& file, const std::string& list) {
      const char* separator = "\n";
      const std::string channel = channelOf(list, split);
      records.forEach(channel, [&](std::int64_t /*scene*/, const std::string& record) {
        file << separator << record;
        separator = ",\n";
      });
    };
    output.addFile("annotations/" + name + ".json", [&](std::ostream& file) {
      const Json info = {{"description", "Made by synthetic_dataset"}, {"version", "1.0"}};
      file << "{\"info\":" << jsonText(info) << ",\n\"licenses\":" << licenses_
           << ",\n\"images\":[";
      writeList(file, kImages);
      file << "],\n\"annotations\":[";
      writeList(file, annotation_list);
      file << "],\n\"categories\":" << jsonText(categories) << "}\n";
    });
  }

  CocoOptions options_;
  CocoKeypoints keypoints_;
  std::vector<ClassInfo> classes_;
  std::vector<std::string> stuff_;  ///< names of the world's classes and of its rest
  bool has_world_classes_ = false;
  std::vector<ObjectInfo> objects_;
  std::int64_t object_count_ = 0;
  bool has_splits_ = false;
  std::vector<std::string> splits_;
  std::string licenses_;  ///< JSON
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::CocoWriter, synthetic_dataset::LabelWriter)
