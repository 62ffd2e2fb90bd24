#include "run/label_counts.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "output/manifest/manifest_content.h"
#include "run_fixture.h"
#include "support/bag_builder.h"

namespace synthetic_dataset::run {
namespace label_counts_test {

using test::milliseconds;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// The counts of an object: in view, seen, dropped, counted, labelled.
RunSummary::Object object(const std::string& name, std::int64_t in_view, std::int64_t seen,
                          std::int64_t dropped, std::int64_t counted, std::int64_t labelled) {
  return {name, in_view, seen, dropped, counted, labelled};
}

TEST(MissingLabels, AreNoneWhereEachObjectHasOne) {
  EXPECT_THAT(
      missingLabels({object("rover", 1, 0, 0, 0, 1), object("drone", 40, 40, 39, 40, 1)}, 40),
      IsEmpty());
}

TEST(MissingLabels, AreReportedOfEachObjectWithTheReason) {
  EXPECT_THAT(missingLabels({object("rover", 7, 7, 0, 40, 7), object("drone", 0, 0, 0, 40, 0),
                             object("cup", 5, 5, 5, 40, 0), object("crate", 6, 0, 0, 40, 0)},
                            40),
              ElementsAre("object drone has a label in none of 40 scenes: never in view",
                          StartsWith("object cup has a label in none of 40 scenes: too little is "
                                     "seen in the 5 scenes"),
                          StartsWith("object crate has a label in none of 40 scenes: no pixel is "
                                     "seen in the 6 scenes")));
}

TEST(MissingLabels, OfManyForOneReasonAreOneMessage) {
  std::vector<RunSummary::Object> counts = {object("rover", 7, 7, 0, 40, 7)};
  for (int i = 0; i < 100; ++i) counts.push_back(object("o" + std::to_string(i), 0, 0, 0, 40, 0));
  EXPECT_THAT(missingLabels(counts, 40),
              ElementsAre("100 objects (o0, o1, o2, o3, o4, o5, o6, o7, o8, o9 and 90 more) have a "
                          "label in none of 40 scenes: never in view"));
}

TEST(MissingLabels, OfAllAreReportedFirst) {
  EXPECT_THAT(missingLabels({object("rover", 0, 0, 0, 0, 0)}, 40),
              ElementsAre(HasSubstr("NOTHING is labelled"), StartsWith("object rover")));
}

TEST(UnlabelledSplits, AreNamedWhereOthersHaveLabels) {
  EXPECT_THAT(unlabelledSplits({{"test", 1, 0}, {"train", 80, 70}, {"val", 10, 0}}),
              ElementsAre(HasSubstr("in its 1 scene "),
                          StartsWith("split val has no label: no object has one in its 10 scenes "
                                     "(other shares of `split`, or another `split/by`")));
  EXPECT_THAT(unlabelledSplits({{"train", 80, 70}, {"val", 10, 1}}), IsEmpty());
  EXPECT_THAT(unlabelledSplits({{"train", 80, 0}, {"val", 10, 0}}), IsEmpty())
      << "that is said of the dataset as a whole";
}

TEST(MissingLabels, AreInTheLastLine) {
  RunSummary summary;
  EXPECT_EQ(lastLine(summary), "done");
  summary.missing_labels = {"object a has no label"};
  EXPECT_EQ(lastLine(summary), "done, but object a has no label");
  summary.missing_labels = {"NOTHING is labelled", "object a", "object b"};
  EXPECT_THAT(lastLine(summary),
              AllOf(StartsWith("done, but NOTHING is labelled"), HasSubstr("2 more")));
}

TEST(MissingLabels, OfNoSceneAreNone) {
  EXPECT_THAT(missingLabels({object("rover", 0, 0, 0, 0, 0)}, 0), IsEmpty());
}

using LabelCountsTest = test::RunFixture;

struct Listener : Reporter {
  void info(const std::string& message) override { infos.push_back(message); }
  void warning(const std::string& message) override { warnings.push_back(message); }
  std::vector<std::string> infos;
  std::vector<std::string> warnings;
};

/// The parameters with writers that need nothing but boxes around projections.
Value::Map withLooseBoxesAlone(Value::Map parameters) {
  parameters["writers"] = Value(Value::List{
      Value(Value::Map{{"name", Value("yolo")}, {"type", Value("synthetic_dataset/Yolo")}})});
  for (const char* other : {"bounding_shape", "stvnet", "background_subtractor"}) {
    parameters.erase(other);
  }
  return parameters;
}

TEST_F(LabelCountsTest, OfARunThatDoesNotLookAtPixelsSayThatHiddenObjectsAreLabelled) {
  parameters = withLooseBoxesAlone(parameters);
  Listener listener;
  generate(listener);
  EXPECT_THAT(listener.infos, Contains(HasSubstr("labelled as if it were seen")));
}

TEST_F(LabelCountsTest, OfARunWithAThresholdSayNothingOfHiddenObjects) {
  parameters = withLooseBoxesAlone(parameters);
  parameters["labels"] = Value(Value::Map{{"min_pixels", Value(1)}});
  Listener listener;
  generate(listener);
  EXPECT_THAT(listener.infos, Not(Contains(HasSubstr("labelled as if it were seen"))));
}

TEST_F(LabelCountsTest, AreReportedAtTheEndOfARun) {
  Listener listener;
  parameters["labels"] = Value(Value::Map{{"min_pixels", Value(100000)}});
  generate(listener);
  EXPECT_THAT(listener.warnings,
              testing::IsSupersetOf({HasSubstr("NOTHING is labelled"),
                                     HasSubstr("2 objects (alpha, bravo) have a label in none")}));
}

TEST_F(LabelCountsTest, OfASplitThatSeesNoObjectAreReported) {
  // Whatever moved before the camera in the first half is far below it in the second.
  test::BagBuilder bag(run.folder() / "tiny.bag");
  for (int i = 0; i <= 20; ++i) {
    const Stamp time = milliseconds(1000 + 50 * i);
    const double z = i < 10 ? 0.0 : -500.0;
    bag.move("map", "alpha/base_link", time, test::poseAt(0.0, -0.5, z));
    bag.move("map", "bravo/base_link", time, test::poseAt(0.0, 1.0, z));
  }
  bag.close();
  parameters["split"] = Value(Value::Map{{"train", Value(0.5)}, {"val", Value(0.5)}});
  Listener listener;
  const RunSummary summary = generate(listener);
  const auto said = HasSubstr("split val has no label: no object has one in its 2 scenes");
  EXPECT_THAT(listener.warnings, Contains(said));
  EXPECT_THAT(lastLine(summary), said);
}

/// The camera is under the floor, which hides the objects though their boxes are in view.
Value::Map belowTheFloor(Value::Map parameters) {
  auto& pose = *(*parameters["camera"].as<Value::Map>())["pose"].as<Value::List>();
  pose[2] = Value(-0.5);
  parameters.erase("yolo");
  parameters.erase("bounding_shape");
  parameters["writers"] = Value(Value::List{
      Value(Value::Map{{"name", Value("coco")}, {"type", Value("synthetic_dataset/Coco")}})});
  return parameters;
}

TEST_F(LabelCountsTest, OfARunThatSeesNoObjectAreInItsEndAndInTheManifest) {
  parameters = belowTheFloor(parameters);
  Listener listener;
  const RunSummary summary = generate(listener);
  EXPECT_THAT(listener.warnings,
              testing::IsSupersetOf({HasSubstr("NOTHING is labelled"),
                                     HasSubstr("2 objects (alpha, bravo) have a label in none of 4 "
                                               "scenes: no pixel is seen")}));
  EXPECT_THAT(lastLine(summary), StartsWith("done, but NOTHING is labelled"));
  const output::ManifestContent manifest = output::readManifest(output::manifestFile(folder));
  EXPECT_TRUE(manifest.complete);
  std::vector<std::string> listed;
  for (const base::Warning& each : manifest.run.warnings) listed.push_back(each.kind);
  EXPECT_THAT(listed, testing::IsSupersetOf(summary.missing_labels));
}

TEST_F(LabelCountsTest, ReportsLeaveTheManifestsBytesThoseOfAnUnbrokenRun) {
  parameters = belowTheFloor(parameters);
  const auto whole = filesAnew();
  parameters["only_scenes"] = Value(Value::List{Value(0), Value(1)});
  std::filesystem::remove_all(folder);
  (void)generate();
  parameters.erase("only_scenes");
  (void)generate();
  EXPECT_EQ(files(), whole);
}

}  // namespace label_counts_test
}  // namespace synthetic_dataset::run
