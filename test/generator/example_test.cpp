/// The bundled example, looked at more closely than a user would: labels against the renderer's
/// exact view of each object.

#include <iostream>

#include <gtest/gtest.h>

#include "config/yaml_value.h"
#include "render/renderer.h"
#include "run_setup.h"
#include "scene_maker.h"
#include "support/temporary_folder.h"
#include "writers/plugin_environment.h"

namespace synthetic_dataset {
namespace {

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
  Value parameters = config::parseYaml(text, file);
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
  const RunSetup setup = setUpRun(exampleParameters(folder / "out"), {test::pluginXml()});
  render::Renderer renderer(setup.world->description(), setup.world->links(), {});
  std::vector<annotate::ObjectShape> shapes;
  for (const config::ObjectConfig& object : setup.config.objects) {
    shapes.push_back(
        {object.name, object.class_name, object.id, object.keypoints_O, object.bounding_shape_O});
  }
  Requirements masks;
  masks.instance_masks = true;
  const config::MaskConfig& mog2 = setup.config.masks;
  SceneMaker maker(*setup.world, renderer, *setup.recording, *setup.camera,
                   setup.config.global_frame, shapes, masks,
                   {{mog2.history_length, mog2.var_threshold, mog2.detect_shadows}, mog2.clean});
  std::vector<double> worst(shapes.size(), 1.0);
  std::vector<double> sum(shapes.size(), 0.0);
  for (std::size_t s = 0; s < setup.timeline.stamps.size(); ++s) {
    const Stamp stamp = setup.timeline.stamps[s];
    std::vector<Pose> X_GO;
    const auto poseOf = [&](int object, Stamp time) {
      return setup.recording->transform(
          "map", setup.config.objects[static_cast<std::size_t>(object)].frame, time);
    };
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      X_GO.push_back(poseOf(static_cast<int>(i), stamp));
    }
    setup.world->advanceTo(stamp, poseOf);
    const Scene scene = maker.make(static_cast<std::int64_t>(s), stamp, X_GO);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      render::LinkSelection alone;
      for (const world::LinkInstance& link : setup.world->links()) {
        alone.push_back(link.role != world::Role::kObject || link.object == static_cast<int>(i));
      }
      const cv::Mat exact =
          renderer.labels({scene.camera, scene.X_GC}, setup.world->linkPoses(), alone).ids ==
          static_cast<int>(i + 1);
      const SceneObject& object = scene.objects[i];
      const double overlap = intersectionOverUnion(object.mask, exact);
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
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double mean = sum[i] / static_cast<double>(setup.timeline.stamps.size());
    std::cout << "MOG2 against exact masks, " << shapes[i].name << ": IoU mean " << mean
              << ", worst " << worst[i] << '\n';
    // What is lost are pixels that happen to have the background's colour.
    EXPECT_GT(mean, 0.95) << shapes[i].name;
    EXPECT_GT(worst[i], 0.85) << shapes[i].name;
  }
}

}  // namespace
}  // namespace synthetic_dataset
