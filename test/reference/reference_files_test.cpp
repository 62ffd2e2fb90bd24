/// All worlds, models and robots of the reference data: each loads as it is, or names files that
/// are really absent, and loads without them. Prints a table.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "reference/reference_folder.h"
#include "reference/reference_worlds.h"
#include "synthetic_dataset/errors.h"
#include "world/world_loader.h"

namespace synthetic_dataset {
namespace reference_files_test {

namespace fs = std::filesystem;

using testing::AnyOf;
using testing::Each;
using testing::HasSubstr;

/// Files whose end is missing, which no parser accepts.
bool isTorn(const std::string& file) {
  const std::string name = fs::path(file).parent_path().filename().string();
  return name == "green_ball" || name == "hospital_map" || name == "hospital_flat_map";
}

std::vector<std::string> filesBelow(const fs::path& root) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".world" || extension == ".sdf" || extension == ".urdf") {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The errors when a file is loaded.
std::vector<std::string> complaints(const std::string& file, const world::ResourceFinder& finder,
                                    world::OnMissingAsset on_missing) {
  world::LoadOptions options;
  options.on_missing_asset = on_missing;
  try {
    static_cast<void>(world::loadWorld(file, finder, options));
  } catch (const ErrorList& errors) {
    return errors.messages();
  }
  return {};
}

class ReferenceFiles : public testing::TestWithParam<std::string> {};

TEST_P(ReferenceFiles, LoadAsTheyAreOrNameWhatIsAbsent) {
  const fs::path root = test::referenceFolder() / GetParam();
  const world::ResourceFinder finder = test::finderFor(root);
  int as_is = 0;
  int with_warn = 0;
  for (const std::string& file : filesBelow(root)) {
    const auto absent = complaints(file, finder, world::OnMissingAsset::kError);
    (absent.empty() ? as_is : with_warn)++;
    if (isTorn(file)) continue;
    // Torn meshes and models cannot be read, and a scale has three numbers.
    EXPECT_THAT(absent, Each(AnyOf(HasSubstr("no such file"), HasSubstr("not there"),
                                   HasSubstr("is missing"), HasSubstr("are missing"),
                                   HasSubstr("cannot be read"), HasSubstr("could not be parsed"))))
        << file;
    EXPECT_THAT(complaints(file, finder, world::OnMissingAsset::kWarn), testing::IsEmpty()) << file;
    if (!absent.empty()) {
      std::cout << "without " << absent.size() << " absent: " << fs::relative(file, root).string()
                << "  (" << absent.front().substr(0, 200) << ")\n";
    }
  }
  std::cout << GetParam() << ": " << as_is << " load as they are, " << with_warn
            << " without what is absent\n";
}

INSTANTIATE_TEST_SUITE_P(Folders, ReferenceFiles,
                         testing::Values("models/gazebo", "models/urdf", "worlds/aws_bookstore",
                                         "worlds/aws_small_warehouse", "worlds/pal_gazebo_worlds",
                                         "worlds/px4_sitl_gazebo", "worlds/rotors_simulator",
                                         "worlds/turtlebot3_simulations"));

}  // namespace reference_files_test
}  // namespace synthetic_dataset
