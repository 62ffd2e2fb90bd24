#include "output/unfinished_scenes.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "output/files/digest.h"
#include "output/files/pending_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

void removeFile(const std::string& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR) {
    throw Error("cannot remove '" + path + "': " + std::generic_category().message(errno));
  }
}

void removeFiles(const std::vector<ManifestFile>& files) {
  for (const ManifestFile& file : files) {
    removeFile(file.path);
    removeFile(temporaryPath(file.path));
  }
}

bool isAsWritten(const ManifestFile& file) {
  try {
    const FileDigest found = digestOfFile(file.path);
    return found.bytes == file.bytes && found.digest == file.digest;
  } catch (const Error&) {
    return false;  // it is not there
  }
}

/// Without reading it: files that were safe on the disk change only when somebody changes them.
bool hasItsSize(const ManifestFile& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file.path, error);
  return !error && static_cast<std::int64_t>(size) == file.bytes;
}

bool isWhole(SceneState state, const std::vector<ManifestFile>& files) {
  if (state == SceneState::kBegun) return false;
  return std::all_of(files.begin(), files.end(),
                     state == SceneState::kComplete ? hasItsSize : isAsWritten);
}

}  // namespace

void dropUnfinished(Manifest& manifest) {
  for (const auto& [scene, state] : manifest.sceneStates()) {
    const std::vector<ManifestFile> files = manifest.filesOfScene(scene);
    if (isWhole(state, files)) continue;
    removeFiles(files);
    manifest.withdrawScene(scene);
  }
  for (const ManifestFile& file : manifest.filesOfScene(std::nullopt)) {
    removeFiles({file});
    manifest.withdraw(file.path);
  }
}

}  // namespace synthetic_dataset::output
