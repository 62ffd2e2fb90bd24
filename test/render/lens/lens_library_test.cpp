#include "render/lens/lens_library.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"

namespace synthetic_dataset::render {
namespace lens_library_test {

using synthetic_dataset::test::Stage;
using test::coloured;
using test::dark;
using test::kFisheye190;
using test::kPlumbBob;

/// A lens with other focal lengths.
CameraModel zoomed(const CameraModel& camera, double factor) {
  Intrinsics k = camera.intrinsics();
  k.fx *= factor;
  k.fy *= factor;
  return {camera.width(), camera.height(), k, camera.near(), camera.far(), camera.distortion()};
}

/// A small picture, so that tests are quick.
CameraModel small(const CameraModel& camera) {
  const Intrinsics& k = camera.intrinsics();
  return {camera.width() / 4,
          camera.height() / 4,
          {k.fx / 4, k.fy / 4, (k.cx + 0.5) / 4 - 0.5, (k.cy + 0.5) / 4 - 0.5},
          camera.near(),
          camera.far(),
          camera.distortion()};
}

TEST(LensLibrary, MakesACamerasMapOnce) {
  LensLibrary library;
  const CameraModel camera = small(kPlumbBob.camera);
  const auto first = library.get(camera);
  EXPECT_NE(library.get(zoomed(camera, 1.1)), first);
  EXPECT_EQ(library.get(camera), first);
}

TEST(LensLibrary, KeepsFewMapsOfALensThatZooms) {
  LensLibrary library;
  const CameraModel camera = small(kPlumbBob.camera);
  const CameraModel other = small(kFisheye190.camera);
  const std::weak_ptr<const LensMap> of_other = library.get(other);
  const auto held = library.get(camera);
  const std::weak_ptr<const LensMap> dropped = library.get(zoomed(camera, 1.01));
  for (std::size_t i = 0; i < LensLibrary::kMostZooms; ++i) {
    (void)library.get(zoomed(camera, 1.1 + 0.1 * static_cast<double>(i)));
  }
  EXPECT_TRUE(dropped.expired());
  EXPECT_FALSE(of_other.expired()) << "another lens's is kept";
  EXPECT_EQ(held->rays.size(), cv::Size(camera.width(), camera.height()))
      << "good as long as somebody holds it";
}

class ZoomingLens : public ::testing::TestWithParam<test::LensCase> {
 protected:
  ZoomingLens() {
    stage.addBox({0.4, 0.4, 0.4}, makePose({-0.3, 0.1, 1.5}, turned()), 0, coloured(1, 0.2F, 0));
    stage.addBox({0.5, 0.3, 0.4}, makePose({0.6, -0.2, 2.0}, turned()), 1, coloured(0, 0.4F, 1));
    stage.addBox({9, 9, 0.1}, makePose({0, 0, 4}, Eigen::Quaterniond::Identity()), -1,
                 coloured(0.4F, 0.5F, 0.4F));
  }

  static Eigen::Quaterniond turned() {
    return Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  }

  Stage stage;
};

/// A renderer's outputs for the stage.
struct Seen {
  PendingPicture picture;
  LabelImages labels;
  std::int64_t silhouette_pixels = 0;
};

Seen look(Renderer& renderer, const CameraModel& camera, const Stage& stage) {
  const View view{camera, Pose::Identity()};
  LabelPass pass{stage.all()};
  pass.range = true;
  pass.normals = true;
  return {renderer.draw(view, stage.poses(), {stage.all(), stage.all()}),
          renderer.labels(view, stage.poses(), pass),
          renderer.silhouette(view, stage.poses(), {true, false, false}).pixels};
}

TEST_P(ZoomingLens, ShowsWhatANewRendererShows) {
  const std::vector<double> factors = {1.0, 0.7, 1.9, 0.8, 1.3, 0.75, 0.7};
  std::vector<CameraModel> cameras;
  std::vector<Seen> expected;
  std::vector<cv::Mat> expected_pictures;
  for (const double factor : factors) {  // one OpenGL context at a time
    cameras.push_back(zoomed(small(GetParam().camera), factor));
    Renderer fresh(dark(), stage.links(), {});
    expected.push_back(look(fresh, cameras.back(), stage));
    expected_pictures.push_back(expected.back().picture());
  }

  Renderer renderer(dark(), stage.links(), {});
  std::vector<Seen> found;
  for (const CameraModel& camera : cameras) found.push_back(look(renderer, camera, stage));

  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto expectSame = [&](const cv::Mat& one, const cv::Mat& other) {
      EXPECT_EQ(cv::norm(one, other, cv::NORM_INF), 0.0) << factors[i];
    };
    // The writing thread finishes pictures only after the next ones have been drawn.
    expectSame(found[i].picture(), expected_pictures[i]);
    expectSame(found[i].labels.ids, expected[i].labels.ids);
    expectSame(found[i].labels.depth, expected[i].labels.depth);
    expectSame(found[i].labels.range, expected[i].labels.range);
    expectSame(found[i].labels.normals, expected[i].labels.normals);
    EXPECT_EQ(found[i].silhouette_pixels, expected[i].silhouette_pixels) << factors[i];
    EXPECT_GT(cv::countNonZero(expected[i].labels.ids == 1), 50) << factors[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses, ZoomingLens, ::testing::Values(kPlumbBob, kFisheye190),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace lens_library_test
}  // namespace synthetic_dataset::render
