#include "world/files/model_folders.h"

#include <set>
#include <system_error>
#include <utility>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

bool isModelFile(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".sdf" || extension == ".urdf";
}

bool isModelFolder(const fs::path& folder) {
  return fs::exists(folder / "model.config") || fs::exists(folder / "manifest.xml");
}

/// Searches depth first and in sorted order; everything in a model's folder belongs to that model.
/// Symbolic links are followed, but each folder is visited only once, as links may form cycles.
class ModelSearch {
 public:
  void look(const fs::path& folder) {
    std::error_code error;
    if (!seen_.insert(fs::canonical(folder, error)).second) return;
    if (fs::exists(folder / "model.config", error)) {
      models.push_back(folder);
      return;
    }
    std::set<fs::path> entries;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
      entries.insert(entry->path());
    }
    for (const fs::path& entry : entries) {
      if (fs::is_directory(entry, error)) {
        look(entry);
      } else if (isModelFile(entry)) {
        models.push_back(entry);
      }
    }
  }

  std::vector<fs::path> models;

 private:
  std::set<fs::path> seen_;
};

}  // namespace

std::vector<fs::path> findModels(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw Error(folder.string() + ": no such folder");
  ModelSearch search;
  search.look(folder);
  return std::move(search.models);
}

std::vector<std::string> modelsAt(const std::string& path_or_uri) {
  std::error_code ignored;
  if (!fs::is_directory(path_or_uri, ignored) || isModelFolder(path_or_uri)) return {path_or_uri};
  std::vector<std::string> models;
  for (const fs::path& model : findModels(path_or_uri)) models.push_back(model.string());
  if (models.empty()) {
    throw Error(
        "found '" + path_or_uri +
        "', a folder that is not a model (it has no model.config) and contains none; it should "
        "be a model, or hold folders with a model.config, .sdf or .urdf files");
  }
  return models;
}

}  // namespace synthetic_dataset::world
