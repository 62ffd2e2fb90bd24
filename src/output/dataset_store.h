#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "synthetic_dataset/output.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::output {

/// What to do with a dataset that is already there.
enum class IfExists {
  kError,      ///< refuse: nothing already made is lost
  kOverwrite,  ///< remove the files that its manifest lists, and nothing else
};

struct StoreOptions {
  std::string folder;  ///< of the manifest, absolute
  IfExists if_exists = IfExists::kError;
  int png_compression = 3;  ///< 0 fastest .. 9 smallest
  int jpeg_quality = 95;    ///< 1 .. 100
};

/// A writer as the store knows it.
struct StoreWriter {
  std::string name;
  std::string type;
  std::string output_folder;            ///< absolute, ending in `/`
  std::vector<std::string> user_files;  ///< absolute paths of files that it makes anywhere else
};

/// A file that one scene or the dataset gets: either pixels or text.
struct OutputFile {
  std::size_t writer = 0;  ///< index in the store's writers
  std::string path;        ///< absolute
  cv::Mat pixels;          ///< empty for a text file
  std::string text;
  std::vector<cv::Vec3b> palette = {};  ///< not empty: the pixels are places in it
};

/// All that the writers want for one scene.
struct SceneFiles {
  struct Record {
    std::size_t writer = 0;  ///< index in the store's writers
    std::string text;
  };
  std::vector<OutputFile> files;
  std::vector<Record> records;
  std::string camera = "camera";  ///< the name of the scene's camera
};

struct StoreCounts {
  std::int64_t scenes = 0;
  std::int64_t files = 0;
  std::int64_t bytes = 0;  ///< as encoded; a linked file counts once
};

/// The dataset on disk: files that appear whole or not at all, and the manifest that lists them.
class DatasetStore {
 public:
  /// Checks every folder and file for being writable, deals with what is there (`if_exists`) and
  /// starts the manifest.
  /// @throws ErrorList with all that stands in the way: a folder that cannot be made, files of an
  ///     earlier run, two writers with the same folder (or one inside another's)
  DatasetStore(const StoreOptions& options, std::vector<StoreWriter> writers);
  ~DatasetStore();
  DatasetStore(const DatasetStore&) = delete;
  DatasetStore& operator=(const DatasetStore&) = delete;

  /// Encodes (equal pixels once), writes, links, and then lists the scene in the manifest.
  /// @throws Error: what could not be written and why (a full disk, ...); the scene does not count
  void commitScene(std::int64_t index, Stamp stamp, const SceneFiles& files);

  /// Writes one file of a dataset as a whole, streaming.
  void writeDatasetFile(std::size_t writer, const std::string& path,
                        const DatasetOutput::Content& content);

  /// The same of a file that `write` makes, given the name of one that does not exist yet.
  void writeDatasetFileByName(std::size_t writer, const std::string& path,
                              const std::function<void(const std::string& file)>& write);

  /// Gives a file of a scene one more name.
  /// @throws Error where `scene_file` is no file that this writer made for a scene
  void linkDatasetFile(std::size_t writer, const std::string& path, const std::string& scene_file);

  /// The content of a file of a scene.
  /// @throws Error as linkDatasetFile does
  [[nodiscard]] std::string readSceneFile(std::size_t writer, const std::string& scene_file) const;

  /// The records of one writer, in scene order.
  [[nodiscard]] std::unique_ptr<SceneRecords> records(std::size_t writer) const;

  /// Marks the run as complete: what reads the manifest may rely on it.
  void complete();

  [[nodiscard]] const StoreCounts& counts() const;
  [[nodiscard]] std::string manifestPath() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::output
