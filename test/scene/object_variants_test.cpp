#include "scene/object_variants.h"

#include <cmath>
#include <map>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::scene {
namespace object_variants_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ObjectVariantsTest : public ::testing::Test {
 protected:
  ObjectVariantsTest() {
    object.name = "rover";
    object.model = "own.sdf";
  }

  [[nodiscard]] ObjectVariants make() const {
    randomize::Randomization randomization;
    randomization.objects["rover"] = entry;
    return {object, randomization};
  }

  /// How often each variant is worn in this many scenes.
  [[nodiscard]] std::map<std::size_t, int> wornIn(int scenes) const {
    const ObjectVariants variants = make();
    std::map<std::size_t, int> worn;
    for (int scene = 0; scene < scenes; ++scene) {
      randomize::EntryDraws draws(7, scene);
      ++worn[variants.draw(draws)];
    }
    return worn;
  }

  ObjectOptions object;
  randomize::ObjectRandomization entry;
};

std::vector<double> sizesOf(const ObjectVariants& variants) {
  std::vector<double> sizes;
  for (const ObjectVariant& variant : variants.all()) sizes.push_back(variant.scale);
  return sizes;
}

TEST_F(ObjectVariantsTest, WithoutDrawsThereIsTheModelAsItIs) {
  const ObjectVariants variants = make();
  ASSERT_EQ(variants.all().size(), 1U);
  EXPECT_EQ(variants.all()[0].model, "own.sdf");
  EXPECT_EQ(variants.all()[0].scale, 1.0);
  randomize::EntryDraws draws(1, 2);
  EXPECT_EQ(variants.draw(draws), 0U);
  EXPECT_THAT(draws.values(), IsEmpty());
}

TEST_F(ObjectVariantsTest, AreAllModelsInAllSizes) {
  entry.model = base::TextChoice{{"a", "b", "a"}, {}};
  entry.scale = base::Distribution::choice({{2.0}, {0.5}});
  std::vector<std::pair<std::string, double>> all;
  const ObjectVariants variants = make();
  for (const ObjectVariant& variant : variants.all())
    all.emplace_back(*variant.model, variant.scale);
  EXPECT_THAT(all, ElementsAre(std::pair("a", 0.5), std::pair("a", 2.0), std::pair("b", 0.5),
                               std::pair("b", 2.0)));
}

TEST_F(ObjectVariantsTest, OfOneThatIsNotThereThereIsNothingToDraw) {
  object.takes_part = false;
  entry.model = base::TextChoice{{"a", "b"}, {}};
  EXPECT_EQ(make().all().size(), 1U);
}

/// They are the middles of equal parts of the range.
TEST_F(ObjectVariantsTest, SizesOfARangeAreAllOverIt) {
  entry.scale = base::Distribution::uniform({1.0}, {2.0});
  entry.sizes = 4;
  const std::vector<double> sizes = sizesOf(make());
  ASSERT_EQ(sizes.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sizes[i], 1.125 + 0.25 * double(i), 0.03);
  entry.scale = base::Distribution::logUniform({0.25}, {4.0});
  const std::vector<double> logarithmic = sizesOf(make());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::log2(logarithmic[i]), -1.5 + double(i), 0.1);
  }
}

TEST_F(ObjectVariantsTest, OfARangeEachSizeIsAsLikelyAsTheOthers) {
  entry.sizes = 5;
  constexpr int kScenes = 5000;
  for (const auto& scale :
       {base::Distribution::uniform({0.5}, {1.5}), base::Distribution::logUniform({0.1}, {10.0}),
        base::Distribution::normalBetween({1.0}, {0.2}, {0.5}, {3.0})}) {
    entry.scale = scale;
    const std::map<std::size_t, int> worn = wornIn(kScenes);
    EXPECT_EQ(worn.size(), 5U);
    for (const auto& [variant, count] : worn) {
      EXPECT_NEAR(count, kScenes / 5.0, 5.0 * std::sqrt(kScenes / 5.0)) << variant;
    }
  }
}

TEST_F(ObjectVariantsTest, AreWornAsOftenAsTheirWeightsSay) {
  entry.model = base::TextChoice{{"a", "b", "c"}, {1.0, 0.0, 3.0}};
  const std::map<std::size_t, int> worn = wornIn(4000);
  EXPECT_NEAR(worn.at(0), 1000, 150);
  EXPECT_EQ(worn.count(1), 0U);
  EXPECT_NEAR(worn.at(2), 3000, 150);
}

/// Half of all scenes have the file, the others any of the folder's four.
TEST_F(ObjectVariantsTest, OfAFolderEachModelIsAsLikely) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a", "b", "c", "d"}) {
    folder.write(std::string(name) + "/model.config", "");
  }
  entry.model = base::TextChoice{{"own.sdf", folder.path().string()}, {}};
  ASSERT_EQ(make().all().size(), 5U);
  EXPECT_EQ(make().all()[4].model, (folder / "d").string());
  const std::map<std::size_t, int> worn = wornIn(4000);
  EXPECT_NEAR(worn.at(0), 2000, 160);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(worn.at(i), 500, 110) << i;
}

TEST_F(ObjectVariantsTest, TellsWhatCannotBeMade) {
  const test::TemporaryFolder folder;
  entry.model = base::TextChoice{{folder.path().string()}, {}};
  EXPECT_THAT(test::messagesOf([&] { (void)make(); }),
              testing::ElementsAre(testing::HasSubstr("randomize/objects/rover/model: ")));
  entry.model = base::TextChoice{{}, {}};
  for (int i = 0; i < 11; ++i) entry.model->texts.push_back(std::to_string(i) + ".sdf");
  entry.scale = base::Distribution::uniform({1.0}, {2.0});
  entry.sizes = 100;
  EXPECT_THAT(test::messagesOf([&] { (void)make(); }),
              testing::ElementsAre(
                  testing::HasSubstr("randomize/objects/rover: found 11 models in 100 sizes")));
}

TEST_F(ObjectVariantsTest, TellsWhatIsWorn) {
  entry.model = base::TextChoice{{"a", "b"}, {}};
  entry.scale = base::Distribution::uniform({1.0}, {2.0});
  const ObjectVariants variants = make();
  for (int scene = 0; scene < 20; ++scene) {
    randomize::EntryDraws draws(3, scene);
    const ObjectVariant& worn = variants.all().at(variants.draw(draws));
    ASSERT_EQ(draws.values().size(), 2U);
    EXPECT_EQ(draws.values()[0].name, "objects/rover/model");
    EXPECT_EQ(std::get<std::string>(draws.values()[0].value), *worn.model);
    EXPECT_EQ(draws.values()[1].name, "objects/rover/scale");
    EXPECT_EQ(std::get<std::vector<double>>(draws.values()[1].value),
              std::vector<double>{worn.scale});
  }
}

TEST_F(ObjectVariantsTest, AreAllVariantsOfEachModelInEachSize) {
  entry.model = base::TextChoice{{"a", "b"}, {}};
  entry.scale = base::Distribution::choice({{2.0}, {0.5}});
  entry.variety = randomize::VarietyOptions{randomize::Variety::kSameClass, 3};
  const ObjectVariants variants = make();
  ASSERT_EQ(variants.all().size(), 12U);
  EXPECT_EQ(variants.all()[0].number, 0) << "the model as it is";
  EXPECT_EQ(variants.all()[5].number, 2);
  EXPECT_EQ(variants.all()[5].scale, 2.0);
  EXPECT_EQ(variants.all()[5].model, "a");
  EXPECT_EQ(wornIn(400).size(), 12U);
  randomize::EntryDraws draws(7, 3);
  const ObjectVariant& worn = variants.all()[variants.draw(draws)];
  ASSERT_EQ(draws.values().size(), 3U);
  EXPECT_EQ(draws.values()[2].name, "objects/rover/variant");
  EXPECT_THAT(std::get<std::vector<double>>(draws.values()[2].value), ElementsAre(worn.number));
}

TEST_F(ObjectVariantsTest, OfOneEntryLeavesTheOthersDraws) {
  entry.model = base::TextChoice{{"a", "b", "c"}, {}};
  const std::map<std::size_t, int> models = wornIn(300);
  entry.scale = base::Distribution::choice({{1.0}, {2.0}});
  std::map<std::size_t, int> of_models;
  for (const auto& [variant, count] : wornIn(300)) of_models[variant / 2] += count;
  EXPECT_EQ(of_models, models);
}

}  // namespace object_variants_test
}  // namespace synthetic_dataset::scene
