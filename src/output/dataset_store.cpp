#include "output/dataset_store.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

#include "base/image/image_encoder.h"
#include "output/dataset_opening.h"
#include "output/files/digest.h"
#include "output/files/file_name_rules.h"
#include "output/files/pending_file.h"
#include "output/scene_contents.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// The files as the manifest lists them, content by content.
std::vector<ManifestFile> manifestFiles(const std::vector<OutputFile>& files,
                                        const std::vector<SceneContent>& contents) {
  std::vector<ManifestFile> listed;
  for (const SceneContent& content : contents) {
    const auto bytes = static_cast<std::int64_t>(content.bytes().size());
    const std::string digest = digestOf(content.bytes());
    const std::size_t first = content.files.front();
    for (const std::size_t i : content.files) {
      ManifestFile file{files[i].path, files[i].writer, bytes, digest, std::nullopt};
      if (i != first) file.linked_to = files[first].path;
      listed.push_back(std::move(file));
    }
  }
  return listed;
}

/// What the manifest records about depth as integers, in case a picture stores it that way. The
/// finer unit is left out if all 16-bit pictures are depth in millimetres.
std::vector<PictureFacts> wholeDepthFacts(const cv::Mat& depth,
                                          const std::vector<OutputFile>& files) {
  constexpr double kMillimetres = 1000.0;
  constexpr double kTenths = 10000.0;  // tenths of a millimetre
  std::vector<const cv::Mat*> pictures;
  for (const OutputFile& file : files) {
    if (file.pixels.type() == CV_16UC1) pictures.push_back(&file.pixels);
  }
  if (pictures.empty()) return {};
  const cv::Mat numbers = depthNumbers(depth, kMillimetres);
  std::vector<PictureFacts> facts = {{"depth.0.001", digestOfPixels(numbers), {}}};
  const bool are_all = std::all_of(pictures.begin(), pictures.end(), [&](const cv::Mat* picture) {
    return picture->size() == numbers.size() && cv::norm(*picture, numbers, cv::NORM_INF) == 0.0;
  });
  // If there is no depth at all, both units give the same picture.
  if (are_all && cv::countNonZero(numbers) > 0) return facts;
  facts.push_back({"depth.0.0001", digestOfPixels(depthNumbers(depth, kTenths)), {}});
  return facts;
}

/// What the manifest records about the scene's own pictures: facts about their pixels, and about
/// the JPEG files made of them, whose decoded pixels no longer show where they came from.
std::vector<PictureFacts> pictureFactsOf(const SceneFacts& scene,
                                         const std::vector<OutputFile>& files,
                                         const std::vector<SceneContent>& contents) {
  std::vector<PictureFacts> facts;
  for (const auto& [name, pixels] : scene.pictures) {
    facts.push_back(pictureFacts(name, pixels));
    if (name == "normals") {
      facts.push_back({"normals.colours", digestOfPixels(normalColours(pixels)), {}});
    }
    if (name == "depth") {
      std::vector<PictureFacts> whole = wholeDepthFacts(pixels, files);
      facts.insert(facts.end(), whole.begin(), whole.end());
    }
    const auto isJpeg = [&, picture = pixels](std::size_t i) {
      return files[i].pixels.data == picture.data && files[i].pixels.size() == picture.size() &&
             base::imageFormat(files[i].path) == base::ImageFormat::kJpeg;
    };
    const auto jpeg =
        std::find_if(contents.begin(), contents.end(), [&](const SceneContent& content) {
          return std::any_of(content.files.begin(), content.files.end(), isJpeg);
        });
    if (jpeg != contents.end()) facts.push_back({name + ".jpg", digestOf(jpeg->bytes()), {}});
  }
  return facts;
}

/// Writes all files before the first one receives its final name.
std::vector<PendingFile> publish(const std::vector<OutputFile>& files,
                                 const std::vector<SceneContent>& contents) {
  std::vector<PendingFile> pending;
  pending.reserve(files.size());
  for (const SceneContent& content : contents) {
    const std::size_t first = pending.size();
    for (const std::size_t i : content.files) {
      const std::string& path = files[i].path;
      pending.push_back(i == content.files.front()
                            ? PendingFile::withBytes(path, content.bytes())
                            : PendingFile::linkedTo(pending[first], path, content.bytes()));
    }
  }
  for (PendingFile& file : pending) file.publish();
  return pending;
}

/// @param withdraw  takes back what was announced to the manifest
template <class Withdraw>
void withdrawAfterFailure(const Manifest& manifest, const Withdraw& withdraw) {
  // If the folder was moved, files may have moved with it, and the manifest must still list them.
  if (!manifest.isInPlace()) return;
  try {
    withdraw();
  } catch (const std::exception&) {
    // Only the first failure is to be reported. Rows of files that do not exist do no harm.
  }
}

}  // namespace

struct DatasetStore::Impl {
  StoreOptions options;
  std::vector<StoreWriter> writers;
  OpenedDataset opened;
  Manifest* manifest;                ///< null if the dataset was already complete
  std::vector<bool> scenes;          ///< by scene index: whether the scene is there
  std::int64_t unsynced_scenes = 0;  ///< written since the last flush

  Impl(const StoreOptions& store_options, std::vector<StoreWriter> store_writers,
       const RunDescription& run)
      : options(store_options),
        writers(std::move(store_writers)),
        opened(openDataset(options, writers, run)),
        manifest(opened.manifest.get()) {
    if (manifest == nullptr) return;
    for (const auto& [index, state] : manifest->sceneStates()) {
      know(index);
      if (state == SceneState::kWritten) ++unsynced_scenes;
    }
  }

  void know(std::int64_t scene) {
    const auto place = static_cast<std::size_t>(scene);
    if (place >= scenes.size()) scenes.resize(place + 1, false);
    scenes[place] = true;
  }

  void requireSceneFile(std::size_t writer, const std::string& path) {
    if (manifest->isSceneFile(writer, path)) return;
    throw Error("'" + path + "' is not a file that the writer '" + writers[writer].name +
                "' made for a scene");
  }

  /// Files written without their manifest would be unknown to everybody. Called both before and
  /// after files receive their names: if the manifest was moved in between, the files beside it
  /// moved too.
  void requireManifest() const {
    if (manifest->isInPlace()) return;
    throw Error("the dataset's manifest '" + manifest->file() +
                "' has been removed or replaced while the run was writing");
  }

  [[nodiscard]] std::vector<std::string> folders() const {
    std::vector<std::string> folders = {options.folder};
    for (const StoreWriter& writer : writers) {
      folders.push_back(writer.output_folder);
      for (const std::string& file : writer.user_files) {
        folders.push_back(std::filesystem::path(file).parent_path().string());
      }
    }
    return folders;
  }

  void flush() {
    if (options.sync != Sync::kOff) syncFileSystems(folders());
    // With sync off they will never be safer than now, so this is also reached then.
    manifest->markComplete();
    unsynced_scenes = 0;
  }

  void flushInTime() {
    constexpr std::int64_t kBatch = 64;  // scenes
    const std::int64_t limit = options.sync == Sync::kScene ? 1 : kBatch;
    if (options.sync != Sync::kOff && unsynced_scenes >= limit) flush();
  }

  void place(const std::string& source, const ManifestFile& target) const {
    PendingFile file = PendingFile::linkedToFile(source, target.path);
    if (file.size() != target.bytes) {
      throw Error("'" + source + "' has " + std::to_string(file.size()) + " bytes; its manifest " +
                  "lists " + std::to_string(target.bytes));
    }
    file.publish();
    file.keep();
  }

  /// @param make  makes the pending file for a path
  template <class Make>
  void addDatasetFile(ManifestFile file, const Make& make) {
    requireManifest();
    manifest->announce(file);
    try {
      PendingFile pending = make(file.path);
      const std::string digest = digestOfFile(pending.temporaryName()).digest;
      pending.publish();
      requireManifest();
      manifest->setContent(file.path, pending.size(), digest);
      pending.keep();
    } catch (...) {
      withdrawAfterFailure(*manifest, [&] { manifest->withdraw(file.path); });
      throw;
    }
  }
};

DatasetStore::DatasetStore(const StoreOptions& options, std::vector<StoreWriter> writers,
                           const RunDescription& run) {
  StoreOptions normalized = options;
  makeAbsolute(normalized, writers);
  impl_ = std::make_unique<Impl>(normalized, std::move(writers), run);
}

DatasetStore::~DatasetStore() = default;

bool DatasetStore::wasComplete() const { return impl_->manifest == nullptr; }

bool DatasetStore::hasScene(std::int64_t index) const {
  const auto place = static_cast<std::size_t>(index);
  return place < impl_->scenes.size() && impl_->scenes[place];
}

void DatasetStore::commitScene(const SceneFacts& scene, const SceneFiles& files) {
  try {
    Manifest& manifest = *impl_->manifest;
    impl_->requireManifest();
    const base::ImageQuality quality{impl_->options.png_compression, impl_->options.jpeg_quality};
    const std::vector<SceneContent> contents = encodeScene(files.files, quality, files.recorded);
    manifest.announceScene(scene, manifestFiles(files.files, contents));
    try {
      std::vector<PendingFile> pending = publish(files.files, contents);
      impl_->requireManifest();
      manifest.listScene(scene, pictureFactsOf(scene, files.files, contents), files.records);
      for (PendingFile& file : pending) file.keep();
    } catch (...) {
      withdrawAfterFailure(manifest, [&] { manifest.withdrawScene(scene.index); });
      throw;
    }
    impl_->know(scene.index);
    ++impl_->unsynced_scenes;
    impl_->flushInTime();
  } catch (const Error& error) {
    throw Error("scene " + std::to_string(scene.index) + ": " + error.what());
  }
}

void DatasetStore::recordSkippedScene(const SceneFacts& scene) {
  impl_->requireManifest();
  impl_->manifest->recordSkippedScene(scene);
  impl_->know(scene.index);
  ++impl_->unsynced_scenes;
  impl_->flushInTime();
}

void DatasetStore::mergeShard(const ShardPlace& shard) {
  impl_->manifest->mergeShard(shard.folder, shard.shard,
                              [this](const std::string& source, const ManifestFile& target) {
                                impl_->place(source, target);
                              });
  for (const auto& [index, state] : impl_->manifest->sceneStates()) impl_->know(index);
}

void DatasetStore::writeDatasetFile(std::size_t writer, const std::string& path,
                                    const DatasetOutput::Content& content) {
  impl_->addDatasetFile(
      {absolutePath(path), writer, 0, "", std::nullopt},
      [&](const std::string& file) { return PendingFile::withContent(file, content); });
}

void DatasetStore::writeDatasetFileByName(
    std::size_t writer, const std::string& path,
    const std::function<void(const std::string& file)>& write) {
  impl_->addDatasetFile(
      {absolutePath(path), writer, 0, "", std::nullopt},
      [&](const std::string& file) { return PendingFile::writtenBy(file, write); });
}

void DatasetStore::linkDatasetFile(std::size_t writer, const std::string& path,
                                   const std::string& scene_file) {
  const std::string original = absolutePath(scene_file);
  impl_->requireSceneFile(writer, original);
  impl_->addDatasetFile(
      {absolutePath(path), writer, 0, "", original},
      [&](const std::string& file) { return PendingFile::linkedToFile(original, file); });
}

std::string DatasetStore::readSceneFile(std::size_t writer, const std::string& scene_file) const {
  const std::string file = absolutePath(scene_file);
  impl_->requireSceneFile(writer, file);
  return readWholeFile(file);
}

namespace {

class ManifestRecords : public SceneRecords {
 public:
  ManifestRecords(const Manifest& manifest, std::size_t writer)
      : manifest_(manifest), writer_(writer) {}

  void forEach(const std::string& channel,
               const std::function<void(std::int64_t, const std::string&)>& visit) const override {
    manifest_.forEachRecord(writer_, channel, visit);
  }

 private:
  const Manifest& manifest_;
  std::size_t writer_;
};

}  // namespace

std::unique_ptr<SceneRecords> DatasetStore::records(std::size_t writer) const {
  return std::make_unique<ManifestRecords>(*impl_->manifest, writer);
}

void DatasetStore::flush() { impl_->flush(); }

void DatasetStore::complete(const std::vector<Warning>& warnings) {
  impl_->flush();
  impl_->manifest->finish(warnings);
  if (impl_->options.sync != Sync::kOff) syncFileSystems({impl_->options.folder});
}

StoreCounts DatasetStore::counts() const { return impl_->manifest->counts(); }

std::map<std::string, std::int64_t> DatasetStore::warningCounts() const {
  return impl_->manifest->warningCounts();
}

std::vector<ObjectCounts> DatasetStore::objectCounts() const {
  return impl_->manifest->objectCounts();
}

std::vector<SplitCounts> DatasetStore::splitCounts() const {
  return impl_->manifest->splitCounts();
}

std::string DatasetStore::manifestPath() const { return impl_->opened.file; }

}  // namespace synthetic_dataset::output
