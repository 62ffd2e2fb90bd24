#include "randomize/appearance/distractor_models.h"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::randomize {
namespace distractor_models_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A model of a visible ball.
world::Model ball(const std::string& name) {
  world::Visual visual;
  visual.surfaces.push_back({world::sphereMesh(0.1), {}});
  world::Link link;
  link.visuals.push_back(visual);
  world::Model model;
  model.name = name;
  model.links.push_back(link);
  return model;
}

TEST(DistractorModels, AreTakenInTurnFromFilesAndFolders) {
  const test::TemporaryFolder folder;
  folder.write("shelf/cup/model.config", "");
  folder.write("shelf/jug.sdf", "");
  randomize::DistractorOptions config;
  config.models = {"model://crate", (folder / "shelf").string()};
  config.pool = 5;
  std::vector<std::string> loaded;
  const std::vector<world::Model> models =
      makeDistractors(config, 1, [&](const std::string& uri, const std::string& name) {
        loaded.push_back(uri);
        return ball(name);
      });
  const std::string cup = folder / "shelf/cup";
  const std::string jug = folder / "shelf/jug.sdf";
  EXPECT_THAT(loaded, ElementsAre("model://crate", cup, jug, "model://crate", cup));
  EXPECT_EQ(models.at(4).name, "distractor_5");
}

TEST(DistractorModels, ThatCannotBeSeenAreTold) {
  randomize::DistractorOptions config;
  config.models = {"model://ghost"};
  const auto load = [](const std::string&, const std::string&) { return world::Model{}; };
  EXPECT_THAT(
      test::messagesOf([&] { (void)makeDistractors(config, 1, load); }),
      testing::ElementsAre(HasSubstr("found 'model://ghost', a model without visible parts")));
}

}  // namespace distractor_models_test
}  // namespace synthetic_dataset::randomize
