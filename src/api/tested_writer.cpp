#include "synthetic_dataset/tested_writer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/relative_path.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

/// The paths that a writer has asked for so far.
class UsedPaths {
 public:
  void use(const std::string& path) {
    if (const auto problem = relativePathProblem(path)) {
      throw Error("the path '" + path + "' cannot be used: " + *problem);
    }
    if (!used_.insert(path).second) throw Error("the path '" + path + "' was used twice");
  }

 private:
  std::set<std::string> used_;
};

class TestedSceneOutput : public SceneOutput {
 public:
  void addImage(const std::string& path, const cv::Mat& image) override {
    paths_.use(path);
    written.images[path] = image.clone();
  }

  void addMask(const std::string& path, const Mask& mask) override {
    paths_.use(path);
    written.images[path] = mask.whole();
  }

  void addIndexedImage(const std::string& path, const cv::Mat& indices,
                       const std::vector<cv::Vec3b>& /*palette*/) override {
    addImage(path, indices);
  }

  void addText(const std::string& path, std::string text) override {
    paths_.use(path);
    written.texts[path] = std::move(text);
  }

  void addRecord(const std::string& channel, std::string record) override {
    if (channel.find('\n') != std::string::npos) {
      throw Error("the records' channel '" + channel + "' has more than one line");
    }
    written.records.emplace_back(channel, std::move(record));
  }

  void addWarning(const std::string& kind) override { written.warnings.push_back(kind); }

  WrittenFiles written;

 private:
  UsedPaths paths_;
};

using Scenes = std::map<std::int64_t, WrittenFiles>;

class TestedRecords : public SceneRecords {
 public:
  explicit TestedRecords(const Scenes& scenes) : scenes_(scenes) {}

  void forEach(const std::string& channel,
               const std::function<void(std::int64_t scene_index, const std::string& record)>&
                   visit) const override {
    for (const auto& [index, scene] : scenes_) {
      for (const auto& [name, record] : scene.records) {
        if (name == channel) visit(index, record);
      }
    }
  }

 private:
  const Scenes& scenes_;
};

/// The content of a file that a library writes itself.
std::string contentOf(const std::function<void(const std::string& file)>& write) {
  const std::string parent = std::filesystem::temp_directory_path().string();
  std::string folder = parent + "/synthetic_dataset_XXXXXX";
  if (mkdtemp(folder.data()) == nullptr) throw Error("no folder can be made in '" + parent + "'");
  const std::string file = folder + "/file";
  const auto remove = [&] {
    (void)std::remove(file.c_str());
    (void)std::remove(folder.c_str());
  };
  try {
    write(file);
  } catch (...) {
    remove();
    throw;
  }
  std::ifstream stream(file, std::ios::binary);
  std::string content(std::istreambuf_iterator<char>(stream), {});
  remove();
  return content;
}

class TestedDatasetOutput : public DatasetOutput {
 public:
  TestedDatasetOutput(const WriterParameters& parameters, const Scenes& scenes)
      : parameters_(parameters), scenes_(scenes) {}

  void addFile(const std::string& path, const Content& content) override {
    paths_.use(path);
    written.texts[path] = textOf(content);
  }

  void addFileAtParameter(const FileParameter& file, const Content& content) override {
    if (parameters_.files().count(file.path()) == 0) {
      throw Error("addFileAtParameter: the file '" + file.path() +
                  "' was not read from this writer's parameters with requiredFile");
    }
    written.texts[file.path()] = textOf(content);
  }

  void addFileByName(const std::string& path,
                     const std::function<void(const std::string& file)>& write) override {
    paths_.use(path);
    written.texts[path] = contentOf(write);
  }

  void addLink(const std::string& path, const std::string& scene_file) override {
    paths_.use(path);
    (void)sceneWith(scene_file);
    written.links[path] = scene_file;
  }

  [[nodiscard]] std::string readFile(const std::string& scene_file) const override {
    const WrittenFiles& scene = sceneWith(scene_file);
    const auto text = scene.texts.find(scene_file);
    if (text == scene.texts.end()) {
      throw Error("'" + scene_file + "' is an image, which is not encoded in a test");
    }
    return text->second;
  }

  WrittenFiles written;

 private:
  static std::string textOf(const Content& content) {
    std::ostringstream stream;
    content(stream);
    return stream.str();
  }

  [[nodiscard]] const WrittenFiles& sceneWith(const std::string& file) const {
    for (const auto& [index, scene] : scenes_) {
      if (scene.texts.count(file) + scene.images.count(file) > 0) return scene;
    }
    throw Error("no scene has a file '" + file + "'");
  }

  const WriterParameters& parameters_;
  const Scenes& scenes_;
  UsedPaths paths_;
};

/// The scene as the core passes it to the writer: of the members that can be required, it has only
/// those that are.
Scene withRequired(Scene scene, const Requirements& required) {
  const Scene unknown(scene.camera);
  const bool visible_masks = required.visible_masks || required.class_map;
  if (!visible_masks) scene.instance_map = unknown.instance_map;
  if (!required.class_map) scene.class_map = unknown.class_map;
  if (!required.world_map) scene.world_map = unknown.world_map;
  if (!required.part_map) scene.part_map = unknown.part_map;
  if (!required.depth) scene.depth = unknown.depth;
  if (!required.normals) scene.normals = unknown.normals;
  if (!required.optical_flow) scene.optical_flow = unknown.optical_flow;
  if (!required.clouds) scene.clouds = unknown.clouds;
  for (SceneObject& object : scene.objects) {
    const SceneObject nothing;
    if (!required.silhouettes) object.silhouette = nothing.silhouette;
    if (!visible_masks) object.visible_mask = nothing.visible_mask;
    if (!required.visibility) {
      object.silhouette_box = nothing.silhouette_box;
      object.pixels.silhouette = nothing.pixels.silhouette;
      object.pixels.silhouette_in_image = nothing.pixels.silhouette_in_image;
      if (!visible_masks) object.pixels.visible = nothing.pixels.visible;
    }
    if (required.keypoint_states) continue;
    for (Keypoint& keypoint : object.keypoints) keypoint.state = Keypoint().state;
  }
  return scene;
}

bool areEqual(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  for (int row = 0; row < a.rows; ++row) {
    const auto bytes = static_cast<std::size_t>(a.cols) * a.elemSize();
    if (!std::equal(a.ptr(row), a.ptr(row) + bytes, b.ptr(row))) return false;
  }
  return true;
}

bool areEqual(const WrittenFiles& a, const WrittenFiles& b) {
  const bool images_are =
      a.images.size() == b.images.size() &&
      std::equal(a.images.begin(), a.images.end(), b.images.begin(),
                 [](const auto& left, const auto& right) {
                   return left.first == right.first && areEqual(left.second, right.second);
                 });
  return images_are && a.texts == b.texts && a.records == b.records && a.warnings == b.warnings;
}

}  // namespace

TestedWriter::TestedWriter(LabelWriter& writer, const Value::Map& parameters,
                           const DatasetInfo& dataset)
    : writer_(writer), parameters_(Parameters(parameters, "w"), "w", "/w/") {
  writer_.initialize(parameters_, dataset);
  std::vector<std::string> problems = parameters_.errors();
  for (const std::string& name : parameters_.unknownNames()) {
    problems.push_back(name + ": is not a parameter of this writer");
  }
  if (!problems.empty()) throw ErrorList(problems);
}

WrittenFiles TestedWriter::write(const Scene& scene) {
  const Scene given = withRequired(scene, writer_.requirements());
  TestedSceneOutput first;
  writer_.writeScene(given, first);
  TestedSceneOutput second;
  writer_.writeScene(given, second);
  if (!areEqual(first.written, second.written)) {
    throw Error("the writer made different output for scene " + scene.name + " when asked again");
  }
  scenes_[scene.index] = first.written;
  return first.written;
}

WrittenFiles TestedWriter::finalize() const {
  TestedDatasetOutput output(parameters_, scenes_);
  writer_.finalize(TestedRecords(scenes_), output);
  return output.written;
}

}  // namespace v2
}  // namespace synthetic_dataset
