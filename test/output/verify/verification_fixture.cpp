#include "output/verify/verification_fixture.h"

#include <filesystem>

#include <sqlite3.h>

#include "config/settings_text.h"
#include "output/files/digest.h"
#include "plugins/model_shapes.h"
#include "support/verification_list.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::output {
VerificationTest::VerificationTest(const std::string& format, bool has_lidar)
    : PluginTest((format.find('/') == std::string::npos ? "synthetic_dataset/" : "") + format) {
  dataset_.classes = {{0, "cup"}, {1, "jug"}};
  for (const std::string name : {"a", "b"}) {
    ObjectInfo info;
    info.name = info.id = name;
    info.class_id = name == "a" ? 0 : 1;
    info.class_name = dataset_.classes[static_cast<std::size_t>(info.class_id)].name;
    info.keypoint_count = 1;
    info.keypoint_names = {"0"};
    dataset_.objects.push_back(info);
  }
  if (has_lidar) addLidar();
  dataset_.setModels([](std::size_t /*object*/) {
    return cuboidModel({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  });
}

Scene VerificationTest::sceneOfBoth(std::int64_t index) const {
  Scene scene =
      PluginTest::scene(index, {seen("a", {100, 100, 50, 40}), seen("b", {300, 120, 30, 60})});
  scene.stamp = Stamp(std::chrono::seconds(1 + index));
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    SceneObject& object = scene.objects[i];
    object.id = object.name;
    object.class_id = dataset_.objects[i].class_id;
    object.class_name = object.class_text = dataset_.objects[i].class_name;
    object.X_GO = object.X_CO =
        makePose({0.1 * static_cast<double>(index), 0.2, 10.0},
                 Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0)));
    object.keypoints_O = {Eigen::Vector3d::Zero()};
    object.bounding_shape_O = {{-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3}};
    Keypoint keypoint;
    keypoint.pixel = Eigen::Vector2d(320.0, 240.0);
    keypoint.depth = 10.0;
    keypoint.state = KeypointState::kVisible;
    object.keypoints = {keypoint};
  }
  if (!dataset_.lidars.empty()) return withCloud(std::move(scene));
  return scene;
}

output::RunDescription VerificationTest::description(const Value::Map& parameters,
                                                     std::size_t scenes) const {
  output::RunDescription run;
  for (const auto& [name, text] : config::flatSettings(Value(Value::Map{{"w", parameters}}))) {
    run.settings[name] = {text, false};
  }
  for (const LidarDescription& lidar : dataset_.lidars) {
    run.settings["lidars/" + lidar.name + "/frame_id"] = {'"' + lidar.frame + '"', true};
  }
  output::describeContents(dataset_, run);
  for (std::size_t i = 0; i < run.objects.size(); ++i) run.objects[i].model = dataset_.model(i);
  run.scene_count = static_cast<std::int64_t>(scenes);
  return run;
}

base::SceneFacts VerificationTest::factsOf(const Scene& scene) const {
  base::SceneFacts facts = base::sceneFacts(scene);
  facts.draws = {{"floor", R"("dark \"oak\"")"}, {"sun/colour", "[1, 0.5, 1e-05]"}, {"x", "-2.5"}};
  facts.warnings = warnings_;
  for (const SceneObject& object : scene.objects) {
    base::ObjectFacts of_object = base::objectFacts(object);
    of_object.silhouette_pixels = object.pixels.silhouette();
    of_object.visible_pixels = object.pixels.visible();
    of_object.visibility = object.visibility();
    of_object.truncation = object.truncation();
    facts.objects.push_back(of_object);
  }
  for (const std::string& frame : host_->requirements().frames) {
    facts.frames.emplace(frame, scene.transform(dataset_.global_frame, frame));
  }
  return facts;
}

void VerificationTest::commit(output::DatasetStore& store, const std::vector<Scene>& scenes) const {
  for (const Scene& each : scenes) {
    const output::WriterHost::SceneResult written = host_->writeScene(each);
    output::SceneFacts facts = factsOf(each);
    for (const std::string& warning : written.warnings) facts.warnings.push_back({warning});
    store.commitScene(facts, written.files);
  }
}

void VerificationTest::write(const std::vector<Scene>& scenes, const Value::Map& parameters,
                             const std::optional<output::Shard>& shard) {
  nameMotion(shard ? 2 * scenes.size() : scenes.size());
  load(parameters);
  output::StoreOptions options;
  options.folder = folder_.path().string();
  options.shard = shard;
  const std::size_t count = shard ? 2 * scenes.size() : scenes.size();
  output::DatasetStore store(options, host_->storeWriters(), description(parameters, count));
  commit(store, scenes);
  if (!shard) host_->finalize(store);
  store.complete();
}

void VerificationTest::nameMotion(std::size_t scenes) {
  if (!dataset_.motions.empty()) return;
  dataset_.motions = {{"walk", 0, static_cast<std::int64_t>(scenes / dataset_.cameras.size())}};
}

void VerificationTest::writeUnfinished(const std::vector<Scene>& scenes) {
  nameMotion(scenes.size() + 1);
  load({});
  output::StoreOptions options;
  options.folder = folder_.path().string();
  output::DatasetStore store(options, host_->storeWriters(), description({}, scenes.size() + 1));
  commit(store, scenes);
}

std::vector<std::string> VerificationTest::problems(VerificationDepth depth) {
  // Never destroyed: class_loader cannot unload libraries once the program ends, as its own data
  // about them may be gone by then.
  static WriterLoader& writers = *new WriterLoader({test::pluginXml(), test::examplePluginXml()});
  test::VerificationList listener;
  counts_ = verifyDataset(folder_.path().string(), depth, listener, writers);
  remarks_ = listener.remarks;
  return listener.problems;
}

void VerificationTest::change(const std::string& sql, const std::string& manifest) const {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((folder_ / manifest).c_str(), &database), SQLITE_OK);
  char* message = nullptr;
  // Without constraints, as an attacker could do it, and without waiting for the disk.
  sqlite3_exec(database, "PRAGMA ignore_check_constraints = ON; PRAGMA synchronous = OFF", nullptr,
               nullptr, nullptr);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &message), SQLITE_OK)
      << (message != nullptr ? message : "");
  sqlite3_free(message);
  sqlite3_close(database);
}

std::string VerificationTest::read(const std::string& name) const {
  return test::readFile(path(name));
}

void VerificationTest::replace(const std::string& path, const std::string& content) const {
  const std::string file = folder() + path;
  ASSERT_TRUE(std::filesystem::remove(file)) << file;  // it may be a link to another file
  (void)folder_.write("w/" + path, content);
  change("UPDATE file SET linked_to = NULL, bytes = " + std::to_string(content.size()) +
         ", digest = '" + output::digestOf(content) + "' WHERE path = 'w/" + path + "'");
}

void VerificationTest::edit(const std::string& path,
                            const std::function<std::string(std::string)>& edit) const {
  replace(path, edit(read(path)));
}

void VerificationTest::edit(const std::string& path, const std::string& what,
                            const std::string& instead) const {
  std::string content = read(path);
  const std::size_t at = content.find(what);
  ASSERT_NE(at, std::string::npos) << path << ": " << content;
  replace(path, content.replace(at, what.size(), instead));
}

}  // namespace synthetic_dataset::output
