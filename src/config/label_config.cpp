#include "config/readers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "config/checked_values.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

constexpr int kLargestClass = 65534;  // its index + 1 fits into 16 bits of a class map

/// The whole number that a text represents in its usual form: not "007".
std::optional<int> wholeNumber(const std::string& text) {
  int number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = fault == std::errc() && end == text.data() + text.size();
  if (!is_whole || number < 0 || number > kLargestClass) return std::nullopt;
  return std::to_string(number) == text ? std::optional<int>(number) : std::nullopt;
}

/// Registers classes, each number and each name once.
class ClassTable {
 public:
  explicit ClassTable(Parameters& root) : root_(root) {}

  void add(int id, const std::string& name) {
    if (id < 0 || id > kLargestClass) {
      root_.addError("classes", "found the number " + std::to_string(id) + " of '" + name +
                                    "'; it should be 0 to " + std::to_string(kLargestClass));
    } else if (const auto problem = nameProblem(name)) {
      root_.addError("classes", "found a name that " + *problem);
    } else if (const bool is_new_name = names_.insert(name).second;
               !by_id_.emplace(id, name).second || !is_new_name) {
      root_.addError("classes", "found '" + name + "' or its number " + std::to_string(id) +
                                    " more than once");
    }
  }

  /// The class that a text means: its name or its number.
  [[nodiscard]] std::optional<int> find(const std::string& text) const {
    for (const auto& [id, name] : by_id_) {
      if (name == text) return id;
    }
    const auto number = wholeNumber(text);
    return number && by_id_.count(*number) != 0 ? number : std::nullopt;
  }

  /// Whether a name was given and accepted, even with a number that is already taken.
  [[nodiscard]] bool knows(const std::string& name) const { return names_.count(name) != 0; }

  [[nodiscard]] const std::string& name(int id) const { return by_id_.at(id); }

  [[nodiscard]] std::vector<ClassConfig> classes() const {
    std::vector<ClassConfig> all;
    for (const auto& [id, name] : by_id_) all.push_back({id, name});
    return all;
  }

  [[nodiscard]] std::vector<std::string> names() const { return {names_.begin(), names_.end()}; }

 private:
  Parameters& root_;
  std::map<int, std::string> by_id_;
  std::set<std::string> names_;
};

/// Reads the parameter `classes`: a list of names, numbered from 0, or a map from name to number.
void readTable(Parameters& root, const Value& given, ClassTable& table) {
  if (given.is<Value::Map>()) {
    Parameters group = root.group("classes");
    for (const std::string& name : group.names()) table.add(group.required<int>(name), name);
    return;
  }
  int id = 0;
  for (const std::string& name : root.required<std::vector<std::string>>("classes")) {
    table.add(id++, name);
  }
}

/// Collects and numbers the objects' classes.
void numberClasses(const std::vector<scene::ObjectOptions>& objects, ClassTable& table) {
  std::set<std::string> names;
  std::set<int> taken;
  for (const scene::ObjectOptions& object : objects) {
    const auto number = wholeNumber(object.class_text);
    if (number && taken.insert(*number).second) table.add(*number, object.class_text);
    if (!number && !object.class_text.empty()) names.insert(object.class_text);
  }
  int next = 0;
  for (const std::string& name : names) {
    while (taken.count(next) != 0) ++next;
    table.add(next++, name);
  }
}

}  // namespace

label::MaskOptions readMasks(Parameters root) {
  label::MaskOptions masks;
  Parameters subtractor = root.group("background_subtractor");
  masks.mog2.history_length =
      subtractor.optionalBetween("history_length", masks.mog2.history_length, 1, 10000);
  masks.mog2.var_threshold =
      numberAbove(subtractor, "var_threshold", masks.mog2.var_threshold, 0.0);
  masks.mog2.detect_shadows = subtractor.optional("detect_shadows", masks.mog2.detect_shadows);
  Parameters group = root.group("masks");
  masks.clean = group.optional("clean", masks.clean);
  masks.method_is_given = group.has("method");
  masks.method = maybeChoice<label::MaskMethod>(
                     group, "method",
                     {{"exact", label::MaskMethod::kExact}, {"mog2", label::MaskMethod::kMog2}})
                     .value_or(root.has("background_subtractor") ? label::MaskMethod::kMog2
                                                                 : label::MaskMethod::kExact);
  return masks;
}

label::LabelOptions readLabels(Parameters root) {
  label::LabelOptions labels;
  Parameters group = root.group("labels");
  constexpr std::int64_t kMostPixels = 1000000000;
  labels.min_visibility = group.maybeBetween("min_visibility", 0.0, 1.0).value_or(0.0);
  labels.min_pixels = group.maybeBetween<std::int64_t>("min_pixels", 0, kMostPixels).value_or(0);
  labels.follows_rows =
      maybeChoice<bool>(group, "rolling_shutter", {{"picture", true}, {"mid_exposure", false}})
          .value_or(true);
  constexpr double kLargestTolerance = 1.0;  // [m]; anything larger was meant in another unit
  if (group.has("keypoint_tolerance")) {
    labels.keypoint_tolerance = group.optionalBetween(
        "keypoint_tolerance", labels.keypoint_tolerance, 1e-6, kLargestTolerance);
  }
  return labels;
}

SplitConfig readSplit(Parameters root) {
  SplitConfig split;
  if (!root.has("split")) return split;
  Parameters group = root.group("split");
  double sum = 0.0;
  const std::size_t errors_before = group.errors().size();
  for (const char* name : {"train", "val", "test"}) {
    const double share = group.maybeBetween(name, 0.0, 1.0).value_or(0.0);
    if (share > 0.0) split.shares.emplace_back(name, share);
    sum += share;
  }
  if (group.errors().size() > errors_before) {
    split.shares.clear();
  } else if (std::abs(sum - 1.0) > 1e-6) {
    constexpr double kShown = 1e6;  // 0.9, not 0.8999999999999999
    root.addError("split", "found shares that add up to " +
                               Value(std::round(sum * kShown) / kShown).text() +
                               "; train, val and test should add up to 1");
    split.shares.clear();
  }
  split.by = choice<SplitBy>(group, "by",
                             {{"blocks", SplitBy::kBlocks},
                              {"balanced_blocks", SplitBy::kBalancedBlocks},
                              {"scenes", SplitBy::kScenes}});
  split.gap = maybeSeconds(group, "gap").value_or(0.0);
  if (split.gap > 0.0 && split.by == SplitBy::kScenes) {
    group.addError("gap", "found " + Value(split.gap).text() +
                              " with `by: scenes`; only blocks have gaps between them");
  }
  return split;
}

std::vector<ClassConfig> readClasses(Parameters root, std::vector<scene::ObjectOptions>& objects) {
  ClassTable table(root);
  const auto given = root.maybe<Value>("classes");
  if (given) {
    readTable(root, *given, table);
  } else {
    numberClasses(objects, table);
  }
  for (scene::ObjectOptions& object : objects) {
    const auto id = table.find(object.class_text);
    if (id) {
      object.class_id = *id;
      object.class_name = table.name(*id);
    } else if (given && !object.class_text.empty() && !table.knows(object.class_text)) {
      root.addError(object.name + "/class", "found '" + object.class_text +
                                                "', which is not among the classes" +
                                                didYouMean(object.class_text, table.names()));
    }
  }
  return table.classes();
}

scene::WorldClasses readWorldClasses(Parameters root, const std::vector<ClassConfig>& classes) {
  scene::WorldClasses result;
  Parameters group = root.group("world_classes");
  for (const std::string& name : group.names()) {
    const bool is_taken = std::any_of(classes.begin(), classes.end(),
                                      [&](const ClassConfig& each) { return each.name == name; });
    if (is_taken) {
      group.addError(name, "found a name that is also a class of objects; it should be another");
    } else if (const auto problem = nameProblem(name)) {
      group.addError(name, "found a name that " + *problem);
    }
    result[name] = readNames(group, name, "models of the world, or gz-sim's label numbers");
  }
  return result;
}

}  // namespace synthetic_dataset::config
