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

/// A file at a path that the user chose, which a writer reads with WriterParameters::requiredFile
/// and passes to DatasetOutput::addFileAtParameter.
class FileParameter {
 public:
  /// A file that no parameter has named and that cannot be written.
  FileParameter() = default;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  friend class WriterParameters;
  explicit FileParameter(std::string path) : path_(std::move(path)) {}

  std::string path_;
};

/// Receives the files of one scene from a writer; the core writes them.
///
/// Paths are relative to the writer's output folder, with `/` between their parts, and cannot leave
/// it. Nothing is written before `writeScene` has returned; then all the files of the scene appear,
/// or none. To be used only from the thread that called `writeScene`, and only until it returns.
///
/// Every method throws Error for a path that is empty, absolute, leads out of the folder or was
/// already used for this scene.
class SceneOutput {
 public:
  SceneOutput() = default;
  SceneOutput(const SceneOutput&) = delete;
  SceneOutput& operator=(const SceneOutput&) = delete;
  virtual ~SceneOutput();

  /// Adds an image file; the path's extension chooses the format (png, jpg, tiff).
  /// Pixels that any writers add more than once in a scene are encoded once and linked, so pass the
  /// scene's own cv::Mat rather than a copy.
  /// @param image  CV_8UC1, CV_16UC1, CV_8UC3 (blue, green, red) or, as tiff, CV_32FC1; must not be
  ///     changed afterwards
  virtual void addImage(const std::string& path, const cv::Mat& image) = 0;

  /// Adds a mask as an image of the mask's image size, 255 on the object and 0 elsewhere. The image
  /// is made only when it is encoded, so that many masks take little memory.
  virtual void addMask(const std::string& path, const Mask& mask) = 0;

  /// Adds a PNG whose pixels are indices into a colour table, as in segmentation datasets: loaders
  /// read the indices, people see the colours.
  /// @param path  ends in .png
  /// @param indices  CV_8UC1, each below the number of colours
  /// @param palette  1 to 256 colours: blue, green, red
  virtual void addIndexedImage(const std::string& path, const cv::Mat& indices,
                               const std::vector<cv::Vec3b>& palette) = 0;

  /// Adds a text file; its bytes are written as given.
  virtual void addText(const std::string& path, std::string text) = 0;

  /// Records something that the writer needs again in `finalize`, as it keeps no state from one
  /// scene to the next: it is stored with the scene in the manifest and returned in scene order.
  /// @param channel  the group of the writer's records that it belongs to, such as "images" or
  ///     "val"; without newlines
  /// @param record  any bytes
  virtual void addRecord(const std::string& channel, std::string record) = 0;

  /// Warns the user of something about this scene ("alpha: a keypoint is behind the camera"); shown
  /// once per kind and counted in the summary.
  /// @param kind  the text, the same for all warnings that are counted together
  virtual void addWarning(const std::string& kind) = 0;
};

/// The records that a writer added with `addRecord`, scene by scene.
class SceneRecords {
 public:
  SceneRecords() = default;
  SceneRecords(const SceneRecords&) = delete;
  SceneRecords& operator=(const SceneRecords&) = delete;
  virtual ~SceneRecords();

  /// Calls `visit` for each record of a channel, in scene order and, within a scene, in the order
  /// added. May be called more than once; holds one record in memory at a time.
  virtual void forEach(const std::string& channel,
                       const std::function<void(std::int64_t scene_index,
                                                const std::string& record)>& visit) const = 0;
};

/// Receives the files that belong to a dataset as a whole. Paths are as in SceneOutput.
class DatasetOutput {
 public:
  /// Writes a file's content to the stream, piece by piece.
  using Content = std::function<void(std::ostream&)>;

  DatasetOutput() = default;
  DatasetOutput(const DatasetOutput&) = delete;
  DatasetOutput& operator=(const DatasetOutput&) = delete;
  virtual ~DatasetOutput();

  /// Adds a file in the writer's folder.
  virtual void addFile(const std::string& path, const Content& content) = 0;

  /// Adds a file in the writer's folder whose content is already complete.
  void addText(const std::string& path, const std::string& text);

  /// Adds a file at the path that the user gave in a parameter of this writer, inside its folder or
  /// not: the only way out of the folder, which only the user can open.
  /// @param file  as read by this writer
  virtual void addFileAtParameter(const FileParameter& file, const Content& content) = 0;

  /// Adds a file in the writer's folder that is written by a library that needs a file name.
  /// @param write  creates the file under the name that it receives, which is not `path`
  virtual void addFileByName(const std::string& path,
                             const std::function<void(const std::string& file)>& write) = 0;

  /// Adds another name for a file that this writer added for a scene: for formats that number their
  /// files without gaps, as the numbers are not known before the end of the dataset.
  virtual void addLink(const std::string& path, const std::string& scene_file) = 0;

  /// The content of a file that this writer added for a scene.
  [[nodiscard]] virtual std::string readFile(const std::string& scene_file) const = 0;
};

}  // namespace v2
}  // namespace synthetic_dataset
