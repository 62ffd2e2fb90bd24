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

/// The parameters below a writer's name, and what the core knows about the writer.
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
  /// the file can be created.
  [[nodiscard]] FileParameter requiredFile(const std::string& name);

  /// Adds a warning for the start of the run, before the first scene; for example, about settings
  /// that the format's loaders do not accept. The run and the manifest list it.
  void addWarning(const std::string& text) { warnings_.push_back(text); }

  /// All warnings added so far.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// The paths of all files read with `requiredFile`.
  [[nodiscard]] const std::set<std::string>& files() const { return files_; }

 private:
  std::string writer_name_;
  std::string output_folder_;
  std::set<std::string> files_;
  std::vector<std::string> warnings_;
};

/// Properties of an object that are known before the first scene.
struct ObjectInfo {
  std::string name;
  std::string class_name;  ///< of its class in DatasetInfo::classes
  std::string id;
  int class_id = 0;  ///< of its class in DatasetInfo::classes
  std::size_t keypoint_count = 0;
  std::vector<std::string> keypoint_names;  ///< one each: the parameter, else "0", "1", ...

  /// Whether some scenes may show it with a model other than DatasetInfo::model(), or in another
  /// size or shape (variants of `same_class` have other proportions). SceneObject is authoritative
  /// for each scene. A format with room for only one model cannot hold such scenes.
  bool model_varies = false;

  /// Pairs of keypoints to draw lines between, by their indices.
  std::vector<std::array<std::size_t, 2>> skeleton;

  /// The groups of its links that the user has named; Scene::part_map shows them.
  std::vector<std::string> part_names;
};

/// A class of objects. All writers number classes alike.
struct ClassInfo {
  int id = 0;  ///< at least 0
  std::string name;
};

/// A subset of the dataset with a purpose of its own.
struct SplitInfo {
  std::string name;  ///< "train", "val", "test"
  std::int64_t scene_count = 0;
};

/// Properties of a camera that are known before the first scene.
struct CameraDescription {
  std::string name;
  std::string frame;  ///< of its optical frame
  CameraModel model;

  /// Whether some scenes may have a camera model other than `model`; Scene::camera is authoritative
  /// for each scene. A format with room for only one calibration cannot hold such scenes.
  bool intrinsics_vary = false;
};

/// Properties of a lidar that are known before the first scene.
struct LidarDescription {
  std::string name;
  std::string frame;  ///< its own: x forward, y left, z up; Scene::transform knows it
};

/// The scenes of one recording, or those placed by one rule, in one world. Scenes and times of
/// different motions are unrelated.
struct MotionInfo {
  std::string name;                ///< of its entry in `motions`, or its index from 0
  std::int64_t first_instant = 0;  ///< Scene::instant of its first scenes
  std::int64_t instant_count = 0;  ///< number of times; each is one scene per camera
  double rate = 0.0;               ///< times per second [Hz]; 0 if scenes are placed
};

/// The author and licence of files used in the scenes (of the world, models and textures), as far
/// as the files state them. Whoever publishes the dataset has to credit the author.
struct CreditInfo {
  std::string author;              ///< several are separated by "; "; empty: not stated
  std::string license;             ///< as written in the file; empty: not stated
  std::vector<std::string> files;  ///< folder and name of each: "rover/model.sdf"
};

/// Properties of the dataset that are known before the first scene.
struct DatasetInfo {
  std::vector<ObjectInfo> objects;  ///< in the order of `robot_list`
  std::int64_t scene_count = 0;     ///< planned: without times at which a writer's frame is unknown
  std::string global_frame;         ///< the fixed TF frame, in which Scene's poses are given
  std::vector<CameraDescription> cameras;  ///< at least one
  std::vector<ClassInfo> classes;          ///< in the order of their ids, each once
  std::vector<std::string> world_classes;  ///< names for parts of the world, in Scene::world_map
  std::vector<SplitInfo> splits;           ///< in the order train, val, test; empty: none requested
  std::vector<MotionInfo> motions;         ///< at least one, in the order of their scenes
  std::vector<CreditInfo> credits;         ///< each pair of author and licence once
  std::vector<LidarDescription> lidars;    ///< in alphabetical order; there may be none

  /// The surface of an object, with its links posed as in its model file. Built anew by each call.
  /// @param object  its index in `objects`
  /// @throws Error if models are not known
  [[nodiscard]] ObjectModel model(std::size_t object) const;

  /// The names of the splits in order; only "train" if none were requested.
  [[nodiscard]] std::vector<std::string> splitFolders() const;

  /// The index of a class in `classes`.
  /// @throws Error if no class has this number
  [[nodiscard]] std::size_t classIndex(int class_id) const;

  /// The class names by number, with names like "unused_3" for numbers that no class has: for
  /// formats that number classes from 0 without gaps.
  [[nodiscard]] std::vector<std::string> classNamesWithoutGaps() const;

  /// The folder of a camera's files, ending in `/`; "" if there is only one camera.
  [[nodiscard]] std::string cameraFolder(std::size_t camera) const;

  /// The index in `lidars` of the lidar that a writer's parameter names. For an unknown lidar,
  /// notes an error of the parameter and returns nullopt.
  /// @param name  of the parameter in `parameters`
  /// @param lidar  the parameter's value
  [[nodiscard]] std::optional<std::size_t> lidarIndex(Parameters& parameters,
                                                      const std::string& name,
                                                      const std::string& lidar) const;

  /// For formats that hold one calibration of each camera for all of its images.
  /// @param file  that holds the calibration, for the message
  /// @throws Error if a camera's intrinsics differ from scene to scene
  void refuseVaryingIntrinsics(const std::string& file) const;

  /// For formats that hold one model of each object for all images.
  /// @param file  that holds the model, for the message
  /// @throws Error if an object's model or size differs from scene to scene
  void refuseVaryingModels(const std::string& file) const;

  /// For code that builds a DatasetInfo: sets the function that `model` calls.
  using Models = std::function<ObjectModel(std::size_t object)>;
  void setModels(Models models) { models_ = std::move(models); }

 private:
  Models models_;
};

/// The data that the core has to compute for a writer. Data that no writer asks for is not
/// computed, and reading it from a scene throws.
struct Requirements {
  bool silhouettes = false;         ///< SceneObject::silhouette
  bool visible_masks = false;       ///< SceneObject::visible_mask, visibleBox, pixels.visible;
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
  std::vector<std::string> frames;  ///< TF frames that Scene::transform must know in every scene
};

/// A dataset format: turns scenes into files. The base class of every writer plugin.
///
/// A writer is a pure function from a scene to files: it opens no file, keeps no state from scene
/// to scene and starts no thread. The order of calls is: one `initialize`, then `requirements`,
/// then `writeScene` for each scene, in any order and from any thread but one at a time, then one
/// `finalize`. The public methods check that `initialize` is called first, and once. A resumed run
/// skips scenes that already exist, so `finalize` learns about scenes only from the records.
///
/// Errors: throw Error (or any std::exception); the public methods add the writer's name.
///
/// A writer need not check what the core checks: the order of the calls; that parameters have the
/// type that they are read as, and that none is misspelt; that names of objects, classes and
/// cameras are one line of UTF-8, and that an object's class is in DatasetInfo::classes; that
/// required frames are known and what is required is there; that paths stay in the writer's folder,
/// are used once and do not clash with those of other writers; that files can be written, and their
/// format can hold the pixels. Nor need it care whether scenes come from several runs or processes.
///
/// Export with PLUGINLIB_EXPORT_CLASS(my_package::MyWriter, synthetic_dataset::LabelWriter).
class LabelWriter {
 public:
  LabelWriter() = default;
  LabelWriter(const LabelWriter&) = delete;
  LabelWriter& operator=(const LabelWriter&) = delete;
  virtual ~LabelWriter();

  /// @param parameters  the writer's own; errors in them are noted there
  /// @throws Error if called twice, or with the message of what the writer throws
  void initialize(WriterParameters& parameters, const DatasetInfo& dataset);

  /// The data that has to be computed for this writer, the same in each call.
  /// @throws Error before `initialize`, or with the message of what the writer throws
  [[nodiscard]] Requirements requirements() const;

  /// Passes the writer a scene that has everything `requirements` asks for.
  /// @param output  receives the scene's files, which the core writes
  /// @throws Error before `initialize`, or with the message of what the writer throws
  void writeScene(const Scene& scene, SceneOutput& output) const;

  /// Asks for the files of the dataset as a whole. Not called for a shard; merging the shards calls
  /// it for all of their scenes.
  /// @param records  what `writeScene` recorded of each scene, in this run or an earlier one
  /// @throws Error before `initialize`, or with the message of what the writer throws
  void finalize(const SceneRecords& records, DatasetOutput& output) const;

 private:
  /// Reads the writer's parameters. Errors noted in `parameters` need not be thrown again.
  virtual void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset);

  virtual Requirements doRequirements() const;

  /// Adds the scene's files to `output`. The only method that every writer must implement.
  virtual void doWriteScene(const Scene& scene, SceneOutput& output) const = 0;

  /// Adds the files of the whole dataset to `output`.
  virtual void doFinalize(const SceneRecords& records, DatasetOutput& output) const;

  std::string name_;
  bool initialized_ = false;
};

}  // namespace v2
}  // namespace synthetic_dataset
