#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "synthetic_dataset/object_model.h"
#include "synthetic_dataset/output.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset {
inline namespace v1 {

/// The parameters below a writer's name, and what the core knows of the writer.
class WriterParameters : public Parameters {
 public:
  /// @param writer_name  the writer's name in the parameter `writers`
  /// @param output_folder  absolute, ending in `/`
  WriterParameters(Parameters parameters, std::string writer_name, std::string output_folder);

  [[nodiscard]] const std::string& writerName() const { return writer_name_; }

  /// Where this writer's files go: absolute, ending in `/`.
  [[nodiscard]] const std::string& outputFolder() const { return output_folder_; }

  /// The path of a file that the user names in a parameter, for DatasetOutput::addFileAtParameter;
  /// a relative one is relative to the writer's output folder.
  /// The core checks before the first scene that the file can be made.
  [[nodiscard]] std::string requiredFile(const std::string& name) const;

  /// The files read with `requiredFile`: parameter name to path.
  [[nodiscard]] const std::map<std::string, std::string>& files() const { return *files_; }

 private:
  std::string writer_name_;
  std::string output_folder_;
  std::shared_ptr<std::map<std::string, std::string>> files_;
};

/// What is known of an object before the first scene.
struct ObjectInfo {
  std::string name;
  std::string class_name;  ///< of its class in DatasetInfo::classes
  std::string id;
  int class_id = 0;  ///< of its class in DatasetInfo::classes
  std::size_t keypoint_count = 0;
  std::vector<std::string> keypoint_names;  ///< as many: the parameter, else "0", "1", ...

  /// Whether there may be scenes in which it wears another model than DatasetInfo::model() has, or
  /// is of another size: of each scene, SceneObject counts. A format that has room for one model
  /// alone cannot hold such scenes.
  bool model_varies = false;

  /// Pairs of keypoints to draw lines between, by their places from 0.
  std::vector<std::array<std::size_t, 2>> skeleton;
};

/// A class of objects. All writers number classes alike.
struct ClassInfo {
  int id = 0;  ///< at least 0
  std::string name;
};

/// A part of the dataset with a use of its own.
struct SplitInfo {
  std::string name;  ///< "train", "val", "test"
  std::int64_t scene_count = 0;
};

/// What is known of a camera before the first scene.
struct CameraDescription {
  std::string name;
  std::string frame;  ///< of its optical frame
  CameraModel model;

  /// Whether there may be scenes with another model than `model`: of each scene, Scene::camera
  /// counts. A format that has room for one calibration alone cannot hold such scenes.
  bool intrinsics_vary = false;
};

/// Scenes of one recording, or placed by one rule, in one world. No scene has to do with those of
/// another motion, and the times of one have nothing to do with those of another.
struct MotionInfo {
  std::string name;                ///< of its entry in `motions`, or its number from 0
  std::int64_t first_instant = 0;  ///< Scene::instant of its first scenes
  std::int64_t instant_count = 0;  ///< times; each is a scene of every camera
};

/// What is known of the dataset before the first scene.
struct DatasetInfo {
  std::vector<ObjectInfo> objects;  ///< in the order of `robot_list`
  std::int64_t scene_count = 0;  ///< as planned: none at which a frame of a writer's is not known
  std::string global_frame;      ///< the fixed TF frame, in which Scene's poses are given
  std::vector<CameraDescription> cameras;  ///< at least one
  std::vector<ClassInfo> classes;          ///< in the order of their ids, each once
  std::vector<SplitInfo> splits;           ///< in the order train, val, test; empty: none asked for
  std::vector<MotionInfo> motions;         ///< at least one, in the order of their scenes

  /// The surface of an object, with its links as its model file places them. Made anew at each
  /// call.
  /// @param object  its index in `objects`
  [[nodiscard]] ObjectModel model(std::size_t object) const { return models(object); }

  std::function<ObjectModel(std::size_t object)> models;
};

/// What a writer needs to be computed. What no writer asks for is not computed.
struct Requirements {
  bool silhouettes = false;  ///< SceneObject::silhouette
  bool visible_masks =
      false;  ///< SceneObject::visible_mask, visible_box, pixels.visible; Scene::instance_map
  bool visibility = false;          ///< SceneObject::pixels, visibility, truncation, silhouette_box
  bool keypoint_states = false;     ///< Keypoint::state
  bool class_map = false;           ///< Scene::class_map
  bool depth = false;               ///< Scene::depth
  bool normals = false;             ///< Scene::normals
  bool optical_flow = false;        ///< Scene::optical_flow
  std::vector<std::string> frames;  ///< TF frames that Scene::transform must know at every scene
};

/// A dataset format: turns scenes into files. The base class of every writer plugin.
///
/// A writer is a pure function from a scene to files: it opens no file, holds no state from scene
/// to scene and starts no thread. Its life: one `initialize`, then `requirements`, then
/// `writeScene` for each scene, in any order and from any one thread at a time, then one
/// `finalize`. The public methods check that `initialize` comes first, and once. A resumed run
/// skips scenes that are already there, so `finalize` learns about scenes from the records alone.
///
/// Errors: throw Error (or any std::exception); the public methods add the writer's name.
/// Export with PLUGINLIB_EXPORT_CLASS(my_package::MyWriter, synthetic_dataset::LabelWriter).
class LabelWriter {
 public:
  LabelWriter() = default;
  LabelWriter(const LabelWriter&) = delete;
  LabelWriter& operator=(const LabelWriter&) = delete;
  virtual ~LabelWriter();

  /// @param parameters  the writer's own, in which wrong ones are noted
  /// @throws Error when it is called twice, or with what the writer throws
  void initialize(const WriterParameters& parameters, const DatasetInfo& dataset);

  /// What has to be computed for this writer, the same at each call.
  /// @throws Error before `initialize`, or with what the writer throws
  [[nodiscard]] Requirements requirements() const;

  /// Hands a scene over, with what `requirements` asks for.
  /// @param output  takes the scene's files, which the core writes
  /// @throws Error before `initialize`, or with what the writer throws
  void writeScene(const Scene& scene, SceneOutput& output) const;

  /// Asks for the files of the dataset as a whole. Not called for a shard, whose scenes are
  /// finished when the shards are merged.
  /// @param records  what `writeScene` noted of each scene, of this run or an earlier one
  /// @throws Error before `initialize`, or with what the writer throws
  void finalize(const SceneRecords& records, DatasetOutput& output) const;

 private:
  /// Reads the writer's parameters. Errors noted in `parameters` need not be thrown again.
  virtual void doInitialize(const WriterParameters& parameters, const DatasetInfo& dataset);

  virtual Requirements doRequirements() const;

  /// Says which files the scene becomes. The only method that every writer has.
  virtual void doWriteScene(const Scene& scene, SceneOutput& output) const = 0;

  /// Says which files the whole dataset has.
  virtual void doFinalize(const SceneRecords& records, DatasetOutput& output) const;

  std::string name_;
  bool initialized_ = false;
};

}  // namespace v1
}  // namespace synthetic_dataset
