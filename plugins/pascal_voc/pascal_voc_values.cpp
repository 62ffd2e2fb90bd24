#include "plugins/pascal_voc/pascal_voc_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/pascal_voc/pascal_voc_options.h"
#include "plugins/pascal_voc/pascal_voc_pictures.h"
#include "plugins/readback/true_parts.h"
#include "plugins/shared/colour_map.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::pascal_voc {
namespace {

constexpr int kVoid = 255;

std::string inXml(const std::string& text) {
  const std::map<char, std::string> references = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}};
  std::string result;
  for (const char c : vocName(text)) {
    const auto reference = references.find(c);
    result += reference == references.end() ? std::string(1, c) : reference->second;
  }
  return result;
}

std::string line(int depth, const std::string& name, const std::string& content) {
  return std::string(static_cast<std::size_t>(depth), '\t') + "<" + name + ">" + content + "</" +
         name + ">\n";
}

std::string line(int depth, const std::string& name, int number) {
  return line(depth, name, std::to_string(number));
}

class PascalVocValues : public ValueCheck {
 public:
  PascalVocValues(PascalVocOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), dataset_(dataset) {
    for (const std::string& split : dataset_.splitFolders()) {
      addLists(split);
      if (split == "train" || split == "val") addLists("trainval");
    }
  }

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string name = scene.flatName();
    const std::string image = name + "." + options_.image_format;
    std::vector<const SceneObject*> labelled;
    std::string objects;
    std::map<int, std::string> signs;  // by class: 1, or 0 where all of it is difficult
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (!object.labelled() || !box) continue;
      labelled.push_back(&object);
      objects += elementOf(scene, object, *box);
      std::string& sign = signs.try_emplace(object.class_id, " 0").first->second;
      if (object.visibility() >= options_.difficult_below) sign = " 1";
    }
    files.compareWithScene("JPEGImages/" + image, truth);
    files.compareText("Annotations/" + name + ".xml", annotationOf(scene, image, objects));
    if (options_.segmentation) comparePictures(scene, labelled, files);
    addToLists(scene.splitFolder(), name, signs);
  }

  void checkDataset(FoundFiles& files) override {
    for (const auto& [name, lines] : lists_) files.compareText(name, lines);
    if (options_.segmentation) files.compareText("labelmap.txt", labelMap());
  }

 private:
  void addLists(const std::string& list) {
    lists_["ImageSets/Main/" + list + ".txt"];
    if (options_.segmentation) lists_["ImageSets/Segmentation/" + list + ".txt"];
    for (const ClassInfo& each : dataset_.classes) lists_[listOf(each, list)];
  }

  static std::string listOf(const ClassInfo& of_class, const std::string& list) {
    return "ImageSets/Main/" + safeFileName(of_class.name) + "_" + list + ".txt";
  }

  void addToLists(const std::string& split, const std::string& name,
                  const std::map<int, std::string>& signs) {
    std::vector<std::string> of_scene = {split};
    if (split == "train" || split == "val") of_scene.emplace_back("trainval");
    for (const std::string& list : of_scene) {
      lists_["ImageSets/Main/" + list + ".txt"] += name + "\n";
      if (options_.segmentation) lists_["ImageSets/Segmentation/" + list + ".txt"] += name + "\n";
      for (const ClassInfo& each : dataset_.classes) {
        const auto sign = signs.find(each.id);
        lists_[listOf(each, list)] +=
            name + " " + (sign == signs.end() ? "-1" : sign->second) + "\n";
      }
    }
  }

  [[nodiscard]] std::string annotationOf(const Scene& scene, const std::string& image,
                                         const std::string& objects) const {
    return "<annotation>\n" + line(1, "folder", "JPEGImages") + line(1, "filename", inXml(image)) +
           "\t<source>\n" + line(2, "database", "synthetic_dataset") +
           line(2, "annotation",
                "pixels are counted from " + std::to_string(options_.first_pixel)) +
           line(2, "image", "synthetic_dataset") + "\t</source>\n\t<size>\n" +
           line(2, "width", scene.camera.width()) + line(2, "height", scene.camera.height()) +
           line(2, "depth", 3) + "\t</size>\n" +
           line(1, "segmented", options_.segmentation ? 1 : 0) + objects + "</annotation>\n";
  }

  [[nodiscard]] std::string elementOf(const Scene& scene, const SceneObject& object,
                                      const Box& box) const {
    const auto in_image = static_cast<double>(object.pixels.silhouette_in_image());
    const double hidden = in_image - static_cast<double>(object.pixels.visible());
    // The first and the last pixel that the box has a part of.
    return "\t<object>\n" + line(2, "name", inXml(object.class_name)) +
           line(2, "pose", "Unspecified") +
           line(2, "truncated", object.truncation() > options_.truncated_above ? 1 : 0) +
           line(2, "occluded", hidden > options_.occluded_above * in_image ? 1 : 0) +
           line(2, "difficult", object.visibility() < options_.difficult_below ? 1 : 0) +
           elementOfBox(box, 2) + partsOf(scene, object) + "\t</object>\n";
  }

  [[nodiscard]] std::string partsOf(const Scene& scene, const SceneObject& object) const {
    std::string elements;
    if (dataset_.objects.at(static_cast<std::size_t>(object.instance - 1)).part_names.empty()) {
      return elements;
    }
    for (const TruePart& each : trueParts(scene, object, dataset_)) {
      elements += "\t\t<part>\n" + line(3, "name", inXml(each.name)) + elementOfBox(each.box(), 3) +
                  "\t\t</part>\n";
    }
    return elements;
  }

  /// Whole pixels, the last ones included.
  [[nodiscard]] std::string elementOfBox(const Box& box, int depth) const {
    const auto first = [&](double edge) {
      return options_.first_pixel + static_cast<int>(std::floor(edge + 0.5));
    };
    const auto last = [&](double edge) {
      return options_.first_pixel + static_cast<int>(std::ceil(edge - 0.5));
    };
    const std::string tabs(static_cast<std::size_t>(depth), '\t');
    return tabs + "<bndbox>\n" + line(depth + 1, "xmin", first(box.left)) +
           line(depth + 1, "ymin", first(box.top)) + line(depth + 1, "xmax", last(box.right)) +
           line(depth + 1, "ymax", last(box.bottom)) + tabs + "</bndbox>\n";
  }

  void comparePictures(const Scene& scene, const std::vector<const SceneObject*>& labelled,
                       FoundFiles& files) const {
    const std::vector<cv::Vec3b> colours = vocColourMap();
    cv::Mat classes(scene.camera.height(), scene.camera.width(), CV_8UC1, cv::Scalar(0));
    cv::Mat objects = classes.clone();
    for (const SceneObject& object : scene.objects) {
      const cv::Mat mask = object.visible_mask().whole();
      classes.setTo(kVoid, mask);  // until it is found to have a label
      objects.setTo(kVoid, mask);
    }
    for (std::size_t i = 0; i < dataset_.world_classes.size(); ++i) {
      const std::size_t index = dataset_.classes.size() + i + 1;
      classes.setTo(static_cast<double>(index), trueWorldClass(scene, i + 1));
    }
    for (std::size_t i = 0; i < labelled.size(); ++i) {
      const cv::Mat mask = labelled[i]->visible_mask().whole();
      classes.setTo(static_cast<double>(dataset_.classIndex(labelled[i]->class_id) + 1), mask);
      if (i < kMostVocIndices) objects.setTo(static_cast<double>(i + 1), mask);
    }
    if (options_.void_border > 0) {
      const cv::Mat border = bordersOf(scene.instance_map(), options_.void_border);
      classes.setTo(kVoid, border);
      objects.setTo(kVoid, border);
    }
    const std::string end = "/" + scene.flatName() + ".png";
    files.comparePicture("SegmentationClass" + end, painted(classes, colours));
    files.comparePicture("SegmentationObject" + end, painted(objects, colours));
  }

  /// Pixels from which another instance is no farther than this along rows and columns.
  static cv::Mat bordersOf(const cv::Mat& instances, int width) {
    const cv::Mat around = cv::Mat::ones(2 * width + 1, 2 * width + 1, CV_8UC1);
    cv::Mat greatest;
    cv::Mat least;
    cv::dilate(instances, greatest, around);
    cv::erode(instances, least, around);
    return greatest != least;
  }

  static cv::Mat painted(const cv::Mat_<uchar>& indices, const std::vector<cv::Vec3b>& colours) {
    cv::Mat_<cv::Vec3b> picture(indices.size());
    std::transform(indices.begin(), indices.end(), picture.begin(),
                   [&](uchar index) { return colours[index]; });
    return picture;
  }

  [[nodiscard]] std::string labelMap() const {
    const std::vector<cv::Vec3b> colours = vocColourMap();
    std::string text = "# label:color_rgb:parts:actions\nbackground:0,0,0::\n";
    std::vector<std::string> names;
    for (const ClassInfo& each : dataset_.classes) names.push_back(each.name);
    names.insert(names.end(), dataset_.world_classes.begin(), dataset_.world_classes.end());
    for (std::size_t i = 0; i < names.size(); ++i) {
      std::string name = names[i];
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == ':' || c == '\n' || c == '\r'; }, '_');
      if (!name.empty() && name.front() == '#') name.front() = '_';
      const cv::Vec3b& colour = colours.at(i + 1);
      text += name + ":" + std::to_string(colour[2]) + "," + std::to_string(colour[1]) + "," +
              std::to_string(colour[0]) + "::\n";
    }
    return text;
  }

  PascalVocOptions options_;
  DatasetInfo dataset_;
  std::map<std::string, std::string> lists_;  ///< by file
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<PascalVocValues>(readPascalVocOptions(parameters), dataset);
}

}  // namespace synthetic_dataset::formats::pascal_voc
