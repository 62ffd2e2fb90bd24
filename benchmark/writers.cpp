/// Measures what one more format costs: the processor time of a run with several writers that share
/// their images, as a multiple of that of a run with only the first of them.
///
///   benchmark_writers REPOSITORY
///
/// Makes the bundled example at 2 scenes/s. Prints the best of several tries [s], the ratios, and
/// what each further writer adds [%].

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "base/yaml_value.h"
#include "run/generator.h"
#include "run/reporter.h"

namespace {

using namespace synthetic_dataset;
namespace fs = std::filesystem;

constexpr int kTries = 3;
const std::vector<std::size_t> kCounts = {1, 2, 4, 8};

class QuietReporter : public run::Reporter {
 public:
  void info(const std::string& /*message*/) override {}
  void warning(const std::string& /*message*/) override {}
  void progress(std::int64_t /*done*/, std::int64_t /*scenes*/) override {}
  [[nodiscard]] bool stopRequested() const override { return false; }
};

struct Writer {
  std::string name;
  std::string type;
  Value::Map parameters;
};

/// Formats that all write the picture as PNG.
std::vector<Writer> writers() {
  const auto ultralytics = [](const char* task) {
    return Writer{task, "UltralyticsYolo", {{"task", Value(task)}}};
  };
  return {{"coco", "Coco", {}},
          ultralytics("detect"),
          {"dope", "Dope", {}},
          {"kitti", "Kitti", {}},
          ultralytics("segment"),
          ultralytics("pose"),
          {"image_folder", "ImageFolder", {{"masks", Value(false)}}},
          ultralytics("obb")};
}

std::string exampleSettings(const fs::path& repository) {
  std::ifstream stream(repository / "config" / "example.yaml");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string placeholder = "$(find synthetic_dataset)";
  for (std::size_t at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder, at)) {
    text.replace(at, placeholder.size(), repository.string());
  }
  return text;
}

/// The processor time [s] of a run with the first `count` writers, which is more meaningful than
/// wall-clock time on a machine with other load.
double timeOf(const fs::path& repository, const fs::path& folder, std::size_t count) {
  Value settings = base::parseYaml(exampleSettings(repository), "example.yaml");
  Value::Map& map = *settings.as<Value::Map>();
  Value::List list;
  const std::vector<Writer> all = writers();
  for (std::size_t i = 0; i < count; ++i) {
    list.emplace_back(Value::Map{{"name", Value(all[i].name)},
                                 {"type", Value("synthetic_dataset/" + all[i].type)}});
    map[all[i].name] = Value(all[i].parameters);
  }
  map["writers"] = Value(list);
  for (const char* unused : {"yolo", "bounding_shape"}) map.erase(unused);
  map["masks"] = Value(Value::Map{{"method", Value("exact")}});
  map["simulated_rate"] = Value(2.0);
  map["output_folder"] = Value((folder / std::to_string(count)).string());
  map["if_exists"] = Value("overwrite");
  QuietReporter reporter;
  run::Generator generator(settings, reporter, {(repository / "plugins.xml").string()});
  const std::clock_t start = std::clock();
  (void)generator.run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: benchmark_writers REPOSITORY\n";
    return 2;
  }
  const fs::path repository = fs::absolute(argv[1]);
  const fs::path folder = fs::temp_directory_path() / "synthetic_dataset_benchmark_writers";
  try {
    std::vector<double> best(kCounts.size(), std::numeric_limits<double>::infinity());
    // In turns, so that other load on the machine affects all counts equally.
    for (int i = 0; i < kTries; ++i) {
      for (std::size_t k = 0; k < kCounts.size(); ++k) {
        best[k] = std::min(best[k], timeOf(repository, folder, kCounts[k]));
      }
    }
    for (std::size_t k = 0; k < kCounts.size(); ++k) {
      std::cout << kCounts[k] << " writers: " << best[k] << " s, " << best[k] / best[0]
                << " times one";
      const auto more = static_cast<double>(kCounts[k] - 1);
      if (more > 0.0) std::cout << ", " << 100.0 * (best[k] / best[0] - 1.0) / more << " % each";
      std::cout << '\n';
    }
    fs::remove_all(folder);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_writers: " << error.what() << '\n';
    return 1;
  }
}
