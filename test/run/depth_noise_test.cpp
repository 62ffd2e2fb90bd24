/// Runs whose cameras measure depth as real ones do.

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "output/verify/dataset_verifier.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "run_fixture.h"
#include "support/fake_scene_sink.h"
#include "support/verification_list.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace depth_noise_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DepthNoiseTest : public test::RunFixture {
 protected:
  DepthNoiseTest() {
    parameters["writers"] = Value(Value::List{writer("Bop"), writer("ImageFolder")});
    parameters.erase("yolo");
    parameters.erase("bounding_shape");
    parameters["ImageFolder"] = Value(Value::Map{{"depth", Value(true)}, {"masks", Value(true)}});
  }

  static Value writer(const std::string& type) {
    return Value(Value::Map{{"name", Value(type)}, {"type", Value("synthetic_dataset/" + type)}});
  }

  void setNoise(const std::string& model) {
    (*parameters.at("camera").as<Value::Map>())["depth_noise"] =
        Value(Value::Map{{"model", Value(model)}});
  }

  /// @param only  the only scene that is made; negative for all
  [[nodiscard]] std::vector<FinishedScene> scenesOf(std::int64_t only = -1) const {
    Reporter silent;
    RunSetup setup = setUpRun(Value(parameters), {test::pluginXml()});
    test::FakeSceneSink sink;
    sink.required.depth = sink.required.visible_masks = sink.required.visibility = true;
    sink.is_wanted = [only](std::int64_t scene) { return only < 0 || scene == only; };
    (void)SceneLoop(setup, sink, silent).run();
    return sink.scenes;
  }
};

TEST_F(DepthNoiseTest, ChangesDepthAndNoLabel) {
  const std::vector<FinishedScene> exact = scenesOf();
  for (const char* model : {"structured_light", "stereo"}) {
    setNoise(model);
    const std::vector<FinishedScene> noisy = scenesOf();
    ASSERT_EQ(noisy.size(), exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const Scene& one = exact[i].scene;
      const Scene& other = noisy[i].scene;
      EXPECT_GT(cv::norm(one.depth(), other.depth()), 0.0);
      EXPECT_EQ(cv::norm(exact[i].scene.image, noisy[i].scene.image), 0.0);
      EXPECT_EQ(cv::norm(one.instance_map(), other.instance_map()), 0.0);
      for (std::size_t k = 0; k < one.objects.size(); ++k) {
        EXPECT_EQ(one.objects[k].visibility(), other.objects[k].visibility());
      }
    }
  }
}

TEST_F(DepthNoiseTest, BelongsToTheSceneAlone) {
  setNoise("stereo");
  const std::vector<FinishedScene> all = scenesOf();
  const std::vector<FinishedScene> one = scenesOf(2);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(cv::norm(all[2].scene.depth(), one[0].scene.depth()), 0.0);
  EXPECT_GT(cv::norm(all[1].scene.depth(), one[0].scene.depth()), 0.0);
}

TEST_F(DepthNoiseTest, IsVerified) {
  setNoise("structured_light");
  generate();
  test::VerificationList listener;
  EXPECT_EQ(verifyDataset(folder, output::VerificationDepth::kLabels, listener).scenes, 4);
  EXPECT_THAT(listener.problems, IsEmpty());
}

}  // namespace depth_noise_test
}  // namespace synthetic_dataset::run
