#include "run/pictures/floor_plan.h"

#include <memory>

#include <gtest/gtest.h>

#include "support/box_world.h"

namespace synthetic_dataset::run {
namespace floor_plan_test {

/// Static boxes, each with its middle at a given place.
struct Boxes {
  void add(const Eigen::Vector3d& size, const Eigen::Vector3d& middle) {
    world::Visual visual;
    visual.surfaces.push_back({test::boxMesh(size), {}});
    kept.push_back(std::make_unique<world::Link>());
    kept.back()->visuals = {visual};
    links.push_back({kept.back().get(), world::Role::kStatic});
    X_WL.push_back(Pose::Identity());
    X_WL.back().translation() = middle;
  }

  std::vector<std::unique_ptr<world::Link>> kept;
  std::vector<world::LinkInstance> links;
  std::vector<Pose> X_WL;
};

/// A room of 10 m by 6 m whose floor is half a metre up, with a table, below a roof.
Boxes room() {
  Boxes boxes;
  boxes.add({10.0, 6.0, 0.2}, {0.0, 0.0, 0.4});
  boxes.add({2.0, 1.0, 0.8}, {1.0, 0.0, 0.9});
  boxes.add({10.0, 6.0, 0.2}, {0.0, 0.0, 4.0});
  return boxes;
}

TEST(FloorPlan, FindsTheFloorBelowARoof) {
  const Boxes boxes = room();
  // The slab has a lower side, too, of the same area.
  EXPECT_NEAR(floorHeight(boxes.links, boxes.X_WL), 0.3, 0.026);
  EXPECT_EQ(floorHeight({}, {}), 0.0);
}

TEST(FloorPlan, IsAsLargeAsWhatStandsOnTheGround) {
  const Boxes boxes = room();
  const Eigen::AlignedBox2d extent = floorExtent(boxes.links, boxes.X_WL, 0.5);
  EXPECT_TRUE(
      extent.isApprox(Eigen::AlignedBox2d(Eigen::Vector2d(0.0, -0.5), Eigen::Vector2d(2.0, 0.5))));
}

TEST(FloorPlan, ShowsWhatStandsDarkerThanTheGround) {
  const Boxes boxes = room();
  MapPaper paper({Eigen::Vector2d(-5.0, -3.0), Eigen::Vector2d(5.0, 3.0)});
  drawFloorPlan(paper, boxes.links, boxes.X_WL, 0.5);
  const cv::Mat picture = paper.picture();
  EXPECT_EQ(picture.cols, 1100);  // 110 pixels a metre
  EXPECT_EQ(picture.rows, 660);
  const auto grey = [&](double x, double y) {
    return picture.at<cv::Vec3b>(static_cast<int>((3.0 - y) * 110.0),
                                 static_cast<int>((x + 5.0) * 110.0))[0];
  };
  EXPECT_LT(grey(1.0, 0.0), grey(-3.0, 2.0)) << "the table is darker than the floor";
}

}  // namespace floor_plan_test
}  // namespace synthetic_dataset::run
