#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset {
inline namespace v2 {

/// A file at a place of the user's choice, which a writer reads with WriterParameters::requiredFile
/// and hands to DatasetOutput::addFileAtParameter.
class FileParameter {
 public:
  /// One that no parameter has named, and that cannot be written.
  FileParameter() = default;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  friend class WriterParameters;
  explicit FileParameter(std::string path) : path_(std::move(path)) {}

  std::string path_;
};

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

  /// An image file; the path's extension chooses the format (png, jpg, tiff).
  /// Pixels given more than once in a scene, by whichever writer, are encoded once and linked, so
  /// pass the scene's own cv::Mat rather than a copy.
  /// @param image  CV_8UC1, CV_16UC1, CV_8UC3 (blue, green, red) or, as tiff, CV_32FC1; not changed
  ///     afterwards
  virtual void addImage(const std::string& path, const cv::Mat& image) = 0;

  /// A mask as an image of 255 on the object and 0 elsewhere, of the size of the mask's image. The
  /// image is made when it is encoded, so that many of them take little memory.
  virtual void addMask(const std::string& path, const Mask& mask) = 0;

  /// A PNG whose pixels are indices of a table of colours, as segmentation datasets have it:
  /// loaders read the numbers, people see the colours.
  /// @param path  ends in .png
  /// @param indices  CV_8UC1, each below the number of colours
  /// @param palette  1 to 256 colours: blue, green, red
  virtual void addIndexedImage(const std::string& path, const cv::Mat& indices,
                               const std::vector<cv::Vec3b>& palette) = 0;

  /// A text file, its bytes as given.
  virtual void addText(const std::string& path, std::string text) = 0;

  /// Something that the writer needs again in `finalize`: it is kept with the scene in the manifest
  /// and handed back in scene order. A writer holds no state from one scene to the next.
  /// @param channel  which of the writer's records it belongs to: "images", "val"; without newlines
  /// @param record  any bytes
  virtual void addRecord(const std::string& channel, std::string record) = 0;

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

  /// Calls `visit` for each record of a channel, in scene order and, in a scene, in the order of
  /// adding. May be called more than once; holds one record in memory at a time.
  virtual void forEach(const std::string& channel,
                       const std::function<void(std::int64_t scene_index,
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

  /// The same of a content that is there as a whole.
  void addText(const std::string& path, const std::string& text);

  /// A file at the place that the user gave in a parameter of this writer, inside its folder or
  /// not: the only way out of the folder, and only the user opens it.
  /// @param file  as this writer has read it
  virtual void addFileAtParameter(const FileParameter& file, const Content& content) = 0;

  /// A file in the writer's folder that a library writes by itself, given a name.
  /// @param write  is to make the file of the name that it is given, which is not `path`
  virtual void addFileByName(const std::string& path,
                             const std::function<void(const std::string& file)>& write) = 0;

  /// One more name for a file that this writer made for a scene: for formats that number their
  /// files without gaps, which only the end of a dataset knows.
  virtual void addLink(const std::string& path, const std::string& scene_file) = 0;

  /// The content of a file that this writer made for a scene.
  [[nodiscard]] virtual std::string readFile(const std::string& scene_file) const = 0;
};

}  // namespace v2
}  // namespace synthetic_dataset
