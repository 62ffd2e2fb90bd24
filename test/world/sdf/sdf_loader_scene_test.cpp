#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_scene_test {

using namespace test;

Description loadScene(const std::string& content) {
  const TemporaryFolder folder;
  return loadText(folder, worldFile("<scene>" + content + "</scene>"));
}

TEST(SdfScene, IsGazebosWhereTheFileHasNone) {
  const TemporaryFolder folder;
  const Description world = loadText(folder, worldFile(""));
  EXPECT_EQ(world.ambient, Eigen::Vector3f(0.4F, 0.4F, 0.4F));
  EXPECT_EQ(world.background, Eigen::Vector3f(0.7F, 0.7F, 0.7F));
  EXPECT_FALSE(world.sky);
  EXPECT_FALSE(world.fog);
}

TEST(SdfScene, HasFog) {
  const Description world = loadScene(
      "<fog><color>0.1 0.2 0.3 1</color><type>linear</type><start>2</start><end>30</end></fog>");
  ASSERT_TRUE(world.fog);
  EXPECT_EQ(world.fog->type, FogType::kLinear);
  EXPECT_TRUE(world.fog->colour.isApprox(Eigen::Vector3f(0.1F, 0.2F, 0.3F)));
  EXPECT_EQ(world.fog->start, 2.0);
  EXPECT_EQ(world.fog->end, 30.0);
}

TEST(SdfScene, KnowsGazebosKindsOfFog) {
  const auto fog = [](const std::string& type) {
    return loadScene("<fog><type>" + type + "</type><density>0.5</density></fog>").fog;
  };
  EXPECT_EQ(fog("exp")->type, FogType::kExponential);
  EXPECT_EQ(fog("exp2")->type, FogType::kSquaredExponential);
  EXPECT_EQ(fog("exp")->density, 0.5);
  EXPECT_FALSE(fog("none"));
}

TEST(SdfScene, NotesFogOfAnotherKind) {
  const Description world = loadScene("<fog><type>constant</type></fog>");
  EXPECT_FALSE(world.fog);
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("scene: fog: type 'constant' is left out")));
}

TEST(SdfScene, HasASky) {
  const Description world = loadScene(
      "<sky><time>17.5</time><sunrise>5</sunrise><sunset>21</sunset><clouds><humidity>0.9</"
      "humidity>"
      "<mean_size>0.2</mean_size><ambient>0.5 0.6 0.7 1</ambient></clouds></sky>");
  ASSERT_TRUE(world.sky);
  EXPECT_EQ(world.sky->time, 17.5);
  EXPECT_EQ(world.sky->sunrise, 5.0);
  EXPECT_EQ(world.sky->sunset, 21.0);
  EXPECT_EQ(world.sky->cloud_humidity, 0.9);
  EXPECT_EQ(world.sky->cloud_mean_size, 0.2);
  EXPECT_TRUE(world.sky->cloud_ambient.isApprox(Eigen::Vector3f(0.5F, 0.6F, 0.7F)));
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(SdfScene, HasAClearSkyWithoutClouds) {
  EXPECT_EQ(loadScene("<sky/>").sky->cloud_humidity, 0.0);
  EXPECT_EQ(loadScene("<sky><clouds/></sky>").sky->cloud_humidity, 0.5);
}

TEST(SdfScene, TurnsShadowsOff) {
  const TemporaryFolder folder;
  const std::string light =
      "<light name='l' type='directional'><cast_shadows>true</cast_shadows></light>";
  const auto shadow = [&](const std::string& scene) {
    return loadText(folder, worldFile(scene + light)).lights.at(0).casts_shadow;
  };
  EXPECT_TRUE(shadow(""));
  EXPECT_TRUE(shadow("<scene><shadows>true</shadows></scene>"));
  EXPECT_FALSE(shadow("<scene><shadows>0</shadows></scene>"));
}

TEST(SdfScene, NamesNumbersThatAreNone) {
  const TemporaryFolder folder;
  const auto notes = [&](const std::string& scene) {
    return notesOf(folder, worldFile("<scene>" + scene + "</scene>"));
  };
  EXPECT_THAT(notes("<fog><type>linear</type><start>9</start><end>5</end></fog>"),
              Contains(AllOf(HasSubstr("world.sdf: line 1: scene: fog: end: found 5"),
                             HasSubstr("beyond start"))));
  EXPECT_THAT(notes("<fog><type>exp</type><density>-1</density></fog>"),
              Contains(HasSubstr("density")));
}

}  // namespace sdf_loader_scene_test
}  // namespace synthetic_dataset::world
