#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/object_model.h"
#include "synthetic_dataset/output.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset {
inline namespace v2 {

/// The parameters below a writer's name, and what the core knows of the writer.
class WriterParameters : public Parameters {
 public:
  /// @param writer_name  the writer's name in the parameter `writers`
  /// @param output_folder  absolute, ending in `/`
  WriterParameters(Parameters parameters, std::string writer_name, std::string output_folder);

  [[nodiscard]] const std::string& writerName() const { return writer_name_; }

  /// Where this writer's files go: absolute, ending in `/`.
  [[nodiscard]] const std::string& outputFolder() const { return output_folder_; }

  /// A file that the user names in a parameter, for DatasetOutput::addFileAtParameter; a relative
  /// path is relative to the writer's output folder. The core checks before the first scene that
  /// the file can be made.
  [[nodiscard]] FileParameter requiredFile(const std::string& name);

  /// Warns of something at the start of the run, before the first scene: what a loader of the
  /// format will not like about the settings, for one. The run lists it, and the manifest.
  void addWarning(const std::string& text) { warnings_.push_back(text); }

  /// All of them.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// The paths of all files read with `requiredFile`.
  [[nodiscard]] const std::set<std::string>& files() const { return files_; }

 private:
  std::string writer_name_;
  std::string output_folder_;
  std::set<std::string> files_;
  std::vector<std::string> warnings_;
};

/// What is known of an object before the first scene.
struct ObjectInfo {
  std::string name;
  std::string class_name;  ///< of its class in DatasetInfo::classes
  std::string id;
  int class_id = 0;  ///< of its class in DatasetInfo::classes
  std::size_t keypoint_count = 0;
  std::vector<std::string> keypoint_names;  ///< as many: the parameter, else "0", "1", ...

  /// Whether there may be scenes in which it has another model than DatasetInfo::model() says, or
  /// is of another size or shape (variants of `same_class` have other proportions): of each scene,
  /// SceneObject counts. A format that has room for one model alone cannot hold such scenes.
  bool model_varies = false;

  /// Pairs of keypoints to draw lines between, by their indices.
  std::vector<std::array<std::size_t, 2>> skeleton;

  /// Groups of its links that the user has named: what Scene::part_map shows.
  std::vector<std::string> part_names;
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

/// What is known of a lidar before the first scene.
struct LidarDescription {
  std::string name;
  std::string frame;  ///< its own: x ahead, y left, z up; Scene::transform knows it
};

/// Scenes of one recording, or placed by one rule, in one world. No scene has to do with those of
/// another motion, and the times of one have nothing to do with those of another.
struct MotionInfo {
  std::string name;                ///< of its entry in `motions`, or its number from 0
  std::int64_t first_instant = 0;  ///< Scene::instant of its first scenes
  std::int64_t instant_count = 0;  ///< times; each is a scene of every camera
  double rate = 0.0;               ///< its times in a second [Hz]; 0 where scenes are placed
};

/// Who made files that scenes are made of (the world's, models', textures'), and what may be done
/// with them, as far as files say so. Who publishes the dataset has to name them.
struct CreditInfo {
  std::string author;              ///< several are divided by "; "; empty: not said
  std::string license;             ///< as it is written; empty: not said
  std::vector<std::string> files;  ///< folder and name of each: "rover/model.sdf"
};

/// What is known of the dataset before the first scene.
struct DatasetInfo {
  std::vector<ObjectInfo> objects;  ///< in the order of `robot_list`
  std::int64_t scene_count = 0;  ///< as planned: none at which a frame of a writer's is not known
  std::string global_frame;      ///< the fixed TF frame, in which Scene's poses are given
  std::vector<CameraDescription> cameras;  ///< at least one
  std::vector<ClassInfo> classes;          ///< in the order of their ids, each once
  std::vector<std::string> world_classes;  ///< names for parts of the world: of Scene::world_map
  std::vector<SplitInfo> splits;           ///< in the order train, val, test; empty: none asked for
  std::vector<MotionInfo> motions;         ///< at least one, in the order of their scenes
  std::vector<CreditInfo> credits;         ///< each author and licence once
  std::vector<LidarDescription> lidars;    ///< in alphabetical order; there may be none

  /// The surface of an object, with its links as its model file places them. Made anew at each
  /// call.
  /// @param object  its index in `objects`
  /// @throws Error where models are not known
  [[nodiscard]] ObjectModel model(std::size_t object) const;

  /// The names of the splits in their order; "train" alone where none were asked for.
  [[nodiscard]] std::vector<std::string> splitFolders() const;

  /// The index in `classes` of a class.
  /// @throws Error where no class has this number
  [[nodiscard]] std::size_t classIndex(int class_id) const;

  /// The classes' names by their numbers, "unused_3" for those that no class has: formats that
  /// number classes from 0 without gaps have such a list.
  [[nodiscard]] std::vector<std::string> classNamesWithoutGaps() const;

  /// The folder of a camera's files, with a `/` at its end; "" where there is one camera alone.
  [[nodiscard]] std::string cameraFolder(std::size_t camera) const;

  /// The index in `lidars` of the lidar that a writer's parameter names. Another name is noted as
  /// an error of the parameter; nothing then.
  /// @param name  in `parameters`
  /// @param lidar  what it says
  [[nodiscard]] std::optional<std::size_t> lidarIndex(Parameters& parameters,
                                                      const std::string& name,
                                                      const std::string& lidar) const;

  /// For formats that hold one calibration of each camera for all of its images.
  /// @param file  in which it stands, for the message
  /// @throws Error where a camera's intrinsics differ from scene to scene
  void refuseVaryingIntrinsics(const std::string& file) const;

  /// For formats that hold one model of each object for all images.
  /// @param file  in which it stands, for the message
  /// @throws Error where an object's model or size differs from scene to scene
  void refuseVaryingModels(const std::string& file) const;

  /// For who makes datasets: how `model` knows surfaces.
  using Models = std::function<ObjectModel(std::size_t object)>;
  void setModels(Models models) { models_ = std::move(models); }

 private:
  Models models_;
};

/// What a writer needs to be computed. What no writer asks for is not computed, and asking the
/// scene for it throws.
struct Requirements {
  bool silhouettes = false;         ///< SceneObject::silhouette
  bool visible_masks = false;       ///< SceneObject::visible_mask, visible_box, pixels.visible;
                                    ///< Scene::instance_map
  bool visibility = false;          ///< SceneObject::pixels, visibility, truncation, silhouette_box
  bool keypoint_states = false;     ///< Keypoint::state
  bool class_map = false;           ///< Scene::class_map, and all of visible_masks
  bool world_map = false;           ///< Scene::world_map
  bool part_map = false;            ///< Scene::part_map
  bool depth = false;               ///< Scene::depth
  bool normals = false;             ///< Scene::normals
  bool optical_flow = false;        ///< Scene::optical_flow
  bool clouds = false;              ///< Scene::clouds
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
///
/// What a writer need not check, as the core does: the order of the calls; that parameters have the
/// type that they are read as, and that none is misspelt; that names of objects, classes and
/// cameras are one line of UTF-8, and that an object's class is in DatasetInfo::classes; that
/// required frames are known and what is required is there; that paths stay in the writer's folder,
/// are used once and do not meet those of other writers; that files can be written, and their
/// format can hold the pixels; that scenes come from several runs or processes.
///
/// Export with PLUGINLIB_EXPORT_CLASS(my_package::MyWriter, synthetic_dataset::LabelWriter).
class LabelWriter {
 public:
  LabelWriter() = default;
  LabelWriter(const LabelWriter&) = delete;
  LabelWriter& operator=(const LabelWriter&) = delete;
  virtual ~LabelWriter();

  /// @param parameters  the writer's own, in which wrong ones are noted
  /// @throws Error when it is called twice, or with what the writer throws
  void initialize(WriterParameters& parameters, const DatasetInfo& dataset);

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
  virtual void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset);

  virtual Requirements doRequirements() const;

  /// Says which files the scene becomes. The only method that every writer has.
  virtual void doWriteScene(const Scene& scene, SceneOutput& output) const = 0;

  /// Says which files the whole dataset has.
  virtual void doFinalize(const SceneRecords& records, DatasetOutput& output) const;

  std::string name_;
  bool initialized_ = false;
};

}  // namespace v2
}  // namespace synthetic_dataset
