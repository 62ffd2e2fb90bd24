#include "render/lens/lens_map.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"

namespace synthetic_dataset::render {
namespace lens_map_test {

using synthetic_dataset::test::Stage;
using test::coloured;
using test::dark;
using test::kFisheye190;
using test::kPlumbBob;

TEST(LensMap, OfANarrowLensHasOneFaceThatLooksAhead) {
  const LensMap map = makeLensMap(kPlumbBob.camera);
  ASSERT_EQ(map.faces.size(), 1U);
  EXPECT_TRUE(map.faces[0].X_CF.matrix().isIdentity());
  EXPECT_EQ(map.faces[0].camera.near(), kPlumbBob.camera.near());
}

TEST(LensMap, OfAWideLensHasTheCubesSidesThatItSees) {
  const LensMap map = makeLensMap(kFisheye190.camera);
  EXPECT_EQ(map.faces.size(), 5U) << "nothing is seen straight behind";
}

TEST(LensMap, CutsLargeFacesIntoTilesWithoutASeam) {
  const CameraModel camera(4000, 300, {3000, 3000, 1999.5, 149.5}, 0.05, 100.0,
                           {DistortionModel::kPlumbBob, {-0.05}});
  EXPECT_GT(makeLensMap(camera).faces.size(), 1U);
  Stage stage;
  stage.addBox({6, 0.05, 0.1}, makePose({0, 0, 3}, Eigen::Quaterniond::Identity()), 0,
               coloured(1, 1, 1));
  Renderer renderer(dark(), stage.links(), {});
  const cv::Mat ids = renderer.labels({camera, Pose::Identity()}, stage.poses(), {stage.all()}).ids;
  EXPECT_EQ(cv::countNonZero(ids.row(150) == 1), 4000);
}

TEST(LensMap, OfAPictureOfOneColumnIsAsFineAsOfThree) {
  const Distortion bent{DistortionModel::kPlumbBob, {-0.1}};
  const LensMap one = makeLensMap({1, 61, {40, 40, 0.0, 30.0}, 0.05, 100.0, bent});
  const LensMap three = makeLensMap({3, 61, {40, 40, 1.0, 30.0}, 0.05, 100.0, bent});
  ASSERT_EQ(one.faces.size(), 1U);
  EXPECT_NEAR(one.faces[0].camera.intrinsics().fx / three.faces[0].camera.intrinsics().fx, 1.0,
              0.1);
  const LensMap pixel = makeLensMap({1, 1, {40, 40, 0.0, 0.0}, 0.05, 100.0, bent});
  EXPECT_GE(pixel.faces.at(0).camera.intrinsics().fx, 80.0);
}

TEST(LensMap, IsFineWhereOnlyTheLastRowLooks) {
  // The last row, 30 rows below the axis, is the only one that looks more than 45 degrees down.
  const CameraModel camera(161, 61, {29.9, 29.9, 80.0, 30.0}, 0.05, 100.0,
                           {DistortionModel::kPlumbBob, {0.001}});
  const LensMap map = makeLensMap(camera);
  const auto below = std::find_if(map.faces.begin(), map.faces.end(), [](const LensFace& face) {
    return face.X_CF.linear()(1, 2) == 1.0;
  });
  ASSERT_NE(below, map.faces.end());
  EXPECT_GE(below->camera.intrinsics().fx, 29.9);
}

}  // namespace lens_map_test
}  // namespace synthetic_dataset::render
