#include "config/readers.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>

#include "base/yaml_value.h"
#include "config/config.h"

namespace synthetic_dataset::config {
namespace randomization_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::UnorderedElementsAre;

using Optional = std::optional<base::Distribution>;

Parameters settings(const std::string& yaml) { return Parameters(base::parseYaml(yaml, "test")); }

/// Reads a `randomize` in which nothing should be wrong or unknown.
randomize::Randomization read(const std::string& randomize) {
  Parameters root = settings("randomize: " + randomize);
  randomize::Randomization randomization = readRandomization(root);
  EXPECT_THAT(root.errors(), IsEmpty()) << randomize;
  EXPECT_THAT(root.unknownNames(), IsEmpty()) << randomize;
  return randomization;
}

std::vector<std::string> errorsOf(const std::string& randomize) {
  Parameters root = settings("randomize: " + randomize);
  (void)readRandomization(root);
  return root.errors();
}

/// The only error of a group with one entry; the group is "lights/sun" or "sensor", for example.
std::string errorOf(const std::string& group, const std::string& entry) {
  const bool is_flat = group.find('/') == std::string::npos;
  const auto errors =
      errorsOf(is_flat ? "{" + group + ": {" + entry + "}}"
                       : "{" + group.substr(0, group.find('/')) + ": {" +
                             group.substr(group.find('/') + 1) + ": {" + entry + "}}}");
  EXPECT_EQ(errors.size(), 1U) << entry;
  if (errors.empty()) return "no error";
  const std::string prefix = "randomize/" + group + "/";
  EXPECT_EQ(errors.front().substr(0, prefix.size()), prefix);
  return errors.front().substr(prefix.size());
}

void expectRange(const Optional& distribution, std::size_t dimension, double low, double high) {
  ASSERT_TRUE(distribution);
  EXPECT_EQ(distribution->dimension(), dimension);
  EXPECT_DOUBLE_EQ(distribution->lowest(), low);
  EXPECT_DOUBLE_EQ(distribution->highest(), high);
}

TEST(Randomization, IsNothingWhereNothingIsGiven) {
  const randomize::Randomization none = readRandomization(settings("seed: 1"));
  EXPECT_FALSE(none.changesLook());
  EXPECT_THAT(none.lights, IsEmpty());
  EXPECT_THAT(none.materials, IsEmpty());
  EXPECT_FALSE(none.sensor.exposure || none.sensor.blur || none.sensor.noise_stddev);
}

TEST(Randomization, ReadsAllOfALight) {
  const randomize::Randomization given = read(
      "{lights: {sun: {present: 0.75, intensity: {uniform: [0.5, 2]}, colour: {uniform: [[1, 1, 1],"
      " [1, 2, 3]]}, elevation: {uniform: [0.2, 1.5]}, azimuth: {uniform: [-3, 3]}, shift: "
      "{uniform: [-2, 1]}}}}");
  ASSERT_THAT(given.lights, ElementsAre(Key("sun")));
  const randomize::LightRandomization& sun = given.lights.at("sun");
  EXPECT_EQ(sun.present, 0.75);
  expectRange(sun.intensity, 1, 0.5, 2.0);
  expectRange(sun.colour, 3, 1.0, 3.0);
  expectRange(sun.elevation, 1, 0.2, 1.5);
  expectRange(sun.azimuth, 1, -3.0, 3.0);
  expectRange(sun.shift, 3, -2.0, 1.0);
}

TEST(Randomization, LeavesOutWhatALightDoesNotHave) {
  const randomize::Randomization given =
      read("{lights: {sun: {intensity: 2}, every: {azimuth: 1}}}");
  EXPECT_THAT(given.lights, UnorderedElementsAre(Key("sun"), Key("every")));
  const randomize::LightRandomization& sun = given.lights.at("sun");
  EXPECT_FALSE(sun.present || sun.colour || sun.elevation || sun.azimuth || sun.shift);
  EXPECT_FALSE(given.lights.at("every").intensity);
}

TEST(Randomization, ReadsAllOfAMaterial) {
  const randomize::Randomization given = read(
      "{materials: {'rover::base_link': {for_each: model, colour: {uniform: [0, 1]}, tint: "
      "{uniform: [0.5, 1]}, roughness: "
      "{uniform: [0.25, 0.75]}, metalness: {choice: [0, 1]}, textures: procedural}}}");
  ASSERT_THAT(given.materials, ElementsAre(Key("rover::base_link")));
  const randomize::MaterialRandomization& material = given.materials.at("rover::base_link");
  EXPECT_FALSE(material.for_each_visual);
  expectRange(material.colour, 3, 0.0, 1.0);
  expectRange(material.tint, 3, 0.5, 1.0);
  expectRange(material.roughness, 1, 0.25, 0.75);
  expectRange(material.metalness, 1, 0.0, 1.0);
  EXPECT_EQ(material.textures, "procedural");
}

TEST(Randomization, DrawsForEachVisualUnlessItIsToldOtherwise) {
  const randomize::Randomization given =
      read("{materials: {objects: {colour: 0.5}, world: {for_each: visual}}}");
  EXPECT_TRUE(given.materials.at("objects").for_each_visual);
  EXPECT_TRUE(given.materials.at("world").for_each_visual);
  EXPECT_FALSE(given.materials.at("objects").textures);
}

TEST(Randomization, MakesAFolderOfTexturesAbsolute) {
  const auto texturesOf = [](const std::string& given) {
    return read("{materials: {objects: {textures: " + given + "}}}")
        .materials.at("objects")
        .textures;
  };
  EXPECT_EQ(texturesOf("natural"), "natural");
  EXPECT_EQ(texturesOf("/data/x/../textures"), "/data/textures");
  EXPECT_EQ(texturesOf("textures"), (std::filesystem::current_path() / "textures").string());
}

TEST(Randomization, ReadsHowLikelyObjectsAreThere) {
  const randomize::Randomization given =
      read("{objects: {every: {present: 0.5}, rover_1: {present: 1}}}");
  EXPECT_EQ(given.ofObject("rover_1").present, 1.0);
  EXPECT_EQ(given.ofObject("rover_2").present, 0.5);
  EXPECT_FALSE(read("{objects: {rover_1: {present: 1}}}").ofObject("rover_2").present);
  EXPECT_FALSE(given.changesLook());
  EXPECT_THAT(errorsOf("{objects: {rover_1: {present: 1.5}}}"),
              ElementsAre("randomize/objects/rover_1/present: found 1.5; it should be 0.0 to 1.0"));
}

TEST(Randomization, ReadsWhatObjectsWear) {
  const randomize::Randomization given = read(
      "{objects: {every: {scale: {uniform: [0.5, 2]}, sizes: 3}, rover_1: {model: {choice: "
      "['model://a', /data/b.sdf], weights: [1, 3]}, scale: {choice: [1, 2]}}}}");
  const randomize::ObjectRandomization rover = given.ofObject("rover_1");
  EXPECT_THAT(rover.model->texts, ElementsAre("model://a", "/data/b.sdf"));
  EXPECT_THAT(rover.model->weights, ElementsAre(1.0, 3.0));
  expectRange(rover.scale, 1, 1.0, 2.0);
  const randomize::ObjectRandomization other = given.ofObject("rover_2");
  EXPECT_FALSE(other.model);
  expectRange(other.scale, 1, 0.5, 2.0);
  EXPECT_EQ(other.sizes, 3);
  EXPECT_EQ(read("{objects: {a: {scale: {uniform: [1, 2]}}}}").ofObject("a").sizes, 8);
  EXPECT_EQ(read("{objects: {a: {model: rover.sdf}}}").ofObject("a").model->texts.at(0),
            (std::filesystem::current_path() / "rover.sdf").string());
}

TEST(Randomization, ReadsTheVarietyOfObjects) {
  using randomize::Variety;
  const randomize::Randomization given = read(
      "{variety: same_class, objects: {every: {present: 0.5}, a: {variety: same_object, variants: "
      "5}, b: {variants: 3}, c: {variety: none}}}");
  EXPECT_EQ(given.ofObject("a").variety->variety, Variety::kSameObject);
  EXPECT_EQ(given.ofObject("a").variety->variants, 5);
  EXPECT_EQ(given.ofObject("b").variety->variety, Variety::kSameClass);
  EXPECT_EQ(given.ofObject("b").variety->variants, 3);
  EXPECT_EQ(given.ofObject("c").variety->variety, Variety::kNone);
  EXPECT_EQ(given.ofObject("other").variety->variety, Variety::kSameClass) << "of `every`";
  EXPECT_EQ(given.ofObject("other").variety->variants, 12);
  EXPECT_EQ(read("{variety: same_object, variants: 4}").ofObject("a").variety->variants, 4);
  EXPECT_EQ(read("{objects: {a: {present: 1}}}").ofObject("b").variety->variety, Variety::kNone);
}

TEST(Randomization, NamesVarietiesThatThereAreNot) {
  EXPECT_THAT(errorOf("objects/a", "variety: same_clas"), HasSubstr("same_object"));
  EXPECT_THAT(errorOf("objects/a", "variety: same_class, variants: 0"),
              HasSubstr("variants: found 0; it should be"));
  EXPECT_THAT(errorOf("objects/a", "variants: 3"), HasSubstr("variants: has a meaning beside"));
}

TEST(Randomization, NamesWhatObjectsCannotWear) {
  EXPECT_THAT(errorOf("objects/a", "scale: {uniform: [0, 2]}"), HasSubstr("scale: found uniform"));
  EXPECT_THAT(errorOf("objects/a", "scale: {uniform: [1, 2]}, sizes: 0"),
              HasSubstr("sizes: found 0; it should be"));
  EXPECT_THAT(errorOf("objects/a", "scale: {choice: [1, 2]}, sizes: 3"),
              HasSubstr("sizes: has a meaning beside a scale that is drawn from a range"));
  EXPECT_THAT(errorOf("objects/a", "sizes: 3"), HasSubstr("sizes: has a meaning"));
  EXPECT_THAT(errorOf("objects/a", "model: 'param:/robot_description'"),
              HasSubstr("model: found a model that is not a file"));
  EXPECT_THAT(errorOf("objects/a", "model: '<robot/>'"), HasSubstr("model: found a model that is"));
}

TEST(Randomization, ReadsAmbientLightAndBackground) {
  const randomize::Randomization given =
      read("{ambient: {uniform: [0.25, 0.5]}, background: [0, 0.5, 1]}");
  expectRange(given.ambient, 3, 0.25, 0.5);
  expectRange(given.background.colour, 3, 0.0, 1.0);
  EXPECT_EQ(given.background.colour_name, "background");
  EXPECT_FALSE(given.background.pictures);
}

TEST(Randomization, ReadsHowManyLightsAreOn) {
  EXPECT_FALSE(read("{lights: {sun: {present: 0.5}}}").light_count);
  expectRange(read("{light_count: {choice: [1, 2, 4]}}").light_count, 1, 1.0, 4.0);
  const randomize::Randomization given = read("{lights: {light_count: {present: 0.5}}}");
  EXPECT_THAT(given.lights, ElementsAre(Key("light_count"))) << "a light may be called so";
  EXPECT_FALSE(given.light_count);
}

TEST(Randomization, ReadsHowManyObjectsAreThere) {
  EXPECT_FALSE(read("{objects: {every: {present: 0.5}}}").object_count);
  expectRange(read("{object_count: {choice: [0, 3]}}").object_count, 1, 0.0, 3.0);
  EXPECT_THAT(
      errorsOf("{object_count: 1, objects: {alpha: {present: 0.5}}}"),
      ElementsAre("randomize/object_count: found it beside objects/alpha/present; it should "
                  "be one of the two, since each says which objects are there"));
}

TEST(Randomization, RefusesACountOfLightsBesideLightsThatAreOnByChance) {
  EXPECT_THAT(errorsOf("{light_count: 1, lights: {sun: {intensity: 2}, every: {present: 0.5}}}"),
              ElementsAre("randomize/light_count: found it beside lights/every/present; it should "
                          "be one of the two, since each says which lights are on"));
  EXPECT_THAT(errorsOf("{light_count: -1}"),
              ElementsAre("randomize/light_count: found -1; it should be 0.0 to 1000.0"));
}

TEST(Randomization, ReadsAllOfASensor) {
  const randomize::Randomization given = read(
      "{sensor: {exposure: {normal: [0, 1]}, blur: {uniform: [0, 1.5]}, noise_stddev: {uniform: "
      "[0.01, 0.02]}, white_balance: {uniform: [5000, 8000]}, jpeg_quality: {uniform: [40, 95]}}}");
  expectRange(given.sensor.exposure, 1, -10.0, 10.0);
  expectRange(given.sensor.blur, 1, 0.0, 1.5);
  expectRange(given.sensor.noise_stddev, 1, 0.01, 0.02);
  expectRange(given.sensor.white_balance, 1, 5000.0, 8000.0);
  expectRange(given.sensor.jpeg_quality, 1, 40.0, 95.0);
}

TEST(Randomization, ReadsAllOfTheWeather) {
  const randomize::WeatherRandomization weather =
      read(
          "{weather: {present: 0.3, visibility: {log_uniform: [20, 500]}, rain: {uniform: [1, "
          "60]}, "
          "snow: 2, wind: {normal: [[0, 0, 0], [2, 2, 0]]}, colour: {uniform: [0.6, 0.9]}, dust: "
          "{uniform: [0, 0.1]}}}")
          .weather;
  EXPECT_EQ(weather.present, 0.3);
  expectRange(weather.visibility, 1, 20.0, 500.0);
  expectRange(weather.rain, 1, 1.0, 60.0);
  expectRange(weather.snow, 1, 2.0, 2.0);
  expectRange(weather.wind, 3, -100.0, 100.0);
  expectRange(weather.colour, 3, 0.6, 0.9);
  expectRange(weather.dust, 1, 0.0, 0.1);
  EXPECT_TRUE(weather.changesAir());
  EXPECT_FALSE(read("{weather: {dust: 0.1}}").weather.changesAir());
  EXPECT_FALSE(read("{}").weather.changesAir());
}

TEST(Randomization, RefusesWeatherOutOfRange) {
  EXPECT_EQ(errorOf("weather", "visibility: 0"),
            "visibility: found 0; it should be 1.0 to 1000000.0");
  EXPECT_EQ(errorOf("weather", "rain: -1"), "rain: found -1; it should be 0.0 to 500.0");
  EXPECT_EQ(errorOf("weather", "snow: {uniform: [0, 900]}"),
            "snow: found uniform: [0, 900]; it should be 0.0 to 20.0");
  EXPECT_EQ(errorOf("weather", "dust: 0.3"), "dust: found 0.3; it should be 0.0 to 0.2");
  EXPECT_EQ(errorOf("weather", "wind: [0, 0, 0]"),
            "wind: has a meaning with visibility, rain or snow alone");
}

TEST(Randomization, ChangesTheLookUnlessItIsOfSensorsAlone) {
  EXPECT_FALSE(read("{sensor: {exposure: 1}}").changesLook());
  EXPECT_TRUE(read("{lights: {sun: {intensity: 1}}}").changesLook());
  EXPECT_TRUE(read("{materials: {world: {roughness: 1}}}").changesLook());
  EXPECT_TRUE(read("{ambient: 1}").changesLook());
  EXPECT_TRUE(read("{background: 1}").changesLook());
  EXPECT_TRUE(read("{background: {pictures: /data}}").changesLook());
  EXPECT_TRUE(read("{light_count: 1}").changesLook());
}

TEST(Randomization, ShiftsEachAxisByItselfAndTintsAllChannelsAlike) {
  const randomize::Randomization given =
      read("{lights: {lamp: {shift: {uniform: [-1, 1]}, colour: {uniform: [0, 1]}}}}");
  base::RandomSource source(1);
  const auto shift = given.lights.at("lamp").shift->draw(source);
  EXPECT_NE(shift[0], shift[1]);
  EXPECT_NE(shift[1], shift[2]);
  const auto colour = given.lights.at("lamp").colour->draw(source);
  EXPECT_EQ(colour[0], colour[1]);
  EXPECT_EQ(colour[1], colour[2]);
}

// --- Errors ---

TEST(Randomization, RefusesAProbabilityThatIsNone) {
  const std::string group = "lights/sun";
  EXPECT_EQ(errorOf(group, "present: 1.5"), "present: found 1.5; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf(group, "present: -0.1"), "present: found -0.1; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf(group, "present: .nan").substr(0, 14), "present: found");
  EXPECT_EQ(errorOf(group, "present: maybe").substr(0, 14), "present: found");
}

TEST(Randomization, RefusesLightOutOfRange) {
  const std::string group = "lights/sun";
  EXPECT_EQ(errorOf(group, "intensity: -1"), "intensity: found -1; it should be 0.0 to 1000000.0");
  EXPECT_EQ(errorOf(group, "colour: [1, 1, -1]"),
            "colour: found [1, 1, -1]; it should be 0.0 to 1000000.0");
  EXPECT_EQ(errorOf(group, "colour: {uniform: [[0, 0], 1]}"),
            "colour: found uniform: [[0, 0], 1]; it should be [low, high], each a number or a list "
            "of 3");
  EXPECT_THAT(errorOf(group, "elevation: 1.6"),
              HasSubstr("elevation: found 1.6; it should be -1.57"));
  EXPECT_THAT(errorOf(group, "elevation: 45"), HasSubstr("rad (degrees are written deg(20))"));
  EXPECT_THAT(errorOf(group, "azimuth: {uniform: [0, 360]}"),
              HasSubstr("azimuth: found uniform: [0, 360]; it should be -6.28"));
  EXPECT_THAT(errorOf(group, "shift: [1, 2]"),
              HasSubstr("shift: found [1, 2] (a list); it should be a number or a list of 3"));
}

TEST(Randomization, AllowsTheEndsOfItsRanges) {
  (void)read(
      "{lights: {a: {present: 0, intensity: 0}, b: {present: 1, elevation: 1.5707}}, "
      "materials: {world: {colour: 1, roughness: 0, metalness: 1}}, sensor: {exposure: -10, "
      "blur: 50, noise_stddev: 1, white_balance: 25000, jpeg_quality: 100}}");
}

TEST(Randomization, RefusesMaterialsOutOfRange) {
  const std::string group = "materials/objects";
  EXPECT_EQ(errorOf(group, "colour: {uniform: [0, 255]}"),
            "colour: found uniform: [0, 255]; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf(group, "roughness: 1.1"), "roughness: found 1.1; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf(group, "metalness: -0.1"), "metalness: found -0.1; it should be 0.0 to 1.0");
  EXPECT_EQ(errorOf(group, "for_each: link"),
            "for_each: found 'link'; it should be visual or model");
  EXPECT_THAT(errorOf(group, "textures: [a, b]"), HasSubstr("textures: found "));
}

TEST(Randomization, RefusesSensorsOutOfRange) {
  EXPECT_EQ(errorOf("sensor", "exposure: 11"), "exposure: found 11; it should be -10.0 to 10.0");
  EXPECT_EQ(errorOf("sensor", "blur: -1"), "blur: found -1; it should be 0.0 to 50.0");
  EXPECT_EQ(errorOf("sensor", "noise_stddev: {uniform: [0, 2]}"),
            "noise_stddev: found uniform: [0, 2]; it should be 0.0 to 1.0");
}

TEST(Randomization, RefusesColoursOfTheWorldOutOfRange) {
  EXPECT_THAT(errorsOf("{ambient: 2}"),
              ElementsAre("randomize/ambient: found 2; it should be 0.0 to 1.0"));
  EXPECT_THAT(errorsOf("{background: [0, 0, 2]}"),
              ElementsAre("randomize/background: found [0, 0, 2]; it should be 0.0 to 1.0"));
}

TEST(Randomization, RefusesWhatIsNoGroup) {
  for (const char* text : {"5", "{lights: 5}", "{lights: {sun: 5}}", "{materials: [a]}",
                           "{materials: {objects: red}}", "{sensor: 1}"}) {
    EXPECT_EQ(errorsOf(text).size(), 1U) << text;
  }
}

TEST(Randomization, FindsAllErrorsAtOnce) {
  EXPECT_THAT(
      errorsOf("{lights: {sun: {present: 2, intensity: -1}}, ambient: red, sensor: {blur: "
               "-1}}"),
      UnorderedElementsAre(HasSubstr("randomize/lights/sun/present: "),
                           HasSubstr("randomize/lights/sun/intensity: "),
                           HasSubstr("randomize/ambient: "), HasSubstr("randomize/sensor/blur: ")));
}

TEST(Randomization, KnowsNoOtherEntries) {
  Parameters root = settings(
      "randomize: {lihgts: {sun: {intensity: 1}}, lights: {sun: {intensty: 1}}, materials: "
      "{objects: {color: 1}}, sensor: {gain: 2}}");
  (void)readRandomization(root);
  EXPECT_THAT(root.unknownNames(),
              UnorderedElementsAre("randomize/lihgts", "randomize/lights/sun/intensty",
                                   "randomize/materials/objects/color", "randomize/sensor/gain"));
  const auto errors = unknownParameterErrors(root, root.unknownNames());
  EXPECT_THAT(
      errors,
      Contains("randomize/lights/sun/intensty: unknown parameter; did you mean 'intensity'?"));
}

TEST(Randomization, OfTheFieldOfViewIsAnAngle) {
  const auto sensor = read("{sensor: {field_of_view: {uniform: [0.6, 1.4]}}}").sensor;
  expectRange(sensor.field_of_view, 1, 0.6, 1.4);
  EXPECT_FALSE(read("{sensor: {blur: 1}}").sensor.field_of_view);
  EXPECT_THAT(errorOf("sensor", "field_of_view: 0"), HasSubstr("it should be 0.01 to 6.28"));
  EXPECT_THAT(errorOf("sensor", "field_of_view: {uniform: [1, 7]}"), HasSubstr("0.01 to 6.28"));
}

}  // namespace randomization_test
}  // namespace synthetic_dataset::config
