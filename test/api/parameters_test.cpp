#include "synthetic_dataset/parameters.h"

#include <gmock/gmock.h>

namespace synthetic_dataset {
namespace parameters_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Compilers disagree on whether a list that holds a single list is that list itself (CWG 2137),
/// hence the Value(...) around the inner one.
Parameters example() {
  return Parameters(Value::Map{
      {"rate", Value(4)},
      {"name", Value("alpha")},
      {"points", Value::List{Value(Value::List{Value(1), Value(2.5), Value(3)})}},
      {"yolo", Value::Map{{"output_folder", Value("/tmp")}, {"depth", Value(2)}}},
  });
}

TEST(Parameters, GiveValuesOfTheTypeThatIsAskedFor) {
  Parameters root = example();
  EXPECT_EQ(root.required<int>("rate"), 4);
  EXPECT_EQ(root.required<double>("rate"), 4.0);
  EXPECT_EQ(root.required<std::string>("name"), "alpha");
  EXPECT_EQ(root.group("yolo").required<int>("depth"), 2);
  EXPECT_THAT(root.required<std::vector<Eigen::Vector3d>>("points"),
              ElementsAre(Eigen::Vector3d(1, 2.5, 3)));
  EXPECT_THAT(root.errors(), IsEmpty());
}

TEST(Parameters, ASingleTextCountsAsAListOfOne) {
  EXPECT_THAT(example().required<std::vector<std::string>>("name"), ElementsAre("alpha"));
}

TEST(Parameters, NoteEveryErrorWithItsFullName) {
  Parameters root = example();
  (void)root.required<std::string>("bag_file");
  (void)root.required<double>("name");
  (void)root.group("yolo").required<std::string>("main_list");
  (void)root.group("yolo").required<bool>("depth");
  EXPECT_THAT(root.errors(),
              ElementsAre("bag_file: required, but missing",
                          "name: found alpha (a text); it should be a finite number",
                          "yolo/main_list: required, but missing",
                          "yolo/depth: found 2 (a whole number); it should be true or false"));
}

TEST(Parameters, NameTheEntryOfAListThatIsWrong) {
  Parameters root(Value::Map{{"keypoints", Value::List{Value::List{Value(1), Value(2), Value(3)},
                                                       Value::List{Value(1), Value(2)}}}});
  (void)root.required<std::vector<Eigen::Vector3d>>("keypoints");
  EXPECT_THAT(root.errors(),
              ElementsAre("keypoints: found [[1, 2, 3], [1, 2]] (a list); entry 2 is [1, 2]; it "
                          "should be a list of points, each [x, y, z] in metres"));
}

TEST(Parameters, TakeATextInDegreesForAnAngle) {
  Parameters root(Value::Map{{"angle", Value("deg(-90)")}, {"text", Value("deg(x)")}});
  EXPECT_NEAR(root.required<double>("angle"), -1.5707963268, 1e-9);
  EXPECT_THAT(root.errors(), IsEmpty());
  (void)root.required<double>("text");
  EXPECT_THAT(root.errors(),
              ElementsAre("text: found deg(x) (a text); it should be a finite number"));
}

TEST(Parameters, RefuseNumbersThatAreNotFinite) {
  Parameters root(Value::Map{{"rate", Value(NAN)}});
  (void)root.required<double>("rate");
  EXPECT_THAT(root.errors(),
              ElementsAre("rate: found nan (a number); it should be a finite number"));
}

TEST(Parameters, ListTheDefaultsThatWereTaken) {
  Parameters root = example();
  EXPECT_EQ(root.optional("rate", 30.0), 4.0);
  EXPECT_EQ(root.optional<std::string>("global_frame", "map"), "map");
  EXPECT_EQ(root.group("image").optional("png_compression", 3), 3);
  EXPECT_THAT(root.defaultsTaken(), ElementsAre("global_frame: map", "image/png_compression: 3"));
}

TEST(Parameters, KnowWhichOnesNobodyAskedFor) {
  Parameters root = example();
  (void)root.required<int>("rate");
  (void)root.group("yolo").required<int>("depth");
  root.ignore("name");
  EXPECT_THAT(root.unknownNames(), ElementsAre("points", "yolo/output_folder"));
  EXPECT_THAT(root.knownNeighbours("yolo/output_folder"), ElementsAre("depth"));
  EXPECT_THAT(root.knownElsewhere("depth"), ElementsAre("yolo/depth"));
}

TEST(Parameters, AGroupThatIsNoGroupIsAnError) {
  Parameters root(Value::Map{{"yolo", Value(3)}});
  (void)root.group("yolo");
  EXPECT_THAT(root.errors(), ElementsAre("yolo: found 3 (a whole number); it should be a group of "
                                         "named values"));
}

TEST(Parameters, NumbersAsYamlCppWritesThemCount) {
  Parameters root(Value(Value::Map{{"small", Value("1e-05")}, {"text", Value("e5x")}}));
  EXPECT_EQ(root.required<double>("small"), 1e-5);
  (void)root.required<double>("text");
  EXPECT_EQ(root.errors().size(), 1U);
}

TEST(Parameters, NumbersAndTextsMayBeBounded) {
  Parameters root(Value::Map{{"few", Value(3)}, {"many", Value(30)}, {"way", Value("sideway")}});
  EXPECT_EQ(root.optionalBetween("few", 1, 0, 9), 3);
  EXPECT_EQ(root.optionalBetween("many", 1, 0, 9), 1);
  EXPECT_EQ(root.optionalBetween("share", 0.25, 0.0, 1.0), 0.25);
  (void)root.optionalChoice("way", {"sideways", "ahead"}, "ahead");
  EXPECT_EQ(root.optionalChoice("other", {"sideways", "ahead"}, "ahead"), "ahead");
  (void)root.requiredChoice("third", {"sideways", "ahead"});
  EXPECT_THAT(root.errors(),
              testing::ElementsAre("many: found 30; it should be 0 to 9",
                                   "way: found 'sideway'; it should be sideways or ahead; did you "
                                   "mean 'sideways'?",
                                   "third: required, but missing"));
}

}  // namespace parameters_test
}  // namespace synthetic_dataset
