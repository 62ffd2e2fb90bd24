#include "motions_run.h"

#include <algorithm>
#include <filesystem>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "run/generator.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::test {
namespace {

namespace fs = std::filesystem;

constexpr char kWideCamera[] = R"(image_width: 320
image_height: 100
camera_matrix: {rows: 3, cols: 3, data: [120, 0, 159.5, 0, 120, 49.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.2, 0.03, 0, 0, 0]}
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// The world without the model that its last line describes.
std::string withoutBravo(const std::string& world) {
  const std::size_t begin = world.find("<model name='bravo'");
  const std::string end = "</model>";
  return world.substr(0, begin) + world.substr(world.find(end, begin) + end.size());
}

void writeBags(const TemporaryFolder& folder) {
  BagBuilder other(folder / "other.bag");
  other.fix("map", "alpha/base_link", milliseconds(5000), poseAt(0.5, -0.4, 0.0));
  BagBuilder lone(folder / "lone.bag");
  BagBuilder below(folder / "below.bag");
  below.fix("map", "bravo/base_link", milliseconds(1000), poseAt(0.3, -0.8, 0.0));
  for (int i = 0; i <= 20; ++i) {
    if (i <= 10) {
      other.move("map", "bravo/base_link", milliseconds(5000 + 50 * i),
                 poseAt(0.0, 0.2 + 0.05 * i, 0.0));
    }
    for (BagBuilder* bag : {&lone, &below}) {
      bag->move("map", "alpha/base_link", milliseconds(1000 + 50 * i),
                poseAt(0.0, -0.5 + 0.05 * i, 0.0));
    }
  }
  other.close();
  lone.close();
  below.close();
}

}  // namespace

MotionsRun::MotionsRun() {
  preparePluginEnvironment();
  parameters = tiny_.parameters();
  parameters.erase("background_subtractor");
  writeBags(tiny_.folder());
  const std::string world = readFile(tiny_.folder() / "tiny.world");
  (void)tiny_.folder().write("yard.world", replaced(world, "0.3 0.3 0.3 1", "0.1 0.3 0.1 1"));
  (void)tiny_.folder().write("lone.world", withoutBravo(world));
  (void)tiny_.folder().write("wide.yaml", kWideCamera);
}

void MotionsRun::set(const std::string& name, const std::string& text) {
  const std::string folder = tiny_.folder().path().string();
  parameters[name] = base::parseYaml(replaced(text, "DIR", folder), "test");
}

run::RunSummary MotionsRun::run(run::Reporter& reporter) const {
  fs::remove_all(folder());
  run::Generator generator(Value(parameters), reporter, {pluginXml()});
  return generator.run();
}

run::RunSummary MotionsRun::run() const {
  run::Reporter silent;
  return run(silent);
}

std::map<std::string, std::string> MotionsRun::files() const {
  (void)run();
  auto files = AllAtOnceRun::files(folder());
  files.erase("manifest.sqlite");
  return files;
}

std::vector<std::string> MotionsRun::errors() const {
  return messagesOf([&] {
    run::Reporter silent;
    const run::Generator generator(Value(parameters), silent, {pluginXml()});
  });
}

std::vector<ListedScene> MotionsRun::scenes() const {
  const base::SqliteDatabase manifest(folder() + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement row(
      manifest, "SELECT instant, stamp_ns, width, height, split FROM scene ORDER BY \"index\"");
  std::vector<ListedScene> scenes;
  while (row.step()) {
    scenes.push_back({row.integer(0), row.integer(1) / 1000000, static_cast<int>(row.integer(2)),
                      static_cast<int>(row.integer(3)), row.text(4)});
  }
  return scenes;
}

std::vector<ListedMotion> MotionsRun::motions() const {
  const base::SqliteDatabase manifest(folder() + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement row(
      manifest, "SELECT name, first_instant, instant_count FROM motion ORDER BY \"index\"");
  std::vector<ListedMotion> motions;
  while (row.step()) motions.push_back({row.text(0), row.integer(1), row.integer(2)});
  return motions;
}

std::string MotionsRun::number(std::int64_t scene) {
  const std::string digits = std::to_string(scene);
  return std::string(8 - digits.size(), '0') + digits;
}

}  // namespace synthetic_dataset::test
