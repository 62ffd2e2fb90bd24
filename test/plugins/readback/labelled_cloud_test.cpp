#include "plugins/readback/labelled_cloud.h"

#include <gmock/gmock.h>

#include "plugins/shared/cloud_files.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace labelled_cloud_test {

using testing::ElementsAre;
using testing::Pair;

LabelledCloud::Point at(float x, std::uint16_t number = 0) {
  LabelledCloud::Point point;
  point.position_S = {x, 0.0F, 0.0F};
  point.number = number;
  return point;
}

/// A rover from 1 m to 2 m ahead.
LabelledCloud::Object rover() {
  return {"rover", "rover 1", Cuboid{{1.0, -0.5, -0.5}, {2.0, 0.5, 0.5}}.corners()};
}

TEST(LabelledCloud, TakesPointsInABoxForItsObjectsWhereNothingSaysWhatTheyAre) {
  LabelledCloud cloud;
  cloud.points = {at(0.5F), at(1.5F), at(2.5F)};
  cloud.objects[7] = rover();
  assignToBoxes(cloud);
  EXPECT_EQ(cloud.points[0].object, 0);
  EXPECT_EQ(cloud.points[1].object, 7);
  EXPECT_EQ(cloud.classes.at(cloud.points[1].number), "rover");
  EXPECT_EQ(cloud.points[2].object, 0);
  EXPECT_THAT(pointsOfObjects(cloud), ElementsAre(Pair(7, 1)));
}

TEST(LabelledCloud, TakesPointsOfAnotherClassForNoneOfABoxsObject) {
  LabelledCloud cloud;
  cloud.has_labels = true;
  cloud.classes = {{3, "rover"}, {4, "floor"}};
  cloud.points = {at(1.2F, 3), at(1.4F, 4), at(1.6F, 0)};
  cloud.objects[1] = rover();
  assignToBoxes(cloud);
  EXPECT_EQ(cloud.points[0].object, 1);
  EXPECT_EQ(cloud.points[1].object, 0);
  EXPECT_EQ(cloud.points[2].object, 0);
  EXPECT_THAT(pointsOfClasses(cloud), ElementsAre(Pair(0, 1), Pair(3, 1), Pair(4, 1)));
}

TEST(LabelledCloud, FollowsTheTurnOfABox) {
  LabelledCloud cloud;
  const Eigen::AngleAxisd turn(M_PI / 4.0, Eigen::Vector3d::UnitZ());
  LabelledCloud::Object thin{"bar", "bar 1",
                             Cuboid{{0.0, -0.05, -0.05}, {3.0, 0.05, 0.05}}.corners()};
  for (Eigen::Vector3d& corner : *thin.corners_S) corner = turn * corner;
  cloud.objects[1] = thin;
  cloud.points = {at(1.0F), at(1.0F)};
  cloud.points[1].position_S.y() = 1.0F;
  assignToBoxes(cloud);
  EXPECT_EQ(cloud.points[0].object, 0);
  EXPECT_EQ(cloud.points[1].object, 1);
}

TEST(LabelledCloud, HasThePointsOfAFileInKittisForm) {
  const test::TemporaryFolder folder;
  std::string bytes;
  for (const float number : {1.0F, -2.0F, 3.5F, 0.25F}) appendFloat(bytes, number);
  LabelledCloud cloud;
  addVelodynePoints(cloud, folder.write("a.bin", bytes).string());
  ASSERT_EQ(cloud.points.size(), 1U);
  EXPECT_EQ(cloud.points[0].position_S, Eigen::Vector3f(1.0F, -2.0F, 3.5F));
  EXPECT_THROW(addVelodynePoints(cloud, folder.write("b.bin", bytes + "x").string()), Error);
}

}  // namespace labelled_cloud_test
}  // namespace synthetic_dataset::formats
