/// The tool `contact_sheet`: a picture of every model below a folder, or of a world and every model
/// in it, and a table of what was found in each.
///
///   rosrun synthetic_dataset contact_sheet FOLDER SHEET.png
///   rosrun synthetic_dataset contact_sheet FILE.world SHEET.png
///
/// Exit code 0 if every model could be loaded, 3 if some could not, 1 or 2 for other errors.

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "base/printable_text.h"
#include "programs/gallery/model_gallery.h"
#include "run/setup/package_index.h"
#include "synthetic_dataset/errors.h"
#include "world/files/model_folders.h"

namespace {

using namespace synthetic_dataset;
namespace fs = std::filesystem;

const cv::Size kCell(256, 192);

constexpr const char* kUsage =
    R"(usage: contact_sheet FOLDER SHEET.png
       contact_sheet WORLD SHEET.png

Draws a picture of every model below a folder, or of a world and every model in it, and
prints a table of what was found in each.

  --help  prints this

  contact_sheet ~/.gazebo/models models.png

Exit codes: 0 every model could be loaded, 3 some could not, 1 or 2 for other errors.
)";

std::vector<programs::GalleryEntry> portrayFolder(const fs::path& folder,
                                                  const run::RosPackageIndex& packages) {
  const std::vector<fs::path> models = world::findModels(folder);
  if (models.empty()) {
    throw Error(folder.string() + ": found no model: no model.config, .sdf or .urdf file");
  }
  const world::ResourceFinder finder(programs::modelFolders(folder, models), packages.finder(),
                                     packages.exports());
  std::vector<programs::GalleryEntry> entries;
  for (const fs::path& model : models) {
    const fs::path name = model == folder ? model.filename() : model.lexically_relative(folder);
    entries.push_back(programs::portrayModel(model, name.string(), finder, kCell));
  }
  return entries;
}

int makeContactSheet(const fs::path& given, const std::string& picture) {
  const fs::path path = fs::weakly_canonical(given);
  const run::RosPackageIndex packages;
  std::vector<programs::GalleryEntry> entries;
  if (fs::is_regular_file(path)) {
    const world::ResourceFinder finder({path.parent_path().string()}, packages.finder(),
                                       packages.exports());
    entries = programs::portrayWorld(path, finder, kCell);
  } else {
    entries = portrayFolder(path, packages);
  }
  if (!cv::imwrite(picture, programs::contactSheet(entries, kCell))) {
    throw Error(picture + ": cannot be written");
  }
  std::cout << base::printable(programs::galleryTable(entries));
  for (const std::string& note : packages.notes()) std::cout << base::printable(note) << '\n';
  const bool all_loaded =
      std::all_of(entries.begin(), entries.end(),
                  [](const programs::GalleryEntry& e) { return e.error.empty(); });
  return all_loaded ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--help" || first == "-h") {
    std::cout << kUsage;
    return 0;
  }
  if (argc != 3) {
    std::cerr << kUsage;
    return 2;
  }
  try {
    return makeContactSheet(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << "contact_sheet: " << base::printable(error.what()) << '\n';
    return 1;
  }
}
