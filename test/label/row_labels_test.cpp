/// Where points of bodies appear in pictures whose rows are taken one after the other.

#include "label/row_labels.h"

#include <cmath>

#include <gtest/gtest.h>

namespace synthetic_dataset::label {
namespace row_labels_test {

const CameraModel kCamera(160, 120, {130.0, 131.0, 80.2, 59.6}, 0.05, 100.0);
const CameraModel kLens(160, 120, {105.1, 104.5, 80.4, 59.6}, 0.05, 100.0,
                        {DistortionModel::kPlumbBob, {-0.28, 0.09, 1e-3, -8e-4, -0.01}});

Pose pose(const Eigen::Vector3d& p, double angle = 0.0) {
  return makePose(
      p, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized())));
}

/// A camera that moves and turns, and a body that flies past it.
render::RollingView flyBy(const CameraModel& camera, double speed) {
  render::RollingView view{camera, {}, 12};
  for (int i = 0; i <= 12; ++i) {
    const double share = i / 12.0;
    view.moments.push_back({share * camera.height() - 0.5,
                            pose({0.1 * share, 0, 0.05 * share}, 0.03 * share),
                            {pose({0.2 - speed * share, 0.3 - speed * share, 2.0}, share)}});
  }
  return view;
}

TEST(RowFinder, FindsAPointInTheRowThatIsTakenWhenThePointIsThere) {
  for (const CameraModel& camera : {kCamera, kLens}) {
    const render::RollingView view = flyBy(camera, 0.4);
    const RowFinder finder(view, {true});
    for (int i = 0; i < 27; ++i) {
      const Eigen::Vector3d p_B =
          0.3 * Eigen::Vector3d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);  // corners, edges, faces
      const auto found = finder.find(0, p_B);
      ASSERT_TRUE(found.has_value());
      const render::RollingMoment then = view.at(found->pixel.y());
      const Eigen::Vector3d p_C = then.X_WC.inverse() * (then.X_WL[0] * p_B);
      EXPECT_LT((found->p_C - p_C).norm(), 1e-6);
      EXPECT_LT((found->pixel - camera.project(p_C).value()).norm(), 1e-4);
    }
  }
}

TEST(RowFinder, APointThatStandsIsWhereItIsAllTheTime) {
  render::RollingView view = flyBy(kCamera, 0.0);
  for (render::RollingMoment& moment : view.moments) {
    moment.X_WC = Pose::Identity();
    moment.X_WL = {pose({0.1, 0.2, 3.0})};
  }
  const auto found = RowFinder(view, {true}).find(0, {0, 0, 0});
  ASSERT_TRUE(found.has_value());
  EXPECT_LT((found->pixel - kCamera.project({0.1, 0.2, 3.0}).value()).norm(), 1e-9);
}

TEST(RowFinder, BesideTheRowsAPointIsAsTheFirstOrTheLastRowHasIt) {
  for (const double side : {-1.0, 1.0}) {
    render::RollingView view = flyBy(kCamera, 0.0);
    for (std::size_t i = 0; i < view.moments.size(); ++i) {
      view.moments[i].X_WC = Pose::Identity();
      view.moments[i].X_WL = {pose({0.01 * static_cast<double>(i), side * 1.5, 2.0})};
    }
    const auto found = RowFinder(view, {true}).find(0, {0, 0, 0});
    ASSERT_TRUE(found.has_value());
    const Eigen::Vector3d there(side < 0.0 ? 0.0 : 0.12, side * 1.5, 2.0);
    EXPECT_LT((found->pixel - kCamera.project(there).value()).norm(), 1e-9);
  }
}

TEST(RowFinder, OfAPointThatOutrunsTheRowsItTakesThePlaceNearestToTheMiddle) {
  render::RollingView view = flyBy(kCamera, 0.0);
  for (std::size_t i = 0; i < view.moments.size(); ++i) {
    view.moments[i].X_WC = Pose::Identity();
    view.moments[i].X_WL = {pose({0, i % 2 == 0 ? -0.5 : 0.5, 2.0})};  // up and down
  }
  const auto found = RowFinder(view, {true}).find(0, {0, 0, 0});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->pixel.y(), 59.5, 5.0);
  EXPECT_NEAR(view.X_CL(0, found->pixel.y()).translation().y(), found->p_C.y(), 1e-6);
}

TEST(RowFinder, FindsNothingBehindTheCamera) {
  render::RollingView view = flyBy(kCamera, 0.0);
  for (render::RollingMoment& moment : view.moments) moment.X_WL = {pose({0, 0, -2.0})};
  EXPECT_FALSE(RowFinder(view, {true}).find(0, {0, 0, 0}).has_value());
}

}  // namespace row_labels_test
}  // namespace synthetic_dataset::label
