#include "config/readers.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "config/checked_values.h"
#include "config/distribution_config.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

/// Reads `frame` as given, else `frame_id` below the object's name.
std::string readFrame(Parameters& group, const std::string& name) {
  const auto frame = group.maybe<std::string>("frame");
  if (!frame) return name + "/" + group.optional<std::string>("frame_id", "base_link");
  if (group.has("frame_id")) {
    group.addError("frame",
                   "found together with frame_id; give the whole name of the frame, or "
                   "frame_id for a frame called '" +
                       name + "/<frame_id>'");
  } else if (frame->empty()) {
    group.addError("frame", "found an empty text; it should be the name of a TF frame");
  }
  return *frame;
}

void checkPattern(Parameters& group, const std::string& pattern) {
  std::string rest = pattern;
  bool names_link = false;
  for (const std::string placeholder : {"{object}", "{link}"}) {
    for (std::size_t at = rest.find(placeholder); at != std::string::npos;
         at = rest.find(placeholder)) {
      rest.erase(at, placeholder.size());
      names_link = names_link || placeholder == "{link}";
    }
  }
  if (names_link && rest.find_first_of("{}") == std::string::npos) return;
  group.addError("link_frames", "found '" + pattern +
                                    "'; it should hold {link}, may hold {object}, and no other "
                                    "braces: \"{object}/{link}\"");
}

/// Reads a pattern for all links, or a map from a link to its frame.
scene::LinkFrames readLinkFrames(Parameters& group) {
  scene::LinkFrames frames;
  const auto given = group.maybe<Value>("link_frames");
  if (given && given->is<Value::Map>()) {
    Parameters links = group.group("link_frames");
    for (const std::string& link : links.names()) {
      frames.by_link[link] = links.required<std::string>(link);
    }
    if (frames.by_link.empty()) {
      group.addError("link_frames", "found an empty map; it should give links their frames");
    }
  } else if (given) {
    frames.pattern = group.required<std::string>("link_frames");
    if (given->is<std::string>()) checkPattern(group, frames.pattern);
  }
  return frames;
}

/// N in "farthest_points: N", given as a map or, by an easy mistake in YAML, as one text.
std::optional<int> farthestPointsOf(Parameters& group, const Value& keypoints) {
  if (keypoints.is<Value::Map>()) {
    return group.group("keypoints").required<int>("farthest_points");
  }
  const auto* text = keypoints.as<std::string>();
  const std::string start = "farthest_points:";
  if (text == nullptr || text->rfind(start, 0) != 0) return std::nullopt;
  std::istringstream number(text->substr(start.size()));
  int count = 0;
  return number >> count && (number >> std::ws).eof() ? count : 0;
}

void readKeypoints(Parameters& group, scene::ObjectOptions& object) {
  const auto given = group.maybe<Value>("keypoints");
  if (!given) return;
  const auto count = farthestPointsOf(group, *given);
  if (!count) {
    object.keypoints_O = group.required<std::vector<Eigen::Vector3d>>("keypoints");
    return;
  }
  constexpr int kMost = 10000;
  object.farthest_points = *count;
  if (*count >= 1 && *count <= kMost) return;
  object.farthest_points = 1;
  if (!given->is<Value::Map>() || group.group("keypoints").has("farthest_points")) {
    group.addError("keypoints", "found " + given->text() + "; farthest_points should be 1 to " +
                                    std::to_string(kMost));
  }
}

std::size_t keypointCount(const scene::ObjectOptions& object) {
  return object.farthest_points > 0 ? static_cast<std::size_t>(object.farthest_points)
                                    : object.keypoints_O.size();
}

void readKeypointNames(Parameters& group, scene::ObjectOptions& object) {
  const auto names = group.maybe<std::vector<std::string>>("keypoint_names");
  if (!names) return;
  if (names->size() != keypointCount(object)) {
    group.addError("keypoint_names", "found " + std::to_string(names->size()) +
                                         " names; there are " +
                                         std::to_string(keypointCount(object)) + " keypoints");
  } else if (std::set<std::string>(names->begin(), names->end()).size() != names->size()) {
    group.addError("keypoint_names", "found a name more than once; each keypoint has its own");
  } else {
    object.keypoint_names = *names;
  }
  for (const std::string& name : *names) {
    if (const auto problem = nameProblem(name)) {
      group.addError("keypoint_names", "found a name that " + *problem);
    }
  }
}

/// The keypoint at one end of a skeleton's line, given by its index, from 0, or its name.
std::optional<std::size_t> keypointOf(const Value& end, const scene::ObjectOptions& object) {
  const std::vector<std::string>& names = object.keypoint_names;
  const auto named = std::find(names.begin(), names.end(), end.text());
  const bool is_text = end.is<std::string>();
  if (is_text && named != names.end()) return static_cast<std::size_t>(named - names.begin());
  const auto* index = end.as<std::int64_t>();
  const bool fits =
      index != nullptr && *index >= 0 && static_cast<std::size_t>(*index) < keypointCount(object);
  return fits ? std::optional<std::size_t>(static_cast<std::size_t>(*index)) : std::nullopt;
}

/// `skeleton: [[0, 1], [nose, tail]]`.
void readSkeleton(Parameters& group, scene::ObjectOptions& object) {
  const auto given = group.maybe<Value>("skeleton");
  if (!given) return;
  const auto* lines = given->as<Value::List>();
  if (lines == nullptr) {
    group.addError("skeleton", "found " + given->kind() + "; it should be a list of pairs");
    return;
  }
  for (const Value& line : *lines) {
    const auto* ends = line.as<Value::List>();
    const auto first =
        ends != nullptr && ends->size() == 2 ? keypointOf((*ends)[0], object) : std::nullopt;
    const auto second = first ? keypointOf((*ends)[1], object) : std::nullopt;
    if (!second || *first == *second) {
      group.addError("skeleton",
                     "found " + line.text() +
                         "; each entry should be two different keypoints, by their names or by "
                         "their indices from 0");
      return;
    }
    object.skeleton.push_back({*first, *second});
  }
}

std::vector<Eigen::Vector3d> readBoundingShape(Parameters& group) {
  const auto given = group.maybe<Value>("bounding_shape");
  if (!given || given->is<std::string>()) {
    const auto text = group.optional<std::string>("bounding_shape", "model_box");
    if (text != "model_box") {
      group.addError("bounding_shape", "found '" + text +
                                           "'; it should be model_box, or a list of points, each "
                                           "[x, y, z] in metres");
    }
    return {};
  }
  if (isEmptyList(group, "bounding_shape")) {
    group.addError("bounding_shape",
                   "found no points; they should circumscribe the object, or be left out for the "
                   "model's own box");
  }
  return group.required<std::vector<Eigen::Vector3d>>("bounding_shape");
}

bool isXml(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '<';
}

/// Reads the model's arguments; numbers and booleans become texts, as in xacro.
std::map<std::string, std::string> readModelArguments(Parameters& group) {
  std::map<std::string, std::string> arguments;
  const auto given = group.maybe<Value>("model_arguments");
  if (!given) return arguments;
  if (!given->is<Value::Map>()) {
    group.addError("model_arguments", "found " + given->kind() +
                                          "; it should be a map from the arguments of the model's "
                                          "xacro file to their values: {prefix: left_}");
    return arguments;
  }
  Parameters values = group.group("model_arguments");
  for (const std::string& name : values.names()) {
    const Value value = values.required<Value>(name);
    if (value.is<Value::List>() || value.is<Value::Map>()) {
      values.addError(name, "found " + value.kind() + "; it should be a text or a number");
    }
    const bool* flag = value.as<bool>();
    arguments[name] = flag == nullptr ? value.text() : (*flag ? "true" : "false");
  }
  return arguments;
}

/// Only templates (see world/files/template_file.h) take arguments; with any other model they would
/// have no effect.
void checkModelArguments(Parameters& group, const scene::ObjectOptions& object) {
  if (object.model_arguments.empty() || !object.model) return;
  const std::string ending = std::filesystem::path(*object.model).extension();
  if (ending == ".xacro" || ending == ".jinja" || ending == ".j2") return;
  group.addError("model_arguments",
                 "found together with a model that is not a xacro file; only names that end in "
                 ".xacro, or .jinja, "
                 "take arguments");
}

scene::WhenUnknown readWhenUnknown(Parameters& group, scene::WhenUnknown fallback) {
  if (!group.has("when_unknown")) return fallback;
  return choice<scene::WhenUnknown>(
      group, "when_unknown",
      {{"skip_scene", scene::WhenUnknown::kSkipScene}, {"absent", scene::WhenUnknown::kAbsent}});
}

scene::ObjectOptions readObject(Parameters& root, const std::string& name,
                                scene::WhenUnknown when_unknown) {
  Parameters group = root.group(name);
  scene::ObjectOptions object;
  object.name = name;
  object.class_text = readLabel(group, "class");
  object.class_name = object.class_text;
  object.id = readLabel(group, "id");
  // Where several are allowed, they are separate objects by now (config/object_count.h).
  constexpr int kMostCopies = 1000;
  const int count = group.optionalBetween("count", 1, 1, kMostCopies);
  if (count > 1) {
    group.addError("count", "found " + std::to_string(count) +
                                "; it has a meaning with motion: placement alone: in a recording "
                                "each object has a frame of its own");
  }
  if (!readStanding(group, object)) {
    object.frame = readFrame(group, name);
    object.frame_is_given = group.has("frame");
    object.link_frames = readLinkFrames(group);
  }
  object.when_unknown = readWhenUnknown(group, when_unknown);
  object.model = group.maybe<std::string>("model");
  if (object.model && object.model->rfind("param:", 0) == 0) {
    group.addError("model", "found '" + *object.model +
                                "', but no ROS parameter of this name is set to a text; it should "
                                "hold a URDF or SDF model, as /robot_description does (without a "
                                "ROS master, name a file)");
    object.model.reset();
  }
  if (object.model && !isXml(*object.model)) object.model = pathOrUri(*object.model);
  object.model_arguments = readModelArguments(group);
  checkModelArguments(group, object);
  readKeypoints(group, object);
  readKeypointNames(group, object);
  readSkeleton(group, object);
  object.bounding_shape_O = readBoundingShape(group);
  object.safety_radius = group.maybeBetween("safety_radius", 0.0, kFarthest);
  Parameters parts = group.group("parts");
  for (const std::string& part : parts.names()) {
    object.parts[part] = readNames(parts, part, "links of its model");
  }
  return object;
}

/// A labelled distractor; its shape is that of its model.
scene::ObjectOptions labelledDistractor(int number, const std::string& label_class) {
  scene::ObjectOptions object;
  object.name = object.id = randomize::distractorName(number);
  object.class_text = object.class_name = label_class;
  object.frame = "distractors/" + object.name;
  object.takes_part = false;
  object.is_distractor = true;
  return object;
}

}  // namespace

bool isSettingGroup(const std::string& name) {
  static const std::set<std::string> kSettings = {"background_subtractor",
                                                  "camera",
                                                  "cameras",
                                                  "classes",
                                                  "image",
                                                  "labels",
                                                  "lidars",
                                                  "masks",
                                                  "motions",
                                                  "physics",
                                                  "placement",
                                                  "randomize",
                                                  "rendering",
                                                  "shard",
                                                  "split",
                                                  "twin",
                                                  "world",
                                                  "world_classes",
                                                  "world_objects",
                                                  "writers"};
  return kSettings.count(name) != 0;
}

std::string readLabel(Parameters group, const std::string& name) {
  const Value value = group.required<Value>(name);
  std::string text = value.text();
  if (value.is<Value::List>() || value.is<Value::Map>()) {
    group.addError(name, "found " + value.kind() + "; it should be a text or a number");
  } else if (const auto problem = nameProblem(text)) {
    group.addError(name, "found a text that " + *problem);
  }
  return text;
}

void addLabelledDistractors(Parameters root,
                            const std::optional<randomize::DistractorOptions>& distractors,
                            std::vector<scene::ObjectOptions>& objects) {
  if (!distractors || !distractors->label_class) return;
  std::set<std::string> taken;
  for (const scene::ObjectOptions& object : objects) taken.insert({object.name, object.id});
  for (int number = 1; number <= distractors->pool; ++number) {
    objects.push_back(labelledDistractor(number, *distractors->label_class));
    if (taken.count(objects.back().name) == 0) continue;
    root.addError("robot_list", "found an object with the name or id '" + objects.back().name +
                                    "', which is that of a labelled distractor");
  }
}

std::vector<scene::ObjectOptions> readObjects(Parameters root) {
  checkWorldObjects(root);
  const bool may_lack = root.has("world_objects") && !root.has("robot_list");
  const auto names =
      may_lack ? std::vector<std::string>() : root.required<std::vector<std::string>>("robot_list");
  if (isEmptyList(root, "robot_list")) {
    root.addError("robot_list", "found an empty list; it should name at least one object");
  }
  const scene::WhenUnknown when_unknown = readWhenUnknown(root, scene::WhenUnknown::kSkipScene);
  std::vector<scene::ObjectOptions> objects;
  std::set<std::string> seen;
  std::map<std::string, std::string> ids;
  for (std::string name : names) {
    if (!name.empty() && name.front() == '/') name.erase(0, 1);
    if (isSettingGroup(name)) {
      root.addError("robot_list", "found '" + name +
                                      "', which is also a setting; the object should have another "
                                      "name");
      continue;
    }
    if (const auto problem = nameProblem(name)) {
      root.addError("robot_list", "found a name that " + *problem);
      continue;
    }
    if (!seen.insert(name).second) {
      root.addError("robot_list", "found '" + name + "' more than once");
      continue;
    }
    if (!root.has(name)) {
      root.addError("robot_list",
                    "found '" + name + "', which has no group" + didYouMean(name, root.names()));
      continue;
    }
    objects.push_back(readObject(root, name, when_unknown));
    const scene::ObjectOptions& object = objects.back();
    const auto [same, added] = ids.emplace(object.id, name);
    if (!added && root.group(name).has("id")) {
      root.addError(name + "/id", "found " + object.id + ", which is also the id of '" +
                                      same->second + "'; each object should have its own");
    }
  }
  return objects;
}

}  // namespace synthetic_dataset::config
