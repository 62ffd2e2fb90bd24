#include "randomize/appearance/look_sampler.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "base/yaml_value.h"
#include "config/readers.h"
#include "support/box_world.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace look_sampler_test {

using Eigen::Vector3d;
using Eigen::Vector3f;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::UnorderedElementsAre;

/// The draws of a scene by name: lists of numbers, or a text.
using Draws = std::map<std::string, std::variant<std::vector<double>, std::string>>;

world::Visual visualOf(const std::string& name, const std::vector<world::Material>& materials) {
  world::Visual visual;
  visual.name = name;
  for (const auto& each : materials) visual.surfaces.push_back({test::boxMesh({1, 1, 1}), each});
  return visual;
}

world::Material paint(const Eigen::Vector4f& diffuse,
                      std::shared_ptr<const world::Texture> texture = nullptr) {
  world::Material material;
  material.diffuse = diffuse;
  material.texture = std::move(texture);
  return material;
}

std::shared_ptr<const world::Texture> picture(int alpha) {
  auto texture = std::make_shared<world::Texture>();
  texture->pixels = cv::Mat(4, 4, CV_8UC4, cv::Scalar(1, 2, 3, 255));
  texture->pixels.at<cv::Vec4b>(3, 2)[3] = static_cast<unsigned char>(alpha);
  return texture;
}

world::Link linkOf(const std::string& name, std::vector<world::Visual> visuals) {
  world::Link link;
  link.name = name;
  link.visuals = std::move(visuals);
  return link;
}

world::Model modelOf(const std::string& name, std::vector<world::Link> links) {
  world::Model model;
  model.name = name;
  model.links = std::move(links);
  return model;
}

/// An object: a hull of two surfaces, a window, and a tyre on a link of its own.
world::Model rover(const std::string& name) {
  return modelOf(name, {linkOf("base_link", {visualOf("hull", {paint({0.1F, 0.2F, 0.3F, 1.0F}),
                                                               paint({0.4F, 0.4F, 0.4F, 1.0F})}),
                                             visualOf("window", {paint({0.9F, 1, 1, 0.25F})})}),
                        linkOf("wheel", {visualOf("tyre", {paint({0, 0, 0, 1})})})});
}

world::Light lightOf(const std::string& name, world::LightType type, const Vector3f& diffuse) {
  world::Light light;
  light.name = name;
  light.type = type;
  light.diffuse = diffuse;
  return light;
}

/// A hall with a sun, a lamp, and a spot that is turned in its own frame.
world::Description hall() {
  world::Description description;
  description.lights = {lightOf("sun", world::LightType::kDirectional, {0.8F, 0.6F, 0.4F}),
                        lightOf("lamp", world::LightType::kPoint, {0.5F, 0.5F, 0.5F}),
                        lightOf("stage::rig::spot", world::LightType::kSpot, {0.2F, 0.2F, 0.2F})};
  // It shines along (0.3, 0.4, -1) in the world.
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Vector3d(3, 1, 2).normalized()));
  description.lights[0].X_WL = makePose({7, 8, 9}, turn);
  description.lights[0].direction_L = turn.inverse() * Vector3d(0.3, 0.4, -1.0);
  description.lights[1].X_WL = makePose({1, 2, 3}, Eigen::Quaterniond::Identity());
  description.lights[2].X_WL = makePose(
      {4, 5, 6}, Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized())));
  world::Model room =
      modelOf("room", {linkOf("body", {visualOf("floor", {paint({0.6F, 0.6F, 0.6F, 1})}),
                                       visualOf("wall", {paint({1, 1, 1, 1}, picture(255))}),
                                       visualOf("fence", {paint({1, 1, 1, 1}, picture(254))}),
                                       visualOf("rock", {paint({0.5F, 0.4F, 0.3F, 1})})})});
  room.is_static = true;
  world::Surface& rock = room.links[0].visuals[3].surfaces[0];
  auto bare = std::make_shared<world::Mesh>(*rock.mesh);
  bare->texture_coordinates.clear();
  rock.mesh = bare;
  description.models = {
      room, modelOf("ball", {linkOf("body", {visualOf("skin", {paint({1, 0, 0, 1})})})})};
  return description;
}

class LookSamplerTest : public ::testing::Test {
 protected:
  /// The look of a scene, and in `draws` what was drawn for it.
  world::Look sample(const std::string& randomize, std::int64_t scene = 0, std::uint64_t seed = 1) {
    Parameters root(base::parseYaml("randomize: {" + randomize + "}", "test"));
    LookSampler sampler(config::readRandomization(root), world);
    EXPECT_THAT(root.errors(), IsEmpty());
    EntryDraws entry_draws(seed, scene);
    world::Look look = sampler.sample(entry_draws);
    draws.clear();
    for (const DrawnValue& drawn : entry_draws.values()) {
      EXPECT_TRUE(draws.emplace(drawn.name, drawn.value).second) << drawn.name << " twice";
    }
    return look;
  }

  [[nodiscard]] std::vector<std::string> errorsOf(const std::string& randomize) const {
    Parameters root(base::parseYaml("randomize: {" + randomize + "}", "test"));
    return test::messagesOf([&] { LookSampler sampler(config::readRandomization(root), world); });
  }

  /// A surface of the visual named "model::link::visual".
  [[nodiscard]] const world::Surface& surface(const std::string& name,
                                              std::size_t number = 0) const {
    for (const world::LinkInstance& link : world.links()) {
      for (const world::Visual& visual : link.link->visuals) {
        if (link.model + "::" + link.link->name + "::" + visual.name == name) {
          return visual.surfaces.at(number);
        }
      }
    }
    throw std::out_of_range(name);
  }

  /// The material of a surface in a look: another one, or the one that it was made with.
  [[nodiscard]] const world::Material& worn(const world::Look& look, const std::string& name,
                                            std::size_t number = 0) const {
    const world::Material& given = surface(name, number).material;
    const auto found = look.materials.find(&given);
    return found != look.materials.end() ? found->second : given;
  }

  [[nodiscard]] Vector3f colour(const world::Look& look, const std::string& name,
                                std::size_t number = 0) const {
    return worn(look, name, number).diffuse.head<3>();
  }

  [[nodiscard]] bool isGiven(const world::Look& look, const std::string& name) const {
    return look.materials.count(&surface(name).material) == 0;
  }

  [[nodiscard]] double drawn(const std::string& name, std::size_t component = 0) const {
    return std::get<std::vector<double>>(draws.at(name)).at(component);
  }

  Draws draws;
  world::World world{hall(), {rover("rover_1"), rover("rover_2")}, {}};
};

/// The direction in which the light of this index shines, in the world.
Vector3d direction(const world::Look& look, std::size_t light) {
  return look.lights[light].X_WL.linear() * look.lights[light].direction_L;
}

/// The direction towards a light at these angles: up from +x by the elevation, then about z.
Vector3d towards(double elevation, double azimuth) {
  return Eigen::AngleAxisd(azimuth, Vector3d::UnitZ()) *
         (Eigen::AngleAxisd(-elevation, Vector3d::UnitY()) * Vector3d::UnitX());
}

// --- Lights ---

TEST_F(LookSamplerTest, LeavesAloneWhatNoEntryMeans) {
  const world::Look look = sample("");
  EXPECT_THAT(draws, IsEmpty());
  EXPECT_THAT(look.materials, IsEmpty());
  EXPECT_EQ(look.ambient, hall().ambient);
  EXPECT_EQ(look.background, hall().background);
  ASSERT_EQ(look.lights.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(look.lights[i].diffuse, hall().lights[i].diffuse);
    EXPECT_EQ(look.lights[i].direction_L, hall().lights[i].direction_L);
    EXPECT_EQ(look.lights[i].X_WL.matrix(), hall().lights[i].X_WL.matrix());
  }
}

TEST_F(LookSamplerTest, MultipliesIntensityWithTheWorlds) {
  const world::Look look = sample("lights: {sun: {intensity: 2.5}}");
  EXPECT_TRUE(look.lights[0].diffuse.isApprox(Vector3f(2.0F, 1.5F, 1.0F), 1e-6F));
  EXPECT_EQ(look.lights[1].diffuse, Vector3f(0.5F, 0.5F, 0.5F)) << "the lamp is not meant";
}

TEST_F(LookSamplerTest, TakesHighlightsWithTheLights) {
  const Vector3f own = hall().lights[0].specular;
  EXPECT_TRUE(sample("lights: {sun: {intensity: 2.5}}").lights[0].specular.isApprox(2.5F * own));
  EXPECT_TRUE(sample("lights: {sun: {present: 0}}").lights[0].specular.isZero());
  EXPECT_TRUE(sample("light_count: 0").lights[1].specular.isZero());
}

TEST_F(LookSamplerTest, PutsAColourInPlaceOfTheWorldsAndMultipliesItToo) {
  EXPECT_EQ(sample("lights: {sun: {colour: [1, 0.5, 0.25]}}").lights[0].diffuse,
            Vector3f(1.0F, 0.5F, 0.25F));
  EXPECT_EQ(sample("lights: {sun: {colour: [1, 0.5, 0.25], intensity: 4}}").lights[0].diffuse,
            Vector3f(4.0F, 2.0F, 1.0F));
}

TEST_F(LookSamplerTest, TurnsLightsOffThatAreNotPresent) {
  EXPECT_TRUE(sample("lights: {sun: {present: 0, intensity: 5}}").lights[0].diffuse.isZero());
  EXPECT_EQ(drawn("lights/sun/present"), 0.0);
  EXPECT_EQ(sample("lights: {sun: {present: 1}}").lights[0].diffuse, hall().lights[0].diffuse);
  EXPECT_EQ(drawn("lights/sun/present"), 1.0);
}

TEST_F(LookSamplerTest, LetsSunlightShineFromAnElevationAndAnAzimuth) {
  for (const auto& [elevation, azimuth] :
       {std::pair{0.5, 1.0}, {-0.3, 4.0}, {1.5, -2.0}, {0.0, 0.0}}) {
    const world::Look look = sample("lights: {sun: {elevation: " + std::to_string(elevation) +
                                    ", azimuth: " + std::to_string(azimuth) + "}}");
    EXPECT_TRUE(direction(look, 0).isApprox(-towards(elevation, azimuth), 1e-9)) << elevation;
    EXPECT_NEAR(look.lights[0].direction_L.norm(), 1.0, 1e-12);
  }
}

TEST_F(LookSamplerTest, KeepsTheAngleThatHasNoEntry) {
  // The sun shines along (0.3, 0.4, -1): it is 0.5 behind the origin and 1 above it.
  const double azimuth = std::atan2(-0.4, -0.3);
  const double elevation = std::atan(1.0 / 0.5);
  EXPECT_TRUE(direction(sample("lights: {sun: {elevation: 0.2}}"), 0)
                  .isApprox(-towards(0.2, azimuth), 1e-9));
  EXPECT_TRUE(direction(sample("lights: {sun: {azimuth: 0.2}}"), 0)
                  .isApprox(-towards(elevation, 0.2), 1e-9));
}

TEST_F(LookSamplerTest, ShiftsLightsInTheGlobalFrame) {
  const world::Look look = sample("lights: {stage::rig::spot: {shift: [0.5, -1, 2]}}");
  EXPECT_TRUE(look.lights[2].X_WL.translation().isApprox(Vector3d(4.5, 4, 8), 1e-12));
  EXPECT_TRUE(direction(look, 2).isApprox(
      hall().lights[2].X_WL.linear() * hall().lights[2].direction_L, 1e-12));
}

TEST_F(LookSamplerTest, ShiftsNoLightThroughASurface) {
  // From (1, 2, 3) past the origin, around which there is a box of 1 m.
  const world::Look look = sample("lights: {lamp: {shift: [-2, -4, -6]}}");
  const Vector3d before(1, 2, 3);
  const double to_box = 2.5 / 3.0 * before.norm();
  EXPECT_TRUE(look.lights[1].X_WL.translation().isApprox(
      before - (to_box - 0.05) * before.normalized(), 1e-4));
}

TEST_F(LookSamplerTest, LeavesOneLightOnOfThoseThatEveryTurnsOff) {
  const world::Look look = sample("lights: {every: {present: 0}}");
  EXPECT_EQ(look.lights[0].diffuse, hall().lights[0].diffuse);
  EXPECT_EQ(drawn("lights/sun/present"), 1.0);
  EXPECT_TRUE(look.lights[1].diffuse.isZero());
  EXPECT_EQ(drawn("lights/lamp/present"), 0.0);
  EXPECT_TRUE(
      sample("lights: {every: {present: 0}, sun: {present: 1}}").lights[1].diffuse.isZero());
}

TEST_F(LookSamplerTest, ShiftsAlongEachAxisByItself) {
  (void)sample("lights: {lamp: {shift: {uniform: [-1, 1]}}}");
  EXPECT_NE(drawn("lights/lamp/shift", 0), drawn("lights/lamp/shift", 1));
  EXPECT_NE(drawn("lights/lamp/shift", 1), drawn("lights/lamp/shift", 2));
}

TEST_F(LookSamplerTest, TurnsSunlightAndShiftsLampsWithEvery) {
  const world::Look look =
      sample("lights: {every: {elevation: 0.5, azimuth: 1, shift: [1, 0, 0]}}");
  EXPECT_TRUE(direction(look, 0).isApprox(-towards(0.5, 1.0), 1e-9));
  EXPECT_TRUE(look.lights[1].X_WL.translation().isApprox(Vector3d(2, 2, 3), 1e-12));
  EXPECT_EQ(look.lights[2].direction_L, hall().lights[2].direction_L);
  EXPECT_THAT(draws,
              UnorderedElementsAre(Key("lights/sun/elevation"), Key("lights/sun/azimuth"),
                                   Key("lights/lamp/shift"), Key("lights/stage::rig::spot/shift")));
}

TEST_F(LookSamplerTest, TakesEveryForTheLightsThatHaveNoEntryOfTheirOwn) {
  const world::Look look =
      sample("lights: {every: {intensity: {uniform: [2, 4]}}, lamp: {colour: [0.1, 0.1, 0.1]}}");
  EXPECT_THAT(draws, UnorderedElementsAre(Key("lights/sun/intensity"), Key("lights/lamp/colour"),
                                          Key("lights/stage::rig::spot/intensity")));
  EXPECT_NE(drawn("lights/sun/intensity"), drawn("lights/stage::rig::spot/intensity"));
  EXPECT_FLOAT_EQ(look.lights[0].diffuse.x(),
                  0.8F * static_cast<float>(drawn("lights/sun/intensity")));
  EXPECT_EQ(look.lights[1].diffuse, Vector3f(0.1F, 0.1F, 0.1F));
}

TEST_F(LookSamplerTest, DrawsTheSameOfALightByItsNameAndByEvery) {
  (void)sample("lights: {every: {intensity: {uniform: [2, 4]}}}");
  const double by_every = drawn("lights/lamp/intensity");
  (void)sample("lights: {lamp: {intensity: {uniform: [2, 4]}}}");
  EXPECT_EQ(drawn("lights/lamp/intensity"), by_every);
}

TEST_F(LookSamplerTest, DrawsAmbientLightAndBackground) {
  const world::Look look = sample("ambient: {uniform: [0.1, 0.9]}, background: [0.1, 0.2, 0.3]");
  EXPECT_EQ(look.background, Vector3f(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(look.ambient, Vector3f::Constant(static_cast<float>(drawn("ambient")))) << "a grey";
}

// --- How many lights are on ---

TEST_F(LookSamplerTest, TurnsAsManyLightsOnAsAreDrawn) {
  std::map<std::set<std::size_t>, int> times;  // by which were on
  for (int scene = 0; scene < 300; ++scene) {
    const world::Look look = sample("light_count: {choice: [1, 2]}", scene);
    std::set<std::size_t> on;
    for (std::size_t i = 0; i < look.lights.size(); ++i) {
      const bool is_on = look.lights[i].diffuse == hall().lights[i].diffuse;
      if (is_on) on.insert(i);
      EXPECT_TRUE(is_on || look.lights[i].diffuse.isZero());
      EXPECT_EQ(drawn("lights/" + look.lights[i].name + "/present"), is_on ? 1.0 : 0.0);
    }
    EXPECT_EQ(drawn("light_count"), static_cast<double>(on.size()));
    ++times[on];
  }
  ASSERT_EQ(times.size(), 6U) << "each one, and each two";
  for (const auto& [on, count] : times) EXPECT_GT(count, 25) << on.size();
}

TEST_F(LookSamplerTest, RoundsTheNumberOfLights) {
  std::map<double, int> times;
  for (int scene = 0; scene < 300; ++scene) {
    (void)sample("light_count: {uniform: [0.5, 3.5]}", scene);
    ++times[drawn("light_count")];
  }
  EXPECT_THAT(times,
              ElementsAre(testing::Pair(1.0, testing::Gt(70)), testing::Pair(2.0, testing::Gt(70)),
                          testing::Pair(3.0, testing::Gt(70))));
  (void)sample("light_count: 0");
  EXPECT_EQ(drawn("lights/sun/present") + drawn("lights/lamp/present"), 0.0);
}

TEST_F(LookSamplerTest, DrawsTheRestOfLightsWhetherTheyAreOnOrNot) {
  const std::string lights = "lights: {every: {intensity: {uniform: [1, 2]}}}";
  (void)sample(lights);
  const Draws before = draws;
  const world::Look look = sample(lights + ", light_count: 1");
  for (const auto& [name, value] : before) EXPECT_EQ(draws.at(name), value) << name;
  int on = 0;
  for (const world::Light& light : look.lights) on += light.diffuse.isZero() ? 0 : 1;
  EXPECT_EQ(on, 1);
}

TEST_F(LookSamplerTest, RefusesMoreLightsThanTheWorldHas) {
  EXPECT_THAT(errorsOf("light_count: {uniform: [1, 4]}"),
              ElementsAre("randomize/light_count: found up to 4.0; the world has 3 lights, and it "
                          "should be no more (a normal distribution ends at its `max`)"));
  EXPECT_THAT(errorsOf("light_count: {normal: [2, 1]}"),
              ElementsAre(testing::HasSubstr("found up to 1000.0")));
  EXPECT_THAT(errorsOf("light_count: {normal: [2, 1], max: 3}"), IsEmpty());
}

// --- Materials ---

TEST_F(LookSamplerTest, PaintsAllSurfacesOfAVisual) {
  const world::Look look = sample("materials: {rover_1::base_link::hull: {colour: [1, 0.5, 0]}}");
  EXPECT_EQ(colour(look, "rover_1::base_link::hull", 0), Vector3f(1.0F, 0.5F, 0.0F));
  EXPECT_EQ(colour(look, "rover_1::base_link::hull", 1), Vector3f(1.0F, 0.5F, 0.0F));
  EXPECT_TRUE(isGiven(look, "rover_1::base_link::window"));
  EXPECT_TRUE(isGiven(look, "rover_2::base_link::hull"));
}

TEST_F(LookSamplerTest, PaintsForGazeboClassicToo) {
  const world::Look look = sample(
      "materials: {rover_1::base_link::hull: {colour: [1, 0.5, 0], tint: [0.5, 1, 1],"
      " roughness: 0.5}}");
  EXPECT_EQ(worn(look, "rover_1::base_link::hull").ambient, Vector3f(0.5F, 0.5F, 0.0F));
  // 2 / alpha^2 - 2, where alpha is the roughness squared.
  EXPECT_FLOAT_EQ(worn(look, "rover_1::base_link::hull").shininess, 2.0F / 0.0625F - 2.0F);
}

TEST_F(LookSamplerTest, PaintsAModelOrALinkOfIt) {
  const world::Look of_model = sample("materials: {rover_2: {roughness: 0.125}}");
  EXPECT_EQ(worn(of_model, "rover_2::base_link::hull").roughness, 0.125F);
  EXPECT_EQ(worn(of_model, "rover_2::wheel::tyre").roughness, 0.125F);
  EXPECT_TRUE(isGiven(of_model, "rover_1::wheel::tyre"));
  const world::Look of_link = sample("materials: {rover_2::base_link: {metalness: 0.75}}");
  EXPECT_EQ(worn(of_link, "rover_2::base_link::window").metalness, 0.75F);
  EXPECT_TRUE(isGiven(of_link, "rover_2::wheel::tyre"));
}

TEST_F(LookSamplerTest, TellsObjectsFromTheWorld) {
  const world::Look objects = sample("materials: {objects: {roughness: 0.125}}");
  EXPECT_EQ(worn(objects, "rover_1::base_link::hull").roughness, 0.125F);
  EXPECT_EQ(worn(objects, "rover_2::wheel::tyre").roughness, 0.125F);
  EXPECT_TRUE(isGiven(objects, "room::body::floor"));
  EXPECT_TRUE(isGiven(objects, "ball::body::skin"));
  const world::Look surroundings = sample("materials: {world: {roughness: 0.125}}");
  EXPECT_EQ(worn(surroundings, "room::body::floor").roughness, 0.125F);
  EXPECT_EQ(worn(surroundings, "ball::body::skin").roughness, 0.125F);
  EXPECT_TRUE(isGiven(surroundings, "rover_1::base_link::hull"));
}

TEST_F(LookSamplerTest, LetsTheMoreSpecialEntryCount) {
  const world::Look look = sample(
      "materials: {objects: {colour: [0.1, 0, 0], roughness: 0.25}, rover_1: {colour: [0.2, 0, 0]},"
      " rover_1::base_link: {colour: [0.3, 0, 0]},"
      " rover_1::base_link::hull: {colour: [0.4, 0, 0]}}");
  EXPECT_EQ(colour(look, "rover_2::base_link::hull").x(), 0.1F);
  EXPECT_EQ(colour(look, "rover_1::wheel::tyre").x(), 0.2F);
  EXPECT_EQ(colour(look, "rover_1::base_link::window").x(), 0.3F);
  EXPECT_EQ(colour(look, "rover_1::base_link::hull").x(), 0.4F);
  EXPECT_EQ(worn(look, "rover_1::base_link::hull").roughness, 0.25F)
      << "of what the special entries do not speak, the general one counts";
}

TEST_F(LookSamplerTest, DrawsOnceForAModelOrForEachVisual) {
  const std::string grey = "colour: {uniform: [0, 1]}";
  const world::Look each_model = sample("materials: {objects: {for_each: model, " + grey + "}}");
  EXPECT_THAT(draws, UnorderedElementsAre(Key("materials/objects/rover_1/colour"),
                                          Key("materials/objects/rover_2/colour")));
  const Vector3f first = colour(each_model, "rover_1::base_link::hull");
  EXPECT_EQ(first.x(), static_cast<float>(drawn("materials/objects/rover_1/colour")));
  EXPECT_EQ(colour(each_model, "rover_1::wheel::tyre"), first);
  EXPECT_NE(colour(each_model, "rover_2::base_link::hull"), first);

  const world::Look each_visual = sample("materials: {rover_1: {" + grey + "}}");
  EXPECT_THAT(draws,
              UnorderedElementsAre(Key("materials/rover_1/rover_1::base_link::hull/colour"),
                                   Key("materials/rover_1/rover_1::base_link::window/colour"),
                                   Key("materials/rover_1/rover_1::wheel::tyre/colour")));
  EXPECT_EQ(colour(each_visual, "rover_1::base_link::hull", 0),
            colour(each_visual, "rover_1::base_link::hull", 1));
  EXPECT_NE(colour(each_visual, "rover_1::base_link::hull"),
            colour(each_visual, "rover_1::wheel::tyre"));
}

TEST_F(LookSamplerTest, NamesAnEntryOnceWhereItIsForOneThing) {
  (void)sample("materials: {rover_1: {for_each: model, roughness: 0.5}}");
  EXPECT_THAT(draws, ElementsAre(Key("materials/rover_1/roughness")));
  (void)sample("materials: {rover_1::wheel::tyre: {roughness: 0.5}}");
  EXPECT_THAT(draws, ElementsAre(Key("materials/rover_1::wheel::tyre/roughness")));
}

TEST_F(LookSamplerTest, TintsTheColourThatThereIsOrThatWasDrawn) {
  const std::string hull = "rover_1::base_link::hull";
  const world::Look tinted = sample("materials: {rover_1: {tint: [0.5, 1, 0]}}");
  EXPECT_TRUE(colour(tinted, hull).isApprox(Vector3f(0.05F, 0.2F, 0.0F), 1e-6F));
  const world::Look both =
      sample("materials: {rover_1: {colour: [0.4, 0.6, 0.8], tint: [0.5, 1, 0]}}");
  EXPECT_TRUE(colour(both, hull).isApprox(Vector3f(0.2F, 0.6F, 0.0F), 1e-6F));
  EXPECT_EQ(worn(tinted, "rover_1::base_link::window").diffuse.w(), 0.25F);
}

TEST_F(LookSamplerTest, LeavesAlphaAsItIs) {
  const world::Look look = sample("materials: {objects: {colour: [1, 0, 0]}}");
  EXPECT_EQ(worn(look, "rover_1::base_link::window").diffuse, Eigen::Vector4f(1, 0, 0, 0.25F));
}

// --- Textures ---

TEST_F(LookSamplerTest, PutsOnTexturesWhereTheyCanBeSeen) {
  const world::Look look = sample("materials: {world: {textures: procedural}}");
  EXPECT_NE(worn(look, "room::body::floor").texture, nullptr);
  const auto& wall = worn(look, "room::body::wall").texture;
  EXPECT_NE(wall, surface("room::body::wall").material.texture) << "another in place of its own";
  EXPECT_EQ(worn(look, "room::body::fence").texture, surface("room::body::fence").material.texture)
      << "holes are a part of its shape";
  EXPECT_EQ(worn(look, "room::body::rock").texture, nullptr) << "no texture coordinates";
  EXPECT_EQ(std::get<std::string>(draws.at("materials/world/room::body::wall/textures")),
            wall->file);
}

TEST_F(LookSamplerTest, PutsOneTextureOnAModelOrOneOnEachVisual) {
  const world::Look each_model =
      sample("materials: {room: {for_each: model, textures: procedural}}");
  EXPECT_EQ(worn(each_model, "room::body::floor").texture,
            worn(each_model, "room::body::wall").texture);
  const world::Look each_visual = sample("materials: {room: {textures: procedural}}");
  EXPECT_NE(worn(each_visual, "room::body::floor").texture,
            worn(each_visual, "room::body::wall").texture);
}

TEST_F(LookSamplerTest, TakesEachEntrysTexturesFromItsOwnFolder) {
  const test::TemporaryFolder folder;
  for (const char* name : {"dark", "light"}) {
    std::filesystem::create_directory(folder / name);
    cv::imwrite((folder / name / "a.png").string(), cv::Mat(2, 2, CV_8UC3));
  }
  const world::Look look = sample("materials: {objects: {textures: " + (folder / "dark").string() +
                                  "}, rover_1::wheel: {textures: " + (folder / "light").string() +
                                  "}, rover_2: {textures: procedural}, world: {textures: " +
                                  (folder / "light").string() + "}}");
  EXPECT_EQ(worn(look, "rover_1::base_link::hull").texture->file, (folder / "dark/a.png").string());
  EXPECT_EQ(worn(look, "rover_1::wheel::tyre").texture->file, (folder / "light/a.png").string());
  EXPECT_EQ(worn(look, "ball::body::skin").texture->file, (folder / "light/a.png").string());
  const std::set<std::string> kinds = {"checkers", "stripes", "dots", "gradient", "clouds"};
  EXPECT_THAT(kinds, Contains(worn(look, "rover_2::base_link::hull").texture->file));
}

TEST_F(LookSamplerTest, NamesTheEntryOfAPictureThatCannotBeDecoded) {
  const test::TemporaryFolder folder;
  folder.write("broken.png", "no picture");
  EXPECT_THAT(
      errorsOf("materials: {objects: {textures: " + folder.path().string() +
               "}, world: {textures: " + folder.path().string() +
               "}}, background: {pictures: " + folder.path().string() + "}"),
      UnorderedElementsAre(testing::HasSubstr("randomize/materials/objects/textures: picture '"),
                           testing::HasSubstr("randomize/materials/world/textures: picture '"),
                           testing::HasSubstr("randomize/background/pictures: picture '")));
}

TEST_F(LookSamplerTest, NamesTheEntryOfAPictureThatCannotBeDecodedAfterAll) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "a.png").string();
  cv::imwrite(file, cv::Mat(2, 2, CV_8UC3));
  Parameters root(base::parseYaml(
      "randomize: {materials: {world: {textures: " + folder.path().string() + "}}}", "test"));
  LookSampler sampler(config::readRandomization(root), world);
  std::filesystem::remove(file);
  EntryDraws entry_draws(1, 0);
  EXPECT_THAT(test::messagesOf([&] { (void)sampler.sample(entry_draws); }),
              testing::ElementsAre("randomize/materials/world/textures: " + file +
                                   ": no such file, or it cannot be read"));
}

// --- Draws ---

constexpr char kMuch[] =
    "lights: {sun: {intensity: {uniform: [0, 2]}, azimuth: {uniform: [-3, 3]}}, "
    "lamp: {present: 0.5}}, ambient: {uniform: [0, 1]}, materials: {objects: "
    "{colour: {uniform: [0, 1]}, textures: procedural}, ball: {roughness: {uniform: [0, 1]}}}";

TEST_F(LookSamplerTest, DrawsTheSameForTheSameSeedAndScene) {
  (void)sample(kMuch, 3);
  const Draws first = draws;
  EXPECT_EQ(first.size(), 4U + 6U * 2U + 1U);
  (void)sample(kMuch, 3);
  EXPECT_EQ(draws, first);
  (void)sample(kMuch, 4);
  EXPECT_NE(draws.at("lights/sun/intensity"), first.at("lights/sun/intensity"));
  (void)sample(kMuch, 3, 2);
  EXPECT_NE(draws.at("lights/sun/intensity"), first.at("lights/sun/intensity"));
}

/// One sampler draws the scenes one after the other, in whatever order they are made.
TEST_F(LookSamplerTest, DrawsASceneTheSameWhateverItDrewBefore) {
  Parameters root(base::parseYaml(std::string("randomize: {") + kMuch + "}", "test"));
  LookSampler sampler(config::readRandomization(root), world);
  for (const std::int64_t scene : {5, 2, 9, 2, 5}) {
    EntryDraws entry_draws(1, scene);
    const world::Look look = sampler.sample(entry_draws);
    const world::Look alone = sample(kMuch, scene);
    EXPECT_EQ(look.ambient, alone.ambient);
    EXPECT_EQ(look.lights[0].diffuse, alone.lights[0].diffuse);
    EXPECT_EQ(cv::norm(worn(look, "rover_1::wheel::tyre").texture->pixels,
                       worn(alone, "rover_1::wheel::tyre").texture->pixels, cv::NORM_INF),
              0.0);
  }
}

TEST_F(LookSamplerTest, DrawsAnEntryTheSameWhateverOthersThereAre) {
  (void)sample(kMuch, 3);
  const Draws all = draws;
  const std::vector<std::string> fewer = {
      "lights: {sun: {azimuth: {uniform: [-3, 3]}}}",
      "lights: {lamp: {present: 0.5}, sun: {azimuth: {uniform: [-3, 3]}, intensity: 7}}",
      "ambient: {uniform: [0, 1]}, background: {uniform: [0, 1]}",
      "materials: {ball: {roughness: {uniform: [0, 1]}}}",
      "materials: {objects: {textures: procedural}, rover_1: {textures: procedural}}"};
  for (const std::string& entries : fewer) {
    (void)sample(entries, 3);
    int compared = 0;
    for (const auto& [name, value] : draws) {
      if (all.count(name) == 0 || name == "lights/sun/intensity") continue;
      EXPECT_EQ(value, all.at(name)) << name << " of " << entries;
      ++compared;
    }
    EXPECT_GT(compared, 0) << entries;
  }
}

// --- Invalid entries ---

TEST_F(LookSamplerTest, NamesALightThatTheWorldDoesNotHave) {
  EXPECT_THAT(
      errorsOf("lights: {lampp: {intensity: 2}}"),
      ElementsAre("randomize/lights/lampp: the world has no light of this name; did you mean "
                  "'lamp'?"));
  EXPECT_THAT(errorsOf("lights: {moonlight: {intensity: 2}}"),
              ElementsAre("randomize/lights/moonlight: the world has no light of this name"));
  EXPECT_THAT(errorsOf("lights: {every: {intensity: 2}}"), IsEmpty());
}

TEST_F(LookSamplerTest, NamesWhatALightCannotDo) {
  EXPECT_THAT(errorsOf("lights: {sun: {shift: 1}}"),
              ElementsAre("randomize/lights/sun/shift: a directional light has no place; elevation "
                          "and azimuth turn it"));
  EXPECT_THAT(errorsOf("lights: {stage::rig::spot: {azimuth: 1}}"),
              ElementsAre("randomize/lights/stage::rig::spot/elevation, azimuth: only directional "
                          "lights are turned; shift moves a light that has a position"));
}

TEST_F(LookSamplerTest, NamesAModelLinkOrVisualThatTheWorldDoesNotHave) {
  const std::string problem =
      ": the world has nothing visible of this name; it should be objects, "
      "distractors, world, a model, model::link or model::link::visual";
  EXPECT_THAT(errorsOf("materials: {rovr_1: {colour: 0.5}}"),
              ElementsAre("randomize/materials/rovr_1" + problem + "; did you mean 'rover_1'?"));
  EXPECT_THAT(errorsOf("materials: {object: {colour: 0.5}}"),
              ElementsAre("randomize/materials/object" + problem + "; did you mean 'objects'?"));
  EXPECT_THAT(errorsOf("materials: {rover_1::whel: {colour: 0.5}}"),
              Contains(testing::StartsWith("randomize/materials/rover_1::whel" + problem)));
  EXPECT_THAT(errorsOf("materials: {hull: {colour: 0.5}}"),
              ElementsAre("randomize/materials/hull" + problem));
}

TEST_F(LookSamplerTest, TakesAKindOfThingOfWhichThereIsNone) {
  EXPECT_THAT(errorsOf("materials: {distractors: {colour: 0.5}}"), IsEmpty());
}

TEST_F(LookSamplerTest, NamesAFolderWithoutPictures) {
  EXPECT_THAT(errorsOf("materials: {objects: {textures: /nowhere}}"),
              ElementsAre("randomize/materials/objects/textures: found '/nowhere': No such file or "
                          "directory"));
}

TEST_F(LookSamplerTest, NamesAllErrorsAtOnce) {
  EXPECT_EQ(errorsOf("lights: {a1: {intensity: 2}, b2: {intensity: 2}}, materials: {c3: {colour: "
                     "0.5}, world: {textures: /nowhere}}")
                .size(),
            4U);
}

}  // namespace look_sampler_test
}  // namespace synthetic_dataset::randomize
