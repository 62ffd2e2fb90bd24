#include "verification/expected_labels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>

#include "plugins/readback/json_text.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

using output::ObjectFacts;
using output::SceneFacts;

/// For doubles that go through JSON or the manifest and sums of them [px].
constexpr double kRounding = 1e-6;

/// One writer's view of one scene: what its settings make of the measures.
class MeasuredScene {
 public:
  MeasuredScene(const SceneFacts& facts, const LabelRules& rules) : facts_(facts), rules_(rules) {
    for (const auto& each : rules.run.classes) class_names_[each.id] = each.name;
  }

  [[nodiscard]] std::size_t size() const {
    return std::min(facts_.objects.size(), rules_.run.objects.size());
  }
  [[nodiscard]] const ObjectFacts& facts(std::size_t object) const {
    return facts_.objects[object];
  }
  [[nodiscard]] const std::string& name(std::size_t object) const {
    return rules_.run.objects[object].name;
  }
  [[nodiscard]] int classId(std::size_t object) const {
    return rules_.run.objects[object].class_id;
  }
  [[nodiscard]] std::string className(std::size_t object) const {
    const auto found = class_names_.find(classId(object));
    return found == class_names_.end() ? "" : found->second;
  }

  /// A setting of the run, as its text; empty where the manifest has none.
  [[nodiscard]] std::string runSetting(const std::string& setting) const {
    const auto found = rules_.settings.find(setting);
    return found == rules_.settings.end() ? "" : found->second.text();
  }
  [[nodiscard]] std::string setting(const std::string& setting, const std::string& fallback) const {
    const std::string text = runSetting(rules_.writer.name + "/" + setting);
    return text.empty() ? fallback : text;
  }

  [[nodiscard]] bool flag(const std::string& setting, bool fallback) const {
    const auto found = rules_.settings.find(rules_.writer.name + "/" + setting);
    const bool* flag = found == rules_.settings.end() ? nullptr : found->second.as<bool>();
    return flag == nullptr ? fallback : *flag;
  }

  /// Whether masks are those of identifiers, so that the exact measures count their pixels.
  [[nodiscard]] bool hasExactMasks() const {
    const std::string method = runSetting("masks/method");
    if (!method.empty()) return method == "exact";
    const std::string subtractor = "background_subtractor";
    const auto next = rules_.settings.lower_bound(subtractor);
    return next == rules_.settings.end() ||
           next->first.compare(0, subtractor.size(), subtractor) != 0;
  }

  [[nodiscard]] Box image() const {
    return {-0.5, -0.5, rules_.image.width - 0.5, rules_.image.height - 0.5};
  }

  [[nodiscard]] bool isLabelled(std::size_t object) const {
    return facts(object).visible_pixels.value_or(0) > 0 && !facts(object).dropped;
  }

  /// The box that the setting `box` chooses, cut to the image.
  [[nodiscard]] std::optional<Box> box(std::size_t object) const {
    const std::string choice = setting("box", "visible");
    const std::optional<Box>& box = choice == "loose"        ? facts(object).loose_box
                                    : choice == "silhouette" ? facts(object).silhouette_box
                                                             : facts(object).visible_box;
    return box ? intersection(*box, image()) : std::nullopt;
  }

  [[nodiscard]] Pose X_CO(std::size_t object) const {
    return facts_.X_GC.inverse() * facts(object).X_GO;
  }

  /// Whether the writer has warned that an object has no label in this scene.
  [[nodiscard]] bool isWarnedOf(std::size_t object) const {
    const std::string beginning = "writer '" + rules_.writer.name + "': " + name(object) + ": ";
    return std::any_of(facts_.warnings.begin(), facts_.warnings.end(),
                       [&](const output::Warning& warning) {
                         return warning.kind.compare(0, beginning.size(), beginning) == 0;
                       });
  }

  /// With its class; all else is not known.
  [[nodiscard]] ExpectedLabel label(std::size_t object, const std::string& class_name) const {
    ExpectedLabel label;
    label.object = name(object);
    label.class_name = class_name;
    return label;
  }

  /// Of what the visible mask has in any format.
  void addVisibleMask(std::size_t object, ExpectedLabel& label) const {
    label.mask_bounds = facts(object).visible_box;
    if (!facts(object).mask_agreement && hasExactMasks()) {
      label.mask_pixels = facts(object).visible_pixels;
    }
  }

  /// The silhouette's box where all of it is in the image and it is that of the masks.
  [[nodiscard]] std::optional<Box> wholeSilhouette(std::size_t object) const {
    const auto& box = facts(object).silhouette_box;
    const Box edges = image();
    const bool is_inside = box && box->left >= edges.left && box->top >= edges.top &&
                           box->right <= edges.right && box->bottom <= edges.bottom;
    return is_inside && hasExactMasks() ? box : std::nullopt;
  }

 private:
  const SceneFacts& facts_;
  const LabelRules& rules_;
  std::map<int, std::string> class_names_;
};

/// Words with one space between them.
std::string spaced(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

ExpectedLabels bop(const MeasuredScene& scene) {
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const ObjectFacts& facts = scene.facts(i);
    if (facts.silhouette_pixels.value_or(0) == 0 || facts.truncation.value_or(1.0) >= 1.0) continue;
    ExpectedLabel label = scene.label(i, readback::asJsonHasIt(scene.className(i)));
    const bool is_seen = facts.visible_pixels.value_or(0) > 0;
    if (is_seen && facts.silhouette_box) {
      const Box& box = *facts.silhouette_box;
      const double left = std::round(box.left + 0.5) - 0.5;
      const double top = std::round(box.top + 0.5) - 0.5;
      label.box = Box{left, top, left + std::round(box.width()), top + std::round(box.height())};
    }
    scene.addVisibleMask(i, label);
    label.X_CO = scene.X_CO(i);
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

ExpectedLabels cityscapes(const MeasuredScene& scene) {
  constexpr std::size_t kOfALabel = 1000;  // those after them are a group, without numbers
  ExpectedLabels expected;
  std::map<std::string, std::size_t> counts;  // by label
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (!scene.isLabelled(i)) continue;
    const std::string id =
        scene.setting("label_ids/" + scene.className(i), std::to_string(scene.classId(i) + 1));
    if (counts[id]++ >= kOfALabel || !scene.facts(i).visible_box) continue;
    ExpectedLabel label = scene.label(i, readback::asJsonHasIt(scene.className(i)));
    scene.addVisibleMask(i, label);
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

ExpectedLabels coco(const MeasuredScene& scene) {
  const bool as_polygons = scene.setting("segmentation", "rle") == "polygons";
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const auto box = scene.box(i);
    if (!scene.isLabelled(i) || !scene.facts(i).visible_box || !box) continue;
    ExpectedLabel label = scene.label(i, readback::asJsonHasIt(scene.className(i)));
    label.object_name = readback::asJsonHasIt(scene.name(i));
    label.box = box;
    label.box_tolerance = kRounding;
    scene.addVisibleMask(i, label);
    if (as_polygons) {  // along the pixels' edges, so they enclose as much as the mask has pixels
      label.polygon_bounds = label.mask_bounds;
      if (label.mask_pixels) label.polygon_area = static_cast<double>(*label.mask_pixels);
      label.mask_bounds = std::nullopt;
      label.mask_pixels = std::nullopt;
    }
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

ExpectedLabels dope(const MeasuredScene& scene) {
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (!scene.isLabelled(i)) continue;
    ExpectedLabel label = scene.label(i, readback::asJsonHasIt(scene.className(i)));
    label.object_name = readback::asJsonHasIt(scene.name(i));
    label.box = scene.box(i);
    label.box_tolerance = kRounding;
    label.X_CO = scene.X_CO(i);
    label.may_lack = scene.isWarnedOf(i);
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

ExpectedLabels imageFolder(const MeasuredScene& scene) {
  const bool has_masks = scene.flag("masks", true);
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const auto box = scene.box(i);
    if (!scene.isLabelled(i) || !box) continue;
    ExpectedLabel label = scene.label(i, readback::asJsonHasIt(scene.className(i)));
    label.object_name = readback::asJsonHasIt(scene.name(i));
    label.box = box;
    label.box_tolerance = kRounding;
    if (has_masks) scene.addVisibleMask(i, label);
    label.X_CO = scene.X_CO(i);
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

/// Types end at the first space.
std::string kittiType(std::string class_name) {
  std::replace_if(
      class_name.begin(), class_name.end(),
      [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }, '_');
  return class_name;
}

ExpectedLabels kitti(const MeasuredScene& scene) {
  constexpr double kDecimals = 1e-6;
  const bool has_rest = scene.flag("dont_care", true);
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const std::string name = scene.className(i);
    ExpectedLabel label = scene.label(i, scene.setting("class_names/" + name, kittiType(name)));
    label.box_tolerance = kDecimals;
    if (scene.isLabelled(i)) {
      label.box = scene.box(i);
    } else if (has_rest && scene.facts(i).visible_pixels.value_or(0) > 0) {
      label.class_name = "DontCare";
      label.box = scene.facts(i).visible_box;
    }
    if (label.box) expected.labels.push_back(std::move(label));
  }
  return expected;
}

ExpectedLabels pascalVoc(const MeasuredScene& scene) {
  constexpr std::size_t kMostMasks = 254;  // of a palette; those after them are void
  ExpectedLabels expected;
  expected.has_masks_apart =
      scene.flag("segmentation", true) && scene.setting("void_border", "0") == "0";
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const auto box = scene.box(i);
    if (!scene.isLabelled(i) || !box) continue;
    std::string name = scene.className(i);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    ExpectedLabel label = scene.label(i, name);
    // Whole pixels, the box's edges in them.
    label.box = Box{std::floor(box->left + 0.5) - 0.5, std::floor(box->top + 0.5) - 0.5,
                    std::ceil(box->right + 0.5) - 0.5, std::ceil(box->bottom + 0.5) - 0.5};
    expected.labels.push_back(label);
    if (expected.has_masks_apart && expected.labels.size() <= kMostMasks &&
        scene.facts(i).visible_box) {
      ExpectedLabel mask = scene.label(i, name);
      scene.addVisibleMask(i, mask);
      expected.masks.push_back(std::move(mask));
    }
  }
  return expected;
}

ExpectedLabels pvNet(const MeasuredScene& scene) {
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (!scene.isLabelled(i)) continue;
    ExpectedLabel label = scene.label(i, "");
    label.object_name = safeFileName(scene.name(i));
    scene.addVisibleMask(i, label);
    label.X_CO = scene.X_CO(i);
    label.may_lack = scene.isWarnedOf(i);
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

ExpectedLabels stvNet(const MeasuredScene& scene) {
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const ObjectFacts& facts = scene.facts(i);
    if (!facts.in_view || facts.dropped) continue;
    ExpectedLabel label = scene.label(i, "");
    label.object_name = scene.name(i);
    label.mask_bounds = scene.wholeSilhouette(i);
    if (label.mask_bounds) label.mask_pixels = facts.silhouette_pixels;
    label.may_lack = scene.isWarnedOf(i);
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

ExpectedLabels ultralytics(const MeasuredScene& scene) {
  constexpr double kDecimals = 1e-8;  // of a fraction, half of it lost in each of two numbers
  constexpr double kToEdge = 0.01;    // how far a polygon stays away from its pixels' edges [px]
  const std::string task = scene.setting("task", "");
  const bool is_whole = scene.setting("mask", "visible") == "silhouette";
  const double tolerance = kDecimals * std::max(scene.image().width(), scene.image().height());
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (!scene.isLabelled(i)) continue;
    ExpectedLabel label = scene.label(i, readback::asJsonHasIt(scene.className(i)));
    if (task == "detect" || task == "pose") {
      label.box = scene.box(i);
      label.box_tolerance = tolerance;
      if (!label.box) continue;
    } else if (!is_whole && !scene.facts(i).visible_box) {
      continue;
    }
    label.may_lack = is_whole && !scene.hasExactMasks();  // it may be hidden by the world
    if (task == "segment") {
      const auto bounds = is_whole ? scene.wholeSilhouette(i) : scene.facts(i).visible_box;
      if (bounds) {
        label.polygon_bounds = Box{bounds->left + kToEdge, bounds->top + kToEdge,
                                   bounds->right - kToEdge, bounds->bottom - kToEdge};
      }
      label.polygon_tolerance = tolerance;
    }
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

/// Words of the class: its name or, where the objects' settings have that, its number.
ExpectedLabels yolo(const MeasuredScene& scene) {
  constexpr double kDecimals = 1e-5;  // of a fraction, half of it lost in each of two numbers
  constexpr double kRelativeRounding = 4.0 * std::numeric_limits<double>::epsilon();
  const double width = scene.image().width();
  const double height = scene.image().height();
  const bool is_cut = scene.flag("cut_to_image", true);
  ExpectedLabels expected;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const ObjectFacts& facts = scene.facts(i);
    if (!facts.in_view || facts.dropped || !facts.loose_box) continue;
    const auto in_image = intersection(*facts.loose_box, {0.0, 0.0, width, height});
    if (!in_image) continue;
    const std::string given = scene.runSetting(scene.name(i) + "/class");
    ExpectedLabel label = scene.label(i, spaced(given.empty() ? scene.className(i) : given));
    label.box = is_cut ? *in_image : *facts.loose_box;
    label.box_tolerance = kDecimals * std::max(width, height);
    // Where a box is huge, little is left of an edge in the centre and the size that are written.
    label.box_tolerance +=
        kRelativeRounding * (std::abs(label.box->left) + std::abs(label.box->top) +
                             std::abs(label.box->right) + std::abs(label.box->bottom));
    expected.labels.push_back(std::move(label));
  }
  return expected;
}

struct Format {
  ExpectedLabels (*labels)(const MeasuredScene& scene);
  bool needs_dataset_files;
};

const std::map<std::string, Format>& formats() {
  static const std::map<std::string, Format> kFormats = {
      {"synthetic_dataset/Bop", {bop, true}},
      {"synthetic_dataset/Cityscapes", {cityscapes, true}},
      {"synthetic_dataset/Coco", {coco, true}},
      {"synthetic_dataset/Dope", {dope, false}},
      {"synthetic_dataset/ImageFolder", {imageFolder, true}},
      {"synthetic_dataset/Kitti", {kitti, false}},
      {"synthetic_dataset/PascalVoc", {pascalVoc, false}},
      {"synthetic_dataset/PvNet", {pvNet, true}},
      {"synthetic_dataset/StvNet", {stvNet, false}},
      {"synthetic_dataset/UltralyticsYolo", {ultralytics, true}},
      {"synthetic_dataset/Yolo", {yolo, false}},
  };
  return kFormats;
}

}  // namespace

bool hasLabelRules(const std::string& type) { return formats().count(type) != 0; }

bool needsDatasetFiles(const std::string& type) {
  const auto found = formats().find(type);
  return found != formats().end() && found->second.needs_dataset_files;
}

ExpectedLabels expectedLabels(const SceneFacts& scene, const LabelRules& rules) {
  return formats().at(rules.writer.type).labels(MeasuredScene(scene, rules));
}

}  // namespace synthetic_dataset
