/// The bundled example, looked at more closely than a user would: labels against the renderer's
/// exact view of each object.

#include <iostream>

#include <gtest/gtest.h>

#include "base/yaml_value.h"
#include "render/renderer.h"
#include "run/setup/run_setup.h"
#include "scene/camera_poses.h"
#include "scene/object_motion.h"
#include "scene/scene_maker.h"
#include "support/source_folder.h"
#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace example_test {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

/// config/example.yaml as roslaunch would load it.
Value exampleParameters(const std::string& output) {
  const std::string file = test::sourceFolder() + "/config/example.yaml";
  std::string text = test::readFile(file);
  text = replaced(text, "$(find synthetic_dataset)", test::sourceFolder());
  Value parameters = base::parseYaml(text, file);
  (*parameters.as<Value::Map>())["output_folder"] = Value(output);
  (*parameters.as<Value::Map>())["simulated_rate"] = Value(2.0);
  return parameters;
}

double intersectionOverUnion(const cv::Mat& a, const cv::Mat& b) {
  const int both = cv::countNonZero(a & b);
  const int either = cv::countNonZero(a | b);
  return either == 0 ? 1.0 : static_cast<double>(both) / either;
}

TEST(Example, LooseBoxesHoldEveryPixelAndMasksMatchTheExactOnes) {
  test::preparePluginEnvironment();
  const test::TemporaryFolder folder;
  const RunSetup run = setUpRun(exampleParameters(folder / "out"), {test::pluginXml()});
  const MotionSetup& setup = run.motions.front();
  render::Renderer renderer(setup.world->description(), setup.world->links(), {});
  const std::vector<scene::ObjectOptions>& objects = setup.config.objects;
  Requirements masks;
  masks.silhouettes = true;
  label::MaskOptions subtraction = setup.config.masks;
  subtraction.method = label::MaskMethod::kMog2;
  scene::SceneMaker maker(*setup.world, renderer, *setup.frames, setup.cameras, *setup.shapes,
                          masks, {subtraction, {}, {}, {}, {}});
  scene::ObjectMotion motion(*setup.frames, objects, setup.world->links(), setup.driven_links);
  std::vector<double> worst(objects.size(), 1.0);
  std::vector<double> sum(objects.size(), 0.0);
  for (std::size_t s = 0; s < setup.timeline.stamps.size(); ++s) {
    const Stamp stamp = setup.timeline.stamps[s];
    setup.world->advanceTo(stamp, [&](int object, Stamp time) { return motion.at(object, time); });
    scene::CameraPoses poses(setup.cameras, *setup.world, *setup.frames, stamp);
    scene::SeenScene seen =
        maker.look(0, static_cast<std::int64_t>(s), stamp, poses, motion.objectPoses(stamp));
    (void)seen.pixels.labels(seen.scene, {});
    const Scene& scene = seen.scene;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      render::LinkSelection alone;
      for (const world::LinkInstance& link : setup.world->links()) {
        alone.push_back(link.role != world::Role::kObject || link.object == static_cast<int>(i));
      }
      const cv::Mat exact =
          renderer.labels({scene.camera, scene.X_GC}, setup.world->linkPoses(), {alone}).ids ==
          static_cast<int>(i + 1);
      const SceneObject& object = scene.objects[i];
      const double overlap = intersectionOverUnion(object.silhouette().whole(), exact);
      worst[i] = std::min(worst[i], overlap);
      sum[i] += overlap;
      std::vector<cv::Point> pixels;
      cv::findNonZero(exact, pixels);
      for (const cv::Point& pixel : pixels) {
        ASSERT_GE(pixel.x, object.loose_box->left) << object.name << " in scene " << s;
        ASSERT_LE(pixel.x, object.loose_box->right) << object.name << " in scene " << s;
        ASSERT_GE(pixel.y, object.loose_box->top) << object.name << " in scene " << s;
        ASSERT_LE(pixel.y, object.loose_box->bottom) << object.name << " in scene " << s;
      }
    }
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const double mean = sum[i] / static_cast<double>(setup.timeline.stamps.size());
    std::cout << "MOG2 against exact masks, " << objects[i].name << ": IoU mean " << mean
              << ", worst " << worst[i] << '\n';
    // The lost pixels are those that happen to have the background's colour.
    EXPECT_GT(mean, 0.95) << objects[i].name;
    EXPECT_GT(worst[i], 0.85) << objects[i].name;
  }
}

}  // namespace example_test
}  // namespace synthetic_dataset::run
