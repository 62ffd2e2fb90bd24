#include "output/verify/label_checks.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::output {
namespace label_checks_test {

using formats::DrawnLabel;
using testing::ElementsAre;
using testing::IsEmpty;

DrawnLabel found(const std::string& class_name, const Box& box) {
  DrawnLabel label;
  label.class_names = {class_name};
  label.box = box;
  return label;
}

/// The problems of labels in a scene with an object for each of the `right` ones.
std::vector<std::string> problemsOf(const std::vector<DrawnLabel>& labels,
                                    const std::vector<DrawnLabel>& right) {
  SceneFacts facts;
  facts.width = facts.height = 100;
  RunDescription run;
  for (const DrawnLabel& each : right) {
    ObjectFacts object;
    object.visible_box = each.box;
    object.X_GO = each.X_CO;
    facts.objects.push_back(object);
    run.objects.emplace_back();
    run.objects.back().name = "the " + each.class_names.front();
  }
  return labelProblems({{}, labels}, {{}, right}, facts, run);
}

TEST(LabelChecks, FindLabelsInAnyOrder) {
  EXPECT_THAT(problemsOf({found("b", {5, 5, 7, 7}), found("a", {1, 2, 3, 4})},
                         {found("a", {1, 2, 3, 4}), found("b", {5, 5, 7, 7})}),
              IsEmpty());
}

TEST(LabelChecks, TellHowALabelDiffers) {
  EXPECT_THAT(problemsOf({found("a", {1, 2, 3, 4.2})}, {found("a", {1, 2, 3, 4})}),
              ElementsAre("object 'the a' (a): found the box [1, 2, 3, 4.2]; it should be [1, 2, "
                          "3, 4]"));
}

TEST(LabelChecks, TellOfTwoLabelsOfOneObject) {
  EXPECT_THAT(
      problemsOf({found("a", {1, 2, 3, 4}), found("a", {1, 2, 3, 4})}, {found("a", {1, 2, 3, 4})}),
      ElementsAre("found a label of class 'a' at [1, 2, 3, 4] that no object should have"));
}

TEST(LabelChecks, TellOfALackingLabel) {
  EXPECT_THAT(problemsOf({}, {found("a", {1, 2, 3, 4})}),
              ElementsAre("object 'the a' (a): has no label; it should have one"));
}

TEST(LabelChecks, PairLabelsOfOneClassByTheirMeasures) {
  EXPECT_THAT(problemsOf({found("a", {1, 1, 2, 2}), found("a", {5, 5, 7, 7})},
                         {found("a", {5, 5, 7, 7}), found("a", {1, 1, 2.5, 2})}),
              ElementsAre("object 'the a' (a): found the box [1, 1, 2, 2]; it should be [1, 1, "
                          "2.5, 2]"));
}

TEST(LabelChecks, CompareMasksPixelByPixel) {
  DrawnLabel label = found("a", {0, 0, 1, 1});
  label.mask = cv::Mat(10, 20, CV_8UC1, cv::Scalar(0));
  label.mask(cv::Rect(3, 4, 5, 2)).setTo(255);
  const DrawnLabel right = label;
  label.mask = label.mask.clone();
  EXPECT_THAT(problemsOf({label}, {right}), IsEmpty());
  label.mask.at<uchar>(4, 5) = 0;
  EXPECT_THAT(problemsOf({label}, {right}),
              ElementsAre("object 'the a' (a): found the mask of 9 pixels; it should be 10"));
  label.mask.at<uchar>(4, 5) = 255;
  label.mask.at<uchar>(8, 5) = 255;
  EXPECT_THAT(problemsOf({label}, {right}),
              ElementsAre("object 'the a' (a): found the mask within [2.5, 3.5, 7.5, 8.5]; it "
                          "should be [2.5, 3.5, 7.5, 5.5]"));
}

TEST(LabelChecks, ComparePolygonsByWhatTheyEnclose) {
  DrawnLabel label = found("a", {0, 0, 1, 1});
  // A square of 4 x 4 with a hole of 2 x 2, which a seam connects with the outline.
  label.polygons = {
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}, {0, 1}}};
  const DrawnLabel right = label;
  EXPECT_THAT(problemsOf({label}, {right}), IsEmpty());
  label.polygons[0][6].y = 2;
  EXPECT_THAT(problemsOf({label}, {right}), testing::SizeIs(1));
}

TEST(LabelChecks, ComparePoses) {
  DrawnLabel label = found("a", {0, 0, 1, 1});
  label.X_CO = makePose({1, 2, 3}, Eigen::Quaterniond::Identity());
  const DrawnLabel right = label;
  EXPECT_THAT(problemsOf({label}, {right}), IsEmpty());
  label.X_CO->translation().x() += 1e-4;
  EXPECT_THAT(problemsOf({label}, {right}),
              ElementsAre("object 'the a' (a): found the pose [1.0001, 2, 3; 0, 0, 0, 1]; it "
                          "should be [1, 2, 3; 0, 0, 0, 1]"));
}

}  // namespace label_checks_test
}  // namespace synthetic_dataset::output
