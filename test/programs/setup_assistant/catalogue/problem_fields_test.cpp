#include "programs/setup_assistant/catalogue/catalogue.h"

#include <string>

#include <gtest/gtest.h>

#include "base/json_text.h"

namespace synthetic_dataset::programs {
namespace {

const Value kSettings =
    Value::Map{{"robot_list", Value(Value::List{Value("alpha"), Value("bravo")})},
               {"alpha", Value(Value::Map{{"class", Value("car")}})},
               {"world", Value(Value::Map{{"file", Value("/data/hall.world")}})},
               {"bag_file", Value(Value::List{Value("/data/one.bag"), Value("/data/two.bag")})},
               {"cameras", Value(Value::Map{{"front", Value(Value::Map{})}})}};

/// The field of a problem, as JSON; "" if it has none.
std::string fieldOf(const std::string& about, const std::string& found,
                    const std::string& cure = "") {
  Value::Map setup = {
      {"problems",
       Value(Value::List{Value(Value::Map{{"about", Value(about)},
                                          {"found", Value(found)},
                                          {"cure", Value(cure)},
                                          {"path", Value(Value::List{Value("wrong")})}})})}};
  addFields(setup, kSettings);
  const auto& problem = *setup.at("problems").as<Value::List>()->front().as<Value::Map>();
  const auto path = problem.find("path");
  return path == problem.end() ? "" : base::jsonText(path->second);
}

TEST(ProblemFields, AreTheSettingsThatProblemsAreAbout) {
  EXPECT_EQ(R"(["camera", "pose"])", fieldOf("camera/pose", "found nothing"));
  EXPECT_EQ(R"(["motions", 0, "bag_file"])", fieldOf("motions/0/bag_file", "no such file"));
  EXPECT_EQ(R"(["alpha"])", fieldOf("alpha", "never moves"));
  EXPECT_EQ(R"(["bravo"])", fieldOf("motion 'hall': bravo", "stands in the ground"));
  EXPECT_EQ(R"(["cameras", "front"])", fieldOf("camera front", "is inside of 'shelf'"));
}

TEST(ProblemFields, AreNamedByTheCureOrTheTextOtherwise) {
  EXPECT_EQ(R"(["simulated_rate"])",
            fieldOf("scenes", "nothing moves in 3 of 4", "`simulated_rate: 2` would be right"));
  EXPECT_EQ(R"(["labels", "min_pixels"])", fieldOf("", "17 of 20 are small (labels/min_pixels)"));
  EXPECT_EQ(R"(["world"])", fieldOf("hall.sdf", "is missing; `world` names it"));
}

TEST(ProblemFields, AreThoseThatNameTheFileThatIsWrong) {
  EXPECT_EQ(R"(["world", "file"])", fieldOf("'/data/hall.world'", "no such file"));
  EXPECT_EQ(R"(["bag_file", 1])", fieldOf("", "'/data/two.bag' is no bag"));
}

TEST(ProblemFields, AreNotGuessedFromPlainWords) {
  EXPECT_EQ("", fieldOf("", "the camera sees the world from below"));
  EXPECT_EQ("", fieldOf("/tmp/x.bag", "no such file"));
}

}  // namespace
}  // namespace synthetic_dataset::programs
