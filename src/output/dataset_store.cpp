#include "output/dataset_store.h"

#include <filesystem>
#include <utility>

#include "output/earlier_dataset.h"
#include "output/file_name_rules.h"
#include "output/image_encoder.h"
#include "output/manifest.h"
#include "output/pending_file.h"
#include "output/preflight.h"
#include "output/scene_contents.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::string withoutTrailingSlash(std::string folder) {
  if (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  return folder;
}

void makeFolders(const std::string& folder, const std::vector<StoreWriter>& writers,
                 FolderProbe& probe) {
  probe.tryFolder("the dataset's manifest", folder);
  for (const StoreWriter& writer : writers) {
    const std::string owner = "writer '" + writer.name + "'";
    probe.tryFolder(owner, writer.output_folder);
    for (const std::string& file : writer.user_files) {
      probe.tryFolder(owner, std::filesystem::path(file).parent_path().string());
    }
  }
}

/// Makes sure that the run can begin, and only then removes what it is to replace.
void clearTheWay(const std::string& folder, const std::vector<StoreWriter>& writers,
                 IfExists if_exists) {
  std::vector<std::string> problems = layoutProblems(manifestFile(folder), writers);
  std::optional<EarlierDataset> earlier;
  try {
    earlier.emplace(folder);
    append(problems, earlier->obstacles(writers, if_exists));
  } catch (const Error& error) {
    problems.emplace_back(error.what());
  }
  FolderProbe probe;
  makeFolders(folder, writers, probe);
  append(problems, probe.problems());
  if (!problems.empty()) throw ErrorList(problems);

  earlier->remove();
  makeFolders(folder, writers, probe);  // again: empty ones went with the earlier dataset
  if (!probe.problems().empty()) throw ErrorList(probe.problems());
  probe.keepFolders();
}

/// The files as the manifest lists them, content by content.
std::vector<ManifestFile> manifestFiles(const std::vector<OutputFile>& files,
                                        const std::vector<SceneContent>& contents) {
  std::vector<ManifestFile> listed;
  for (const SceneContent& content : contents) {
    const auto bytes = static_cast<std::int64_t>(content.bytes().size());
    const std::size_t first = content.files.front();
    for (const std::size_t i : content.files) {
      ManifestFile file{files[i].path, files[i].writer, bytes, std::nullopt};
      if (i != first) file.linked_to = files[first].path;
      listed.push_back(std::move(file));
    }
  }
  return listed;
}

/// Writes all files before the first one gets its name.
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

void withdrawAfterFailure(Manifest& manifest, const std::vector<ManifestFile>& files) {
  try {
    manifest.withdraw(files);
  } catch (const Error&) {
    // The first failure is the one to be told. Rows of files that are not there do no harm.
  }
}

}  // namespace

struct DatasetStore::Impl {
  std::string folder;
  ImageQuality quality;
  std::vector<StoreWriter> writers;
  Manifest manifest;
  StoreCounts counts;

  Impl(const StoreOptions& options, const std::string& manifest_folder,
       std::vector<StoreWriter> store_writers)
      : folder(manifest_folder),
        quality{options.png_compression, options.jpeg_quality},
        writers(std::move(store_writers)),
        manifest(folder, writers) {}

  void count(const std::vector<ManifestFile>& files) {
    for (const ManifestFile& file : files) {
      ++counts.files;
      if (!file.linked_to) counts.bytes += file.bytes;
    }
  }

  void requireSceneFile(std::size_t writer, const std::string& path) {
    if (manifest.isSceneFile(writer, path)) return;
    throw Error("'" + path + "' is no file that the writer '" + writers[writer].name +
                "' made for a scene");
  }

  /// @param make  makes the pending file of a path
  template <class Make>
  void addDatasetFile(ManifestFile file, const Make& make) {
    manifest.announce(std::nullopt, {file});
    try {
      PendingFile pending = make(file.path);
      pending.publish();
      file.bytes = pending.size();
      manifest.setBytes(file.path, file.bytes);
      pending.keep();
    } catch (...) {
      withdrawAfterFailure(manifest, {file});
      throw;
    }
    count({file});
  }
};

DatasetStore::DatasetStore(const StoreOptions& options, std::vector<StoreWriter> writers) {
  const std::string folder = withoutTrailingSlash(absolutePath(options.folder));
  for (StoreWriter& writer : writers) {
    writer.output_folder = withoutTrailingSlash(absolutePath(writer.output_folder)) + "/";
    for (std::string& file : writer.user_files) file = absolutePath(file);
  }
  clearTheWay(folder, writers, options.if_exists);
  impl_ = std::make_unique<Impl>(options, folder, std::move(writers));
}

DatasetStore::~DatasetStore() = default;

void DatasetStore::commitScene(std::int64_t index, Stamp stamp, const SceneFiles& files) {
  try {
    const std::vector<SceneContent> contents = encodeScene(files.files, impl_->quality);
    const std::vector<ManifestFile> listed = manifestFiles(files.files, contents);
    impl_->manifest.announce(index, listed);
    try {
      std::vector<PendingFile> pending = publish(files.files, contents);
      impl_->manifest.listScene(index, stamp, files);
      for (PendingFile& file : pending) file.keep();
    } catch (...) {
      withdrawAfterFailure(impl_->manifest, listed);
      throw;
    }
    ++impl_->counts.scenes;
    impl_->count(listed);
  } catch (const Error& error) {
    throw Error("scene " + std::to_string(index) + ": " + error.what());
  }
}

void DatasetStore::writeDatasetFile(std::size_t writer, const std::string& path,
                                    const DatasetOutput::Content& content) {
  impl_->addDatasetFile(
      {absolutePath(path), writer, 0, std::nullopt},
      [&](const std::string& file) { return PendingFile::withContent(file, content); });
}

void DatasetStore::writeDatasetFileByName(
    std::size_t writer, const std::string& path,
    const std::function<void(const std::string& file)>& write) {
  impl_->addDatasetFile(
      {absolutePath(path), writer, 0, std::nullopt},
      [&](const std::string& file) { return PendingFile::writtenBy(file, write); });
}

void DatasetStore::linkDatasetFile(std::size_t writer, const std::string& path,
                                   const std::string& scene_file) {
  const std::string original = absolutePath(scene_file);
  impl_->requireSceneFile(writer, original);
  impl_->addDatasetFile({absolutePath(path), writer, 0, original}, [&](const std::string& file) {
    return PendingFile::linkedToFile(original, file);
  });
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

  void forEach(const std::function<void(std::int64_t, const std::string&)>& visit) const override {
    manifest_.forEachRecord(writer_, visit);
  }

 private:
  const Manifest& manifest_;
  std::size_t writer_;
};

}  // namespace

std::unique_ptr<SceneRecords> DatasetStore::records(std::size_t writer) const {
  return std::make_unique<ManifestRecords>(impl_->manifest, writer);
}

void DatasetStore::complete() { impl_->manifest.setComplete(); }

const StoreCounts& DatasetStore::counts() const { return impl_->counts; }

std::string DatasetStore::manifestPath() const { return manifestFile(impl_->folder); }

}  // namespace synthetic_dataset::output
