#include "output/preflight.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "output/files/file_name_rules.h"

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProbe = ".synthetic_dataset_probe_";  // prefix of the names of probe files

/// Resolves symbolic links as far as the path exists; without a trailing `/`.
std::string realPath(const std::string& path) {
  std::error_code error;
  std::string real = fs::weakly_canonical(path, error).string();
  if (error) real = path;
  if (real.size() > 1 && real.back() == '/') real.pop_back();
  return real;
}

std::string named(const StoreWriter& writer) { return "writer '" + writer.name + "'"; }

void compareFolders(const StoreWriter& one, const StoreWriter& other,
                    std::vector<std::string>& problems) {
  const std::string folder = realPath(one.output_folder);
  const std::string other_folder = realPath(other.output_folder);
  if (folder == other_folder) {
    problems.push_back(named(one) + " and " + named(other) + " have the same output_folder '" +
                       one.output_folder + "'; each writer should have a folder of its own");
    return;
  }
  const bool other_inside = liesWithin(other_folder, folder);
  if (!other_inside && !liesWithin(folder, other_folder)) return;
  const StoreWriter& inner = other_inside ? other : one;
  const StoreWriter& outer = other_inside ? one : other;
  problems.push_back(named(inner) + ": the output_folder '" + inner.output_folder +
                     "' lies inside the folder '" + outer.output_folder + "' of " + named(outer) +
                     "; the folders of two writers should be side by side");
}

struct UserFile {
  const StoreWriter* writer;
  std::string path;
};

void compareUserFiles(const std::string& manifest_file, const std::vector<UserFile>& files,
                      std::vector<std::string>& problems) {
  const std::string real_manifest = realPath(manifest_file);
  for (auto file = files.begin(); file != files.end(); ++file) {
    const std::string real_file = realPath(file->path);
    if (real_file == real_manifest) {
      problems.push_back(named(*file->writer) + ": '" + file->path +
                         "' is the place of the dataset's manifest; choose another name");
    }
    for (auto other = files.begin(); other != file; ++other) {
      if (realPath(other->path) != real_file) continue;
      problems.push_back(named(*other->writer) + " and " + named(*file->writer) +
                         " would both write the file '" + file->path + "'; choose different names");
    }
  }
}

/// Makes a temporary file. @return 0, or the errno value if none can be made
int tryFile(const std::string& folder) {
  // Unnamed, so that nothing is left behind even if the process is killed.
  int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  const bool is_known = descriptor >= 0 || (errno != EOPNOTSUPP && errno != EISDIR &&
                                            errno != EINVAL && errno != ENOENT);
  if (!is_known) {
    // Not supported by this file system. Use a unique name, since other runs may be starting here
    // right now.
    std::string probe = (fs::path(folder) / kProbe).string() + "XXXXXX";
    descriptor = ::mkstemp(probe.data());
    if (descriptor >= 0) ::unlink(probe.c_str());
  }
  if (descriptor < 0) return errno;
  ::close(descriptor);
  return 0;
}

}  // namespace

std::vector<std::string> layoutProblems(const std::string& manifest_file,
                                        const std::vector<StoreWriter>& writers) {
  std::vector<std::string> problems;
  std::vector<UserFile> user_files;
  for (auto writer = writers.begin(); writer != writers.end(); ++writer) {
    for (auto other = writers.begin(); other != writer; ++other) {
      compareFolders(*other, *writer, problems);
    }
    for (const std::string& file : writer->user_files) user_files.push_back({&*writer, file});
  }
  compareUserFiles(manifest_file, user_files, problems);
  return problems;
}

FolderProbe::~FolderProbe() {
  // rmdir(2) leaves a folder alone if something has been put into it meanwhile.
  std::for_each(made_.rbegin(), made_.rend(),
                [](const std::string& folder) { ::rmdir(folder.c_str()); });
}

void FolderProbe::tryFolder(const std::string& owner, const std::string& folder) {
  std::error_code error;
  std::vector<std::string> missing;  // the innermost first
  for (fs::path path = fs::path(folder) / ""; path.has_relative_path();) {
    path = path.parent_path();
    if (fs::exists(path, error)) break;
    missing.push_back(path.string());
  }
  fs::create_directories(folder, error);
  const std::string reason = error ? error.message() : "";
  std::copy_if(missing.rbegin(), missing.rend(), std::back_inserter(made_),
               [&](const std::string& path) { return fs::is_directory(path, error); });
  if (!reason.empty()) {
    problems_.push_back(owner + ": cannot make the folder '" + folder + "': " + reason);
    return;
  }
  if (const int failure = tryFile(folder)) {
    problems_.push_back(owner + ": files cannot be made in the folder '" + folder +
                        "': " + std::generic_category().message(failure));
  }
}

bool FolderProbe::isProbe(const std::string& path) {
  return fs::path(path).filename().string().rfind(kProbe, 0) == 0;
}

}  // namespace synthetic_dataset::output
