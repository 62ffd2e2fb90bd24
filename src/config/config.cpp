#include "config/config.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

/// A number that has to lie in a range; the message says which.
double numberAbove(const Parameters& group, const std::string& name, double fallback,
                   double limit) {
  const double number = group.optional(name, fallback);
  if (number > limit) return number;
  group.addError(name,
                 "found " + Value(number).text() + "; it should be above " + Value(limit).text());
  return fallback;
}

int numberBetween(const Parameters& group, const std::string& name, int fallback, int low,
                  int high) {
  const int number = group.optional(name, fallback);
  if (number >= low && number <= high) return number;
  group.addError(name, "found " + std::to_string(number) + "; it should be " + std::to_string(low) +
                           " to " + std::to_string(high));
  return fallback;
}

/// A length of time in seconds, at most about 30 years, so that nanoseconds stay in range.
std::optional<double> maybeSeconds(const Parameters& group, const std::string& name) {
  constexpr double kLongest = 1e9;
  const auto number = group.maybe<double>(name);
  if (number && (*number < 0.0 || *number > kLongest)) {
    group.addError(name, "found " + Value(*number).text() + " s; it should be 0 to 1e9");
    return std::nullopt;
  }
  return number;
}

/// Absolute, with a leading `~/` taken as the user's home.
std::string absolutePath(const std::string& path) {
  if (path.empty()) return path;
  std::filesystem::path result = path;
  const char* home = std::getenv("HOME");
  if (home != nullptr && path.rfind("~/", 0) == 0) {
    result = std::filesystem::path(home) / path.substr(2);
  }
  return std::filesystem::absolute(result).lexically_normal().string();
}

std::string folderPath(const std::string& path) {
  std::string result = absolutePath(path);
  if (!result.empty() && result.back() != '/') result += '/';
  return result;
}

MotionConfig readMotion(const Parameters& root) {
  MotionConfig motion;
  motion.bag_files = root.required<std::vector<std::string>>("bag_file");
  const auto given = root.maybe<Value>("bag_file");
  if (given && given->is<Value::List>() && given->as<Value::List>()->empty()) {
    root.addError("bag_file", "found an empty list; it should name at least one bag");
  }
  for (std::string& file : motion.bag_files) file = absolutePath(file);
  motion.rate = numberAbove(root, "simulated_rate", motion.rate, 0.0);
  constexpr double kHighestRate = 1e9;  // a period of one nanosecond
  if (motion.rate > kHighestRate) {
    root.addError("simulated_rate", "found " + Value(motion.rate).text() + " Hz; at most 1e9");
    motion.rate = 30.0;
  }
  motion.start_offset = maybeSeconds(root, "start_offset").value_or(0.0);
  motion.duration = maybeSeconds(root, "duration");
  motion.max_tf_gap = maybeSeconds(root, "max_tf_gap");
  return motion;
}

/// A path made absolute; a URI as it is.
std::string pathOrUri(const std::string& text) {
  return text.find("://") == std::string::npos ? absolutePath(text) : text;
}

/// `world` is a file's name, or a group with `file` and `model_folders`.
WorldConfig readWorld(const Parameters& root) {
  WorldConfig world;
  const auto replaced = root.maybe<std::string>("world_file");
  const auto given = root.maybe<Value>("world");
  if (given && given->is<Value::Map>()) {
    const Parameters group = root.group("world");
    if (!replaced) world.file = group.required<std::string>("file");
    group.ignore("file");
    world.model_folders =
        group.maybe<std::vector<std::string>>("model_folders").value_or(std::vector<std::string>{});
    for (std::string& folder : world.model_folders) folder = absolutePath(folder);
  } else if (given || !replaced) {
    world.file = root.required<std::string>("world");
  }
  if (replaced) world.file = *replaced;
  world.file = pathOrUri(world.file);
  return world;
}

std::optional<Pose> readPose(const Parameters& group, const std::string& name) {
  const auto numbers = group.maybe<std::vector<double>>(name);
  if (!numbers) return std::nullopt;
  const std::vector<double>& n = *numbers;
  if (n.size() != 7) {
    group.addError(name, "found " + std::to_string(n.size()) +
                             " numbers; it should be [x, y, z, qx, qy, qz, qw]");
    return std::nullopt;
  }
  const Eigen::Quaterniond orientation(n[6], n[3], n[4], n[5]);
  constexpr double kTolerance = 1e-2;  // a rounded quaternion is meant; a wrong one is not
  if (std::abs(orientation.norm() - 1.0) > kTolerance) {
    group.addError(name, "found a quaternion of length " + fixed(orientation.norm(), 4) +
                             "; qx, qy, qz, qw should have length 1");
    return std::nullopt;
  }
  return makePose({n[0], n[1], n[2]}, orientation);
}

CameraConfig readCamera(const Parameters& root) {
  CameraConfig camera;
  camera.frame = root.optional("camera_frame_id", camera.frame);
  const Parameters group = root.group("camera");
  camera.info_file = group.maybe<std::string>("info_file");
  if (camera.info_file) camera.info_file = absolutePath(*camera.info_file);
  camera.sensor = group.maybe<std::string>("sensor");
  camera.X_GC = readPose(group, "pose");
  camera.rectified = group.maybe<bool>("rectified").value_or(false);
  camera.near = numberAbove(group, "near", camera.near, 0.0);
  camera.far = numberAbove(group, "far", camera.far, camera.near);
  if (!camera.info_file && !camera.sensor) {
    root.addError("camera",
                  "no intrinsics; camera/info_file should name a camera_info YAML file, or "
                  "camera/sensor a camera of the world");
  }
  return camera;
}

/// `class` and `id` may be a text or a number. They are words of label files, a line an object.
std::string readLabel(const Parameters& group, const std::string& name) {
  const Value value = group.required<Value>(name);
  std::string text = value.text();
  if (value.is<Value::List>() || value.is<Value::Map>()) {
    group.addError(name, "found " + value.kind() + "; it should be a text or a number");
  } else if (text.empty() || text.find_first_of("\n\r") != std::string::npos) {
    group.addError(name, "found a text that is empty or has more than one line");
  }
  return text;
}

ObjectConfig readObject(const Parameters& root, const std::string& name) {
  const Parameters group = root.group(name);
  ObjectConfig object;
  object.name = name;
  object.class_name = readLabel(group, "class");
  object.id = readLabel(group, "id");
  object.frame = name + "/" + group.optional<std::string>("frame_id", "base_link");
  object.model = group.maybe<std::string>("model");
  if (object.model) object.model = pathOrUri(*object.model);
  object.keypoints_O = group.required<std::vector<Eigen::Vector3d>>("keypoints");
  object.bounding_shape_O = group.required<std::vector<Eigen::Vector3d>>("bounding_shape");
  const auto shape = group.maybe<Value>("bounding_shape");
  if (shape && shape->is<Value::List>() && shape->as<Value::List>()->empty()) {
    group.addError("bounding_shape", "found no points; it should circumscribe the object");
  }
  return object;
}

std::vector<ObjectConfig> readObjects(const Parameters& root) {
  const auto names = root.required<std::vector<std::string>>("robot_list");
  const auto given = root.maybe<Value>("robot_list");
  if (given && given->is<Value::List>() && given->as<Value::List>()->empty()) {
    root.addError("robot_list", "found an empty list; it should name at least one object");
  }
  std::vector<ObjectConfig> objects;
  std::set<std::string> seen;
  std::map<std::string, std::string> ids;
  for (std::string name : names) {
    if (!name.empty() && name.front() == '/') name.erase(0, 1);
    if (name.empty() || !seen.insert(name).second) {
      root.addError("robot_list",
                    name.empty() ? "found an empty name" : "found '" + name + "' more than once");
      continue;
    }
    objects.push_back(readObject(root, name));
    const ObjectConfig& object = objects.back();
    const auto [same, added] = ids.emplace(object.id, name);
    if (!added && root.group(name).has("id")) {
      root.addError(name + "/id", "found " + object.id + ", which is also the id of '" +
                                      same->second + "'; each object should have its own");
    }
  }
  return objects;
}

MaskConfig readMasks(const Parameters& root) {
  MaskConfig masks;
  const Parameters subtractor = root.group("background_subtractor");
  masks.history_length =
      numberBetween(subtractor, "history_length", masks.history_length, 1, 10000);
  masks.var_threshold = numberAbove(subtractor, "var_threshold", masks.var_threshold, 0.0);
  masks.detect_shadows = subtractor.optional("detect_shadows", masks.detect_shadows);
  masks.clean = root.group("masks").optional("clean", masks.clean);
  return masks;
}

PhysicsConfig readPhysics(const Parameters& root) {
  PhysicsConfig physics;
  const Parameters group = root.group("physics");
  constexpr double kLongestStep = 0.1;  // [s]: beyond it things fall through floors
  physics.step = numberAbove(group, "step", physics.step, 1e-5);
  if (physics.step > kLongestStep) {
    group.addError("step", "found " + Value(physics.step).text() + " s; it should be at most 0.1");
    physics.step = kLongestStep;
  }
  physics.contact_tolerance = group.optional("contact_tolerance", physics.contact_tolerance);
  if (physics.contact_tolerance < 0.0) {
    group.addError("contact_tolerance", "found " + Value(physics.contact_tolerance).text() +
                                            " m; it should not be below 0");
    physics.contact_tolerance = 0.0;
  }
  return physics;
}

RenderingConfig readRendering(const Parameters& root) {
  RenderingConfig rendering;
  const Parameters group = root.group("rendering");
  rendering.samples = group.optional("samples", rendering.samples);
  if (rendering.samples != 1 && rendering.samples != 4) {
    group.addError("samples", "found " + std::to_string(rendering.samples) +
                                  "; it should be 1 or 4, which is what OSMesa can do");
    rendering.samples = 4;
  }
  rendering.shadow_map_size =
      numberBetween(group, "shadow_map_size", rendering.shadow_map_size, 64, 8192);
  rendering.shadow_distance = numberAbove(group, "shadow_distance", rendering.shadow_distance, 0.0);
  return rendering;
}

OutputConfig readOutput(const Parameters& root) {
  OutputConfig output;
  output.folder = absolutePath(root.maybe<std::string>("output_folder").value_or(""));
  const auto if_exists = root.optional<std::string>("if_exists", "error");
  if (if_exists != "error" && if_exists != "overwrite") {
    root.addError("if_exists", "found '" + if_exists + "'; it should be error or overwrite");
  }
  output.overwrite = if_exists == "overwrite";
  const Parameters image = root.group("image");
  output.png_compression = numberBetween(image, "png_compression", output.png_compression, 0, 9);
  output.jpeg_quality = numberBetween(image, "jpeg_quality", output.jpeg_quality, 1, 100);
  return output;
}

/// The text of an entry's member, or nothing.
std::string memberText(const Value& entry, const std::string& member) {
  const auto* map = entry.as<Value::Map>();
  if (map == nullptr) return "";
  const auto found = map->find(member);
  const auto* text = found == map->end() ? nullptr : found->second.as<std::string>();
  return text == nullptr ? "" : *text;
}

/// Names and types of the writers; left out, the original's three.
std::vector<std::pair<std::string, std::string>> readWriterNames(const Parameters& root) {
  const auto given = root.maybe<Value>("writers");
  if (!given) {
    return {{"bounding_shape", "synthetic_dataset/BoundingShape"},
            {"yolo", "synthetic_dataset/Yolo"},
            {"stvnet", "synthetic_dataset/StvNet"}};
  }
  const std::string should = "; it should be a list of {name: ..., type: ...}";
  const auto* list = given->as<Value::List>();
  if (list == nullptr || list->empty()) {
    root.addError("writers",
                  "found " + (list == nullptr ? given->kind() : "an empty list") + should);
    return {};
  }
  std::vector<std::pair<std::string, std::string>> writers;
  for (const Value& entry : *list) {
    const std::string name = memberText(entry, "name");
    const std::string type = memberText(entry, "type");
    if (name.empty() || type.empty() || entry.as<Value::Map>()->size() != 2) {
      root.addError("writers", "found the entry " + entry.text() + should);
      continue;
    }
    writers.emplace_back(name, type);
  }
  return writers;
}

std::vector<WriterConfig> readWriters(const Parameters& root, const std::string& output_folder) {
  std::vector<WriterConfig> writers;
  std::set<std::string> seen;
  for (const auto& [name, type] : readWriterNames(root)) {
    if (!seen.insert(name).second) {
      root.addError("writers", "found the name '" + name + "' more than once");
      continue;
    }
    const Parameters group = root.group(name);
    auto folder = group.maybe<std::string>("output_folder");
    if (!folder && output_folder.empty()) {
      group.addError("output_folder",
                     "required, but missing (or give the whole run an output_folder)");
    }
    if (!folder) folder = output_folder + "/" + name;
    writers.push_back({name, type, folderPath(*folder), group});
  }
  return writers;
}

/// The deepest folder that all the writers' folders share, for the manifest.
std::string commonFolder(const std::vector<WriterConfig>& writers) {
  if (writers.empty()) return "";
  std::filesystem::path common = writers.front().output_folder;
  for (const WriterConfig& writer : writers) {
    std::filesystem::path shared;
    const std::filesystem::path other = writer.output_folder;
    for (auto a = common.begin(), b = other.begin();
         a != common.end() && b != other.end() && *a == *b; ++a, ++b) {
      shared /= *a;
    }
    common = shared;
  }
  // Folders that share only the root have no place in common for a manifest.
  if (common == common.root_path()) return writers.front().output_folder;
  return common.string();
}

/// Whether a group looks like the block of an object or a writer that this run leaves out.
bool isUnusedBlock(const Value& value) {
  const auto* map = value.as<Value::Map>();
  if (map == nullptr) return false;
  const auto holds = [&](const char* name) { return map->count(name) != 0; };
  return holds("output_folder") || (holds("class") && holds("id"));
}

}  // namespace

Config readConfig(const Parameters& root) {
  Config config;
  config.motion = readMotion(root);
  config.global_frame = root.optional("global_frame", config.global_frame);
  config.world = readWorld(root);
  config.camera = readCamera(root);
  config.objects = readObjects(root);
  config.masks = readMasks(root);
  config.physics = readPhysics(root);
  config.rendering = readRendering(root);
  config.output = readOutput(root);
  config.writers = readWriters(root, config.output.folder);
  if (config.output.folder.empty()) config.output.folder = commonFolder(config.writers);
  for (const ObjectConfig& object : config.objects) {
    for (const WriterConfig& writer : config.writers) {
      if (object.name == writer.name) {
        root.addError("robot_list", "found '" + object.name +
                                        "', which is also a writer's name; rename the writer");
      }
    }
  }
  return config;
}

std::vector<std::string> unknownParameterErrors(const Parameters& root) {
  // Asking whether a block is unused makes it known, so the suggestions come first.
  std::vector<std::pair<std::string, std::string>> found;
  for (const std::string& name : root.unknownNames()) {
    found.emplace_back(name,
                       didYouMean(name.substr(name.rfind('/') + 1), root.knownNeighbours(name)));
  }
  std::vector<std::string> errors;
  for (const auto& [name, suggestion] : found) {
    if (root.has(name) && isUnusedBlock(*root.maybe<Value>(name))) continue;
    errors.push_back(name + ": unknown parameter" + suggestion);
  }
  return errors;
}

}  // namespace synthetic_dataset::config
