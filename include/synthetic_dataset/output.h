#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset {
inline namespace v1 {

/// Takes the files that a writer wants for one scene; the core makes them.
///
/// Paths are relative to the writer's output folder, with `/` between their parts, and cannot leave
/// it. Nothing is written before `writeScene` has returned; then all the files of the scene appear,
/// or none. Used from the thread that called `writeScene`, and not after it has returned.
///
/// Every method throws Error for a path that is empty, absolute, leads out of the folder or was
/// already used for this scene.
class SceneOutput {
 public:
  SceneOutput() = default;
  SceneOutput(const SceneOutput&) = delete;
  SceneOutput& operator=(const SceneOutput&) = delete;
  virtual ~SceneOutput();

  /// An image file; the path's extension chooses the format (png, jpg).
  /// Pixels given more than once in a scene, by whichever writer, are encoded once and linked, so
  /// pass the scene's own cv::Mat rather than a copy.
  /// @param image  CV_8UC1, CV_16UC1 or CV_8UC3 (blue, green, red); not changed afterwards
  virtual void addImage(const std::string& path, const cv::Mat& image) = 0;

  /// A text file, its bytes as given.
  virtual void addText(const std::string& path, std::string text) = 0;

  /// Something that the writer needs again in `finalize`: it is kept with the scene in the manifest
  /// and handed back in scene order. A writer holds no state from one scene to the next.
  virtual void addRecord(std::string record) = 0;

  /// Something that the user should know about this scene ("alpha: a keypoint is behind the
  /// camera"); shown once a kind, counted in the summary.
  /// @param kind  the same text for all warnings to be counted together
  virtual void addWarning(const std::string& kind) = 0;
};

/// What a writer kept with `addRecord`, scene by scene.
class SceneRecords {
 public:
  SceneRecords() = default;
  SceneRecords(const SceneRecords&) = delete;
  SceneRecords& operator=(const SceneRecords&) = delete;
  virtual ~SceneRecords();

  /// Calls `visit` for each record, in scene order and, in a scene, in the order of adding.
  /// May be called more than once; holds one record in memory at a time.
  virtual void forEach(const std::function<void(std::int64_t scene_index,
                                                const std::string& record)>& visit) const = 0;
};

/// Takes the files that belong to a dataset as a whole. Paths as in SceneOutput.
class DatasetOutput {
 public:
  /// Writes a file's content to the stream, piece by piece.
  using Content = std::function<void(std::ostream&)>;

  DatasetOutput() = default;
  DatasetOutput(const DatasetOutput&) = delete;
  DatasetOutput& operator=(const DatasetOutput&) = delete;
  virtual ~DatasetOutput();

  /// A file in the writer's folder.
  virtual void addFile(const std::string& path, const Content& content) = 0;

  /// A file at the place that the user gave in a parameter of this writer, inside its folder or
  /// not: the only way out of the folder, and only the user opens it.
  /// @param parameter  the name of a parameter that was read with WriterParameters::requiredFile
  virtual void addFileAtParameter(const std::string& parameter, const Content& content) = 0;
};

}  // namespace v1
}  // namespace synthetic_dataset
