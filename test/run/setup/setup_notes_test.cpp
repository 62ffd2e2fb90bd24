#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "run/setup/setup_notes.h"

namespace synthetic_dataset::run {
namespace size_checks_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const Cuboid kRover{{-0.5, -0.3, 0.0}, {0.5, 0.3, 0.4}};

scene::ObjectOptions rover(double scale) {
  scene::ObjectOptions object;
  object.name = "rover";
  for (const Eigen::Vector3d& corner : kRover.corners()) {
    object.bounding_shape_O.push_back(scale * corner);
  }
  object.keypoints_O = {scale * Eigen::Vector3d(0.4, 0.2, 0.4)};
  return object;
}

std::vector<std::string> warningsOf(const scene::ObjectOptions& object, const Cuboid& box_O) {
  base::Diagnostics diagnostics;
  checkSizes(object, box_O, diagnostics);
  return diagnostics.messages(base::Severity::kWarning);
}

TEST(Sizes, AreRightOfWhatFitsTheModel) {
  EXPECT_THAT(warningsOf(rover(1.0), kRover), IsEmpty());
  EXPECT_THAT(warningsOf(rover(1.4), kRover), IsEmpty()) << "with room";
  scene::ObjectOptions found_on_model;
  EXPECT_THAT(warningsOf(found_on_model, kRover), IsEmpty());
}

TEST(Sizes, WarnOfMillimetres) {
  EXPECT_THAT(warningsOf(rover(1000.0), kRover),
              ElementsAre("rover/bounding_shape: its points span 1232.883 m, the model "
                          "1.233 m (are they in metres?)",
                          StartsWith("rover/keypoints: one is ")));
}

TEST(Sizes, WarnOfASinglePoint) {
  scene::ObjectOptions object = rover(1.0);
  object.bounding_shape_O = {Eigen::Vector3d::Zero()};
  EXPECT_THAT(warningsOf(object, kRover), ElementsAre(StartsWith("rover/bounding_shape: its points "
                                                                 "span 0.000 m")));
}

TEST(Sizes, WarnOfAnotherFrame) {
  scene::ObjectOptions object = rover(1.0);
  for (Eigen::Vector3d& point : object.bounding_shape_O) point.x() += 5.0;
  EXPECT_THAT(warningsOf(object, kRover),
              ElementsAre(StartsWith("rover/bounding_shape: its middle is 4.500 m away")));
}

}  // namespace size_checks_test
}  // namespace synthetic_dataset::run
