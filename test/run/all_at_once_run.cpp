#include "all_at_once_run.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/json_text.h"
#include "config/settings_text.h"
#include "run/generator.h"
#include "support/error_messages.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::test {
namespace {

namespace fs = std::filesystem;

Value::Map cameraAt(const Value::Map& camera, double y) {
  Value::Map moved = camera;
  (*moved.at("pose").as<Value::List>())[1] = Value(y);
  moved["effects"] = Value(Value::Map{{"noise_stddev", Value(0.01)}});
  return moved;
}

/// Empties the folder that all tests of the program share, and returns it.
std::shared_ptr<const TemporaryFolder> emptyFolder() {
  static const auto folder = std::make_shared<const TemporaryFolder>();
  for (const auto& entry : fs::directory_iterator(folder->path())) fs::remove_all(entry);
  return folder;
}

}  // namespace

AllAtOnceRun::AllAtOnceRun() : tiny_(emptyFolder()) {
  preparePluginEnvironment();
  parameters = tiny_.parameters();
  const Value::Map camera = *parameters.at("camera").as<Value::Map>();
  parameters.erase("camera");
  parameters["cameras"] = Value(
      Value::Map{{"left", Value(cameraAt(camera, 0.4))}, {"right", Value(cameraAt(camera, 0.0))}});
  parameters["simulated_rate"] = Value(8.0);
  parameters["seed"] = Value(7);
  parameters["sync"] = Value("off");  // tests do not wait for the disk
  parameters.erase("yolo");
  parameters.erase("bounding_shape");
  const std::map<std::string, Value::Map> formats = {
      {"Bop", {}},   {"Coco", {}},   {"ImageFolder", {{"optical_flow", Value(true)}}},
      {"PvNet", {}}, {"RosBag", {}}, {"UltralyticsYolo", {{"task", Value("segment")}}}};
  Value::List writers;
  for (const auto& [type, settings] : formats) {
    writers.emplace_back(
        Value::Map{{"name", Value("w_" + type)}, {"type", Value("synthetic_dataset/" + type)}});
    parameters["w_" + type] = Value(settings);
  }
  parameters["writers"] = Value(writers);
}

run::RunSummary AllAtOnceRun::run(run::Reporter& reporter, const std::string& folder) const {
  Value::Map settings = parameters;
  settings["output_folder"] = Value(folder);
  run::Generator generator(Value(settings), reporter, {pluginXml()});
  return generator.run();
}

run::RunSummary AllAtOnceRun::run() const {
  run::Reporter silent;
  return run(silent, folder());
}

const std::map<std::string, std::string>& AllAtOnceRun::unbroken() const {
  static std::map<std::string, std::map<std::string, std::string>> made;
  fs::remove_all(folder());
  std::string key = base::jsonText(Value(parameters));
  for (const auto& [name, bytes] : files(tiny_.folder().path().string())) key += name + bytes;
  const auto [entry, is_new] = made.try_emplace(key);
  if (is_new) {
    (void)run();
    entry->second = files(folder());
    fs::remove_all(folder());
  }
  return entry->second;
}

std::vector<std::string> AllAtOnceRun::errors() const {
  return messagesOf([&] { (void)run(); });
}

run::RunSummary AllAtOnceRun::runShard(int index, int count, const std::string& folder) const {
  Value::Map settings = parameters;
  settings["output_folder"] = Value(folder);
  settings["shard"] = Value(Value::Map{{"index", Value(index)}, {"count", Value(count)}});
  run::Reporter silent;
  run::Generator generator(Value(settings), silent, {pluginXml()});
  return generator.run();
}

std::map<std::string, std::string> AllAtOnceRun::files(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), folder).string()] = readFile(entry.path());
  }
  return files;
}

void AllAtOnceRun::expectFiles(const std::map<std::string, std::string>& expected) const {
  const std::map<std::string, std::string> made = files(folder());
  EXPECT_EQ(made.size(), expected.size());
  for (const auto& [name, bytes] : expected) {
    const auto found = made.find(name);
    EXPECT_TRUE(found != made.end() && found->second == bytes) << name;
  }
}

}  // namespace synthetic_dataset::test
