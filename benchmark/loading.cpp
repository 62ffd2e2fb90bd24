/// Measures the time from a world's file to its first picture, as a multiple of the least that it
/// could take: reading the bytes, importing every mesh with assimp, decoding every picture, and
/// drawing one picture.
///
///   benchmark_loading
///
/// Prints the best of several tries [s] and the ratio.

#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <opencv2/imgcodecs.hpp>

#include "generated_world.h"
#include "render/renderer.h"
#include "world/world_loader.h"

namespace {

using namespace synthetic_dataset;
namespace fs = std::filesystem;

constexpr int kTries = 3;

double bestTime(const std::function<void()>& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTries; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    best = std::min(best, taken.count());
  }
  return best;
}

void importBarely(const benchmark::GeneratedWorld& world) {
  for (const fs::path& mesh : world.meshes) {
    Assimp::Importer importer;
    if (importer.ReadFile(mesh.string(), aiProcess_Triangulate) == nullptr) {
      throw std::runtime_error(importer.GetErrorString());
    }
  }
  for (const fs::path& picture : world.pictures) {
    if (cv::imread(picture.string(), cv::IMREAD_UNCHANGED).empty()) {
      throw std::runtime_error(picture.string() + ": cannot be read");
    }
  }
}

world::Description load(const fs::path& file) {
  const world::ResourceFinder finder(
      {}, [](const std::string&) -> std::optional<std::string> { return std::nullopt; });
  return world::loadWorld(file.string(), finder);
}

/// A world's links at their poses in the file, ready to be drawn.
class Scenery {
 public:
  explicit Scenery(const world::Description& description) {
    for (const world::Model& model : description.models) {
      for (const world::Link& link : model.links) {
        links_.push_back({&link, world::Role::kStatic, -1});
        poses_.push_back(model.X_WM * link.X_ML);
      }
    }
    renderer_ = std::make_unique<render::Renderer>(description, links_, render::RenderOptions());
  }

  void draw() {
    Eigen::Matrix3d R_WC;  // along +x, with +z up
    R_WC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    const CameraModel camera(640, 480, {554.0, 554.0, 319.5, 239.5}, 0.05, 100.0);
    const render::View view{camera, makePose({-3, 0, 2}, Eigen::Quaterniond(R_WC))};
    const render::LinkSelection all(links_.size(), true);
    (void)renderer_->colour(view, poses_, {all, all});
  }

 private:
  std::vector<world::LinkInstance> links_;
  std::vector<Pose> poses_;
  std::unique_ptr<render::Renderer> renderer_;
};

double report(const char* what, const std::function<void()>& work) {
  const double time = bestTime(work);
  std::cout << what << time << " s" << std::endl;
  return time;
}

void measure(const fs::path& folder) {
  const benchmark::GeneratedWorld world = benchmark::generateWorld(folder);
  const double import = report("assimp and pictures alone  ", [&] { importBarely(world); });
  report("the world loaded           ", [&] { (void)load(world.world); });
  const world::Description description = load(world.world);
  Scenery scenery(description);
  const double picture = report("one picture                ", [&] { scenery.draw(); });
  const double whole = report("file to first picture      ", [&] {
    const world::Description loaded = load(world.world);
    Scenery(loaded).draw();
  });
  std::cout << "ratio                      " << whole / (import + picture) << std::endl;
}

}  // namespace

int main() {
  std::string folder = (fs::temp_directory_path() / "benchmark_loading_XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) {
    std::cerr << "benchmark_loading: cannot make " << folder << '\n';
    return 1;
  }
  int code = 0;
  try {
    measure(folder);
  } catch (const std::exception& error) {
    std::cerr << "benchmark_loading: " << error.what() << '\n';
    code = 1;
  }
  fs::remove_all(folder);
  return code;
}
