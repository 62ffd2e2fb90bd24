#include "config/readers.h"

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace distractor_config_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Reading {
  explicit Reading(const std::string& yaml) : root(base::parseYaml(yaml, "test"), "randomize") {
    distractors = readDistractors(root);
  }
  Parameters root;
  std::optional<randomize::DistractorOptions> distractors;
};

TEST(DistractorConfig, IsNothingWithoutItsGroup) {
  EXPECT_FALSE(Reading("{}").distractors.has_value());
}

TEST(DistractorConfig, NeedsNothingButAVolume) {
  const Reading reading("distractors: {volume: {min: [-1, -2, 0], max: [1, 2, 3]}}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  ASSERT_TRUE(reading.distractors);
  EXPECT_EQ(reading.distractors->pool, 24);
  EXPECT_EQ(reading.distractors->mode, randomize::DistractorMode::kFly);
  EXPECT_EQ(reading.distractors->textures, "procedural");
  EXPECT_EQ(reading.distractors->volume->low, Eigen::Vector3d(-1, -2, 0));
  EXPECT_EQ(reading.distractors->volume->high, Eigen::Vector3d(1, 2, 3));
}

TEST(DistractorConfig, TakesWordsForTexturesThatAreMadeUp) {
  for (const std::string word : {"natural", "procedural", "none"}) {
    const Reading reading(
        "distractors: {volume: {min: [0, 0, 0], max: [1, 1, 1]}, textures: " + word + "}");
    EXPECT_THAT(reading.root.errors(), IsEmpty());
    EXPECT_EQ(reading.distractors->textures, word);
  }
}

TEST(DistractorConfig, ReadsEverySetting) {
  const Reading reading(
      "distractors: {volume: {min: [0, 0, 0], max: [1, 1, 1]}, pool: 5, count: 3, mode: stand, "
      "size: {uniform: [0.1, 0.2]}, textures: none, tries: 7}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.root.unknownNames(), IsEmpty());
  ASSERT_TRUE(reading.distractors);
  EXPECT_EQ(reading.distractors->pool, 5);
  EXPECT_EQ(reading.distractors->count.lowest(), 3.0);
  EXPECT_EQ(reading.distractors->size.highest(), 0.2);
  EXPECT_EQ(reading.distractors->mode, randomize::DistractorMode::kStand);
  EXPECT_EQ(reading.distractors->textures, "none");
  EXPECT_EQ(reading.distractors->tries, 7);
}

TEST(DistractorConfig, TakesModelsInsteadOfShapes) {
  const Reading reading(
      "distractors: {volume: {min: [0, 0, 0], max: [1, 1, 1]}, models: [model://cup, /tmp/box]}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.distractors->models, ElementsAre("model://cup", "/tmp/box"));
}

TEST(DistractorConfig, TellsWhatIsWrong) {
  const std::string volume = "volume: {min: [0, 0, 0], max: [1, 1, 1]}";
  const auto errorsOf = [&](const std::string& settings) {
    return Reading("distractors: {" + settings + "}").root.errors();
  };
  EXPECT_THAT(errorsOf("volume: {min: [0, 0, 0]}"),
              Contains(HasSubstr("randomize/distractors/volume/max: required, but missing")));
  EXPECT_THAT(errorsOf(volume + ", mode: hover"),
              Contains(HasSubstr("mode: found 'hover'; it should be fly, stand or drop")));
  EXPECT_THAT(errorsOf(volume + ", pool: 0"), Contains(HasSubstr("pool: found 0")));
  EXPECT_THAT(errorsOf(volume + ", mode: dropp"),
              Contains(HasSubstr("found 'dropp'; it should be fly, stand or drop; did you mean "
                                 "'drop'?")));
  EXPECT_THAT(errorsOf(volume + ", fall_time: 5"),
              Contains(HasSubstr("fall_time: has a meaning with mode: drop alone")));
  EXPECT_THAT(errorsOf(volume + ", mode: drop, fall_time: 2"),
              Contains(HasSubstr("distractors/fall_time: found 2")));
  EXPECT_THAT(errorsOf(volume + ", count: -1"), Contains(HasSubstr("distractors/count: found -1")));
  EXPECT_THAT(errorsOf(volume + ", size: 0"), Contains(HasSubstr("distractors/size: found 0")));
  EXPECT_THAT(errorsOf("volume: {min: [0, 0, 2], max: [1, 1, 1]}"),
              Contains(HasSubstr("volume: found a min above the max")));
}

}  // namespace distractor_config_test
}  // namespace synthetic_dataset::config
