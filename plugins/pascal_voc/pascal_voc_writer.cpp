#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/pascal_voc/pascal_voc_options.h"
#include "plugins/pascal_voc/pascal_voc_pictures.h"
#include "plugins/shared/plain_file_name.h"
#include "plugins/shared/seen_parts.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

/// Escapes a text for an XML element. https://www.w3.org/TR/xml/#syntax, #charsets
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

std::string element(const std::string& name, int number) {
  return element(name, std::to_string(number));
}

}  // namespace

/// Pascal VOC: `JPEGImages/N.jpg`, `Annotations/N.xml`, pictures of classes and objects in
/// `SegmentationClass` and `SegmentationObject`, lists of images in `ImageSets`, `labelmap.txt`.
/// http://host.robots.ox.ac.uk/pascal/VOC/voc2012/htmldoc/devkit_doc.html
class PascalVocWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    options_ = readPascalVocOptions(parameters);
    const std::size_t class_count = dataset.classes.size() + dataset.world_classes.size();
    if (options_.segmentation && class_count > kMostVocIndices) {
      parameters.addError("segmentation", "found true; it should be false: there are " +
                                              std::to_string(class_count) +
                                              " classes, and a picture of them can tell 254 apart");
    }
    classes_ = dataset.classes;
    objects_ = dataset.objects;
    has_parts_ = std::any_of(objects_.begin(), objects_.end(),
                             [](const ObjectInfo& each) { return !each.part_names.empty(); });
    if (options_.segmentation) world_classes_ = dataset.world_classes;
    splits_ = dataset.splitFolders();
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.visibility = true;
    requirements.world_map = !world_classes_.empty();
    requirements.part_map = has_parts_;
    requirements.visible_masks = requirements.visible_masks || has_parts_;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    const std::string name = scene.flatName();
    const std::string image = name + "." + options_.image_format;
    std::vector<const SceneObject*> objects;  // labelled, in the order of their numbers
    std::string elements;
    std::map<int, bool> is_plain;  // visible classes: whether any object is not difficult
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (!object.labelled() || !box) continue;
      objects.push_back(&object);
      elements += objectElement(object, *box, partElements(scene, object));
      bool& plain = is_plain[object.class_id];
      plain = plain || !isDifficult(object);
    }
    output.addImage("JPEGImages/" + image, scene.image);
    output.addText("Annotations/" + name + ".xml", annotation(scene, image, elements));
    if (options_.segmentation) addPictures(scene, objects, output);

    std::string record = scene.splitFolder() + " " + name;
    for (const auto& [id, plain] : is_plain) {
      record += " " + std::to_string(id) + (plain ? " 1" : " 0");
    }
    output.addRecord(kImages, record);
  }

  [[nodiscard]] std::string annotation(const Scene& scene, const std::string& image,
                                       const std::string& objects) const {
    return "<annotation>\n\t" + element("folder", "JPEGImages") + "\n\t" +
           element("filename", escaped(vocName(image))) + "\n\t<source>\n\t\t" +
           element("database", "synthetic_dataset") + "\n\t\t" +
           element("annotation",
                   "pixels are counted from " + std::to_string(options_.first_pixel)) +
           "\n\t\t" + element("image", "synthetic_dataset") + "\n\t</source>\n\t<size>\n\t\t" +
           element("width", scene.camera.width()) + "\n\t\t" +
           element("height", scene.camera.height()) + "\n\t\t" + element("depth", 3) +
           "\n\t</size>\n\t" + element("segmented", options_.segmentation ? 1 : 0) + "\n" +
           objects + "</annotation>\n";
  }

  /// The boxes of an object's parts, as in person layout annotations.
  [[nodiscard]] std::string partElements(const Scene& scene, const SceneObject& object) const {
    if (!has_parts_) return "";
    std::string elements;
    const ObjectInfo& info = objects_.at(static_cast<std::size_t>(object.instance) - 1);
    for (const SeenPart& part : seenParts(scene, object, info)) {
      elements += "\t\t<part>\n\t\t\t" + element("name", escaped(vocName(part.name))) + "\n" +
                  boxElement(part.box(), "\t\t\t") + "\t\t</part>\n";
    }
    return elements;
  }

  /// @param indent  of its lines
  [[nodiscard]] std::string boxElement(const Box& box, const std::string& indent) const {
    // The first pixel's left edge is at -0.5, and the last pixel's right edge ends the box.
    const auto first = [&](double edge) {
      return static_cast<int>(std::floor(edge + 0.5)) + options_.first_pixel;
    };
    const auto last = [&](double edge) {
      return static_cast<int>(std::ceil(edge + 0.5)) - 1 + options_.first_pixel;
    };
    const std::string inner = "\n" + indent + "\t";
    return indent + "<bndbox>" + inner + element("xmin", first(box.left)) + inner +
           element("ymin", first(box.top)) + inner + element("xmax", last(box.right)) + inner +
           element("ymax", last(box.bottom)) + "\n" + indent + "</bndbox>\n";
  }

  /// @param parts  XML elements of its parts
  [[nodiscard]] std::string objectElement(const SceneObject& object, const Box& box,
                                          const std::string& parts) const {
    const bool is_truncated = object.truncation() > options_.truncated_above;
    // Computed without a division: the share of the silhouette in the image that something else
    // hides.
    const auto in_image = static_cast<double>(object.pixels.silhouette_in_image());
    const double hidden = in_image - static_cast<double>(object.pixels.visible());
    const bool is_occluded = hidden > options_.occluded_above * in_image;
    return "\t<object>\n\t\t" + element("name", escaped(vocName(object.class_name))) + "\n\t\t" +
           element("pose", "Unspecified") + "\n\t\t" + element("truncated", is_truncated ? 1 : 0) +
           "\n\t\t" + element("occluded", is_occluded ? 1 : 0) + "\n\t\t" +
           element("difficult", isDifficult(object) ? 1 : 0) + "\n" + boxElement(box, "\t\t") +
           parts + "\t</object>\n";
  }

  [[nodiscard]] bool isDifficult(const SceneObject& object) const {
    return object.visibility() < options_.difficult_below;
  }

  void addPictures(const Scene& scene, const std::vector<const SceneObject*>& objects,
                   SceneOutput& output) const {
    if (objects.size() > kMostVocIndices) {
      output.addWarning(
          "SegmentationObject can tell 254 objects of an image apart: the rest are void");
    }
    const VocPictures pictures =
        vocPictures(scene, objects, classes_, world_classes_.size(), options_.void_border);
    const std::string end = "/" + scene.flatName() + ".png";
    output.addIndexedImage("SegmentationClass" + end, pictures.classes, vocColourMap());
    output.addIndexedImage("SegmentationObject" + end, pictures.objects, vocColourMap());
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    if (options_.segmentation) {
      std::vector<VocClass> classes;
      for (const ClassInfo& each : classes_) classes.push_back({each.name, partsOf(each)});
      for (const std::string& each : world_classes_) classes.push_back({each, {}});
      output.addFile("labelmap.txt", [&](std::ostream& file) { writeLabelMap(file, classes); });
    }
    std::map<std::string, std::set<std::string>> lists;  // by list name: its splits
    for (const std::string& split : splits_) {
      lists[split].insert(split);
      if (split == "train" || split == "val") lists["trainval"].insert(split);
    }
    for (const auto& [list, splits] : lists) addLists(records, list, splits, output);
  }

  /// The names of the parts of a class's objects, as in annotations.
  [[nodiscard]] std::set<std::string> partsOf(const ClassInfo& each) const {
    std::set<std::string> parts;
    for (const ObjectInfo& object : objects_) {
      if (object.class_id != each.id) continue;
      for (const std::string& part : object.part_names) parts.insert(vocName(part));
    }
    return parts;
  }

  /// `Main/<list>.txt` and `Segmentation/<list>.txt` with one image name per line, and
  /// `Main/<class>_<list>.txt`, which say for each image whether it shows the class: 1, -1, or 0 if
  /// all such objects are difficult.
  void addLists(const SceneRecords& records, const std::string& list,
                const std::set<std::string>& splits, DatasetOutput& output) const {
    using Visit = std::function<void(const std::string& name, std::istream& classes)>;
    const auto forEachImage = [&](const Visit& visit) {
      records.forEach(kImages, [&](std::int64_t /*scene*/, const std::string& record) {
        std::istringstream words(record);
        std::string split;
        std::string name;
        words >> split >> name;
        if (splits.count(split) > 0) visit(name, words);
      });
    };
    const auto writeNames = [&](std::ostream& file) {
      forEachImage(
          [&](const std::string& name, std::istream& /*classes*/) { file << name << '\n'; });
    };
    output.addFile("ImageSets/Main/" + list + ".txt", writeNames);
    if (options_.segmentation)
      output.addFile("ImageSets/Segmentation/" + list + ".txt", writeNames);
    for (const ClassInfo& each : classes_) {
      const std::string file_name = plainFileName(each.name) + "_" + list + ".txt";
      output.addFile("ImageSets/Main/" + file_name, [&](std::ostream& file) {
        forEachImage([&](const std::string& name, std::istream& classes) {
          std::string sign = "-1";
          int id = 0;
          for (int plain = 0; classes >> id >> plain;) {
            if (id == each.id) sign = plain != 0 ? " 1" : " 0";
          }
          file << name << ' ' << sign << '\n';
        });
      });
    }
  }

  static constexpr const char* kImages = "images";  // channel of records

  PascalVocOptions options_;
  std::vector<ClassInfo> classes_;
  std::vector<std::string> world_classes_;  ///< shown in the pictures
  std::vector<ObjectInfo> objects_;
  bool has_parts_ = false;
  std::vector<std::string> splits_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::PascalVocWriter, synthetic_dataset::LabelWriter)
