/// make_loader_datasets FOLDER: datasets in every format, with their truth, for the tests of
/// loaders.

#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "lidar/lidar_options.h"
#include "loaders/hard_cases.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"

namespace {

namespace fs = std::filesystem;
using namespace synthetic_dataset;

void makeAll(const fs::path& folder) {
  test::hardCases().generate(folder / "hard");
  test::hardCasesThroughLens().generate(folder / "lens");
  test::emptyScenes().generate(folder / "empty");
  test::manyObjects().generate(folder / "many");
  test::camerasAndSplits().generate(folder / "cameras");
  if (!lidar::canCastRays()) return;
  test::lidarScenes().generate(folder / "lidar");
  test::movingLidar().generate(folder / "moving_lidar");
  test::streets().generate(folder / "streets");
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: make_loader_datasets FOLDER\n";
    return 2;
  }
  try {
    test::preparePluginEnvironment(
        {std::string(SYNTHETIC_DATASET_LOADER_TESTS) + "/plugin_package"});
    makeAll(fs::absolute(arguments[1]));
  } catch (const ErrorList& errors) {
    for (const std::string& message : errors.messages()) std::cerr << message << "\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
