#include "randomize/placement/scene_placer.h"

#include <cmath>
#include <memory>
#include <optional>

#include <gmock/gmock.h>

#include "randomize/placement/solid_boxes.h"
#include "support/error_messages.h"

namespace synthetic_dataset::randomize {
namespace scene_placer_test {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::chiSquared;
using test::floorBox;
using test::SolidBox;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using world::at;

/// Four standard deviations above the mean of a chi-squared statistic, which is exceeded once in
/// some ten thousand seeds.
double atMost(double degrees_of_freedom) {
  return degrees_of_freedom + 4.0 * std::sqrt(2.0 * degrees_of_freedom);
}

/// Free cells of 0.25 m, turned and moved.
OccupancyMap hall(std::size_t width, std::size_t height) {
  return {width, height, 0.25, {-5, -4, 0, 0.3}, std::vector<Cell>(width * height, Cell::kFree)};
}

/// 15 m x 10 m, of which one cell in eighty is not free.
OccupancyMap clutteredMap() {
  base::RandomSource random(3);
  std::vector<Cell> cells(60 * 40, Cell::kFree);
  for (Cell& cell : cells) {
    if (random.index(80) == 0) cell = random.index(2) == 0 ? Cell::kOccupied : Cell::kUnknown;
  }
  return {60, 40, 0.25, {-5, -4, 0, 0.3}, cells};
}

/// The distance from a place to the nearest cell that is not free or outside of the map [m], by
/// checking each cell.
double clearanceAt(const OccupancyMap& map, const Vector2d& p_G) {
  const Vector2d p_M = Eigen::Rotation2Dd(-map.pose().yaw) *
                       Vector2d(p_G.x() - map.pose().x, p_G.y() - map.pose().y);
  const double side = map.resolution();
  double least = std::min({p_M.x(), p_M.y(), static_cast<double>(map.width()) * side - p_M.x(),
                           static_cast<double>(map.height()) * side - p_M.y()});
  for (std::size_t row = 0; row < map.height(); ++row) {
    for (std::size_t column = 0; column < map.width(); ++column) {
      if (map.cell(column, row) == Cell::kFree) continue;
      const Vector2d low(static_cast<double>(column) * side, static_cast<double>(row) * side);
      const Vector2d nearest = p_M.cwiseMax(low).cwiseMin(low + Vector2d(side, side));
      least = std::min(least, (p_M - nearest).norm());
    }
  }
  return least;
}

double headingOf(const Pose& X) { return std::atan2(X.linear()(1, 0), X.linear()(0, 0)); }

void expectSameBits(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i].matrix() == b[i].matrix()) << i;
}

class ScenePlacerTest : public ::testing::Test {
 protected:
  struct Placer {
    std::unique_ptr<world::World> world;
    std::unique_ptr<Surroundings> surroundings;
    std::unique_ptr<ScenePlacer> placer;

    /// The poses of all objects, which all have to take part.
    [[nodiscard]] std::vector<Pose> place(std::int64_t scene) const {
      std::vector<Pose> X_GO;
      for (const std::optional<Pose>& each : placer->place(scene)) X_GO.push_back(each.value());
      return X_GO;
    }
  };

  /// @param absent  the object that does not take part, if any
  [[nodiscard]] Placer make(std::uint64_t seed = 1, const std::string& absent = "") const {
    Placer made;
    const bool drops = config.mode == PlacementMode::kDrop;
    made.world = test::worldOf(standing, objects, props, drops);
    made.surroundings = std::make_unique<Surroundings>(*made.world);
    std::vector<PlacedObject> placed;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      placed.push_back(
          {objects[i].name, {{radii[i], objects[i].cuboid()}}, objects[i].name != absent});
    }
    made.placer =
        std::make_unique<ScenePlacer>(config, map, placed, *made.world, *made.surroundings, seed);
    return made;
  }

  void useVolume(const Vector3d& low, const Vector3d& high,
                 PlacementMode mode = PlacementMode::kVolume) {
    config.mode = mode;
    config.volume.low = low;
    config.volume.high = high;
    map.reset();
    radii.assign(radii.size(), 0.0);
  }

  void useOnlyAlpha() {
    objects.resize(1);
    radii.resize(1);
  }

  [[nodiscard]] SolidBox object(std::size_t index, const std::vector<Pose>& X_GO) const {
    return {objects[index].name, objects[index].size, X_GO[index]};
  }

  /// The errors when the placer or the first scene is made.
  [[nodiscard]] std::vector<std::string> errors() const {
    return test::messagesOf([&] { static_cast<void>(make().place(0)); });
  }

  PlacementOptions config;
  std::optional<OccupancyMap> map = clutteredMap();
  std::vector<SolidBox> standing{floorBox()};
  std::vector<world::Model> props;
  std::vector<SolidBox> objects{{"alpha", {0.6, 0.4, 0.5}}, {"bravo", {0.4, 0.4, 1.0}}};
  std::vector<double> radii{0.6, 0.4};
};

// --- On a map ---

TEST_F(ScenePlacerTest, KeepsTheSafetyRadiusFromAllThatIsNotFree) {
  const Placer placer = make();
  std::array<double, 2> least{1e9, 1e9};
  for (int scene = 0; scene < 300; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    for (std::size_t i = 0; i < 2; ++i) {
      least[i] = std::min(least[i], clearanceAt(*map, X_GO[i].translation().head<2>()));
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GE(least[i], radii[i] - 1e-9);
    EXPECT_LT(least[i], radii[i] + 0.05) << "nor does it keep a greater distance";
  }
}

TEST_F(ScenePlacerTest, KeepsTheSafetyRadiiBetweenObjects) {
  map = hall(16, 16);
  const Placer placer = make();
  double least = 1e9;
  for (int scene = 0; scene < 300; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    const Vector2d apart = (X_GO[0].translation() - X_GO[1].translation()).head<2>();
    least = std::min(least, apart.norm());
  }
  EXPECT_GE(least, 1.0);
  EXPECT_LT(least, 1.05);
}

TEST_F(ScenePlacerTest, KeepsOutOfWhatTheMapDoesNotKnow) {
  map = hall(30, 30);
  const SolidBox pillar{"pillar", {1.5, 1.0, 5.0}, world::turnedAt({-2, 0, 2.5}, 0.5, {0, 0, 1})};
  standing.push_back(pillar);
  const Placer placer = make();
  double deepest = -1e9;
  for (int scene = 0; scene < 300; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    for (std::size_t i = 0; i < 2; ++i) {
      deepest = std::max(deepest, test::depthOf(object(i, X_GO), pillar));
    }
  }
  EXPECT_LT(deepest, 0.011) << "the contact tolerance is 0.01 m";
  EXPECT_GT(deepest, -0.05) << "but they come near to it";
}

TEST_F(ScenePlacerTest, KeepsOutOfProps) {
  map = hall(20, 20);
  const SolidBox crate{"crate", {2, 2, 2}, at(-3, -1, 1)};
  props.push_back(crate.model());
  config.surface.highest = 0.5;  // no object stands on the crate
  const Placer placer = make();
  for (int scene = 0; scene < 100; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(test::depthOf(object(i, X_GO), crate), 0.011);
  }
}

TEST_F(ScenePlacerTest, StandsOnWhatIsBelow) {
  map = hall(20, 20);
  standing.push_back({"table", {3, 3, 0.2}, at(-3, -1, 0.5)});
  const Placer placer = make();
  int on_table = 0;
  for (int scene = 0; scene < 100; ++scene) {
    const double bottom = placer.place(scene)[0].translation().z() - 0.25;
    const bool is_up = bottom > 0.3;
    EXPECT_NEAR(bottom, is_up ? 0.6 : 0.0, 1e-6);
    on_table += is_up ? 1 : 0;
  }
  EXPECT_GT(on_table, 10);
  EXPECT_LT(on_table, 90);
}

TEST_F(ScenePlacerTest, PutsObjectsAtTheHeightThatIsAskedFor) {
  config.on_surface = false;
  config.height = 1.5;
  EXPECT_EQ(make().place(0)[1].translation().z(), 1.5);
}

TEST_F(ScenePlacerTest, TurnsObjectsAnyWay) {
  map = hall(20, 20);
  config.on_surface = false;
  config.height = 5.0;
  useOnlyAlpha();
  const Placer placer = make();
  std::vector<int> counts(16, 0);
  for (int scene = 0; scene < 4000; ++scene) {
    const double share = (headingOf(placer.place(scene)[0]) + M_PI) / (2.0 * M_PI);
    ++counts.at(std::min<std::size_t>(15, static_cast<std::size_t>(16.0 * share)));
  }
  EXPECT_LT(chiSquared(counts), atMost(15));
}

TEST_F(ScenePlacerTest, BeginsAnewWhenTheFirstLeavesTheLastNoPlace) {
  // A passage of 2.75 m x 1.25 m: if alpha stands near its middle, there is no place for bravo.
  map = hall(11, 5);
  radii = {0.6, 0.6};
  config.tries = 200;
  const Placer placer = make();
  for (int scene = 0; scene < 5; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    EXPECT_GE((X_GO[0].translation() - X_GO[1].translation()).head<2>().norm(), 1.2);
  }
}

// --- In a volume ---

TEST_F(ScenePlacerTest, PutsObjectsAnywhereInTheVolume) {
  useVolume({1, -2, 3}, {3, 2, 4});
  useOnlyAlpha();
  const Placer placer = make();
  std::vector<int> octants(8, 0);
  for (int scene = 0; scene < 4000; ++scene) {
    const Vector3d p_G = placer.place(scene)[0].translation();
    ASSERT_TRUE((p_G.array() >= Eigen::Array3d(1, -2, 3)).all() &&
                (p_G.array() <= Eigen::Array3d(3, 2, 4)).all());
    ++octants[(p_G.x() > 2 ? 4U : 0U) + (p_G.y() > 0 ? 2U : 0U) + (p_G.z() > 3.5 ? 1U : 0U)];
  }
  EXPECT_LT(chiSquared(octants), atMost(7));
}

TEST_F(ScenePlacerTest, PutsObjectsInARowAsOftenAsIsAskedFor) {
  objects.assign(6, {"alpha", {0.6, 0.4, 0.5}});
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].name += std::to_string(i);
  radii.assign(objects.size(), 0.0);
  useVolume({-20, -20, 3}, {20, 20, 3});
  config.upright = true;
  config.rows = 0.25;
  const Placer placer = make();
  int rows = 0;
  constexpr int kScenes = 400;
  for (int scene = 0; scene < kScenes; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    const Vector2d first = X_GO[0].translation().head<2>();
    const Vector2d along = X_GO[5].translation().head<2>() - first;
    const double apart = along.norm() / 5.0;
    bool is_row = apart > 0.4 && apart < 2.5;
    for (std::size_t i = 1; i < 5; ++i) {
      const Vector2d off =
          X_GO[i].translation().head<2>() - first - static_cast<double>(i) / 5.0 * along;
      is_row = is_row && off.norm() < 0.5 * apart;
      is_row = is_row && std::cos(headingOf(X_GO[i]) - headingOf(X_GO[0])) > 0.7;
    }
    rows += is_row ? 1 : 0;
  }
  EXPECT_GT(rows, 0.75 * 0.25 * kScenes) << "some reach out of the volume";
  EXPECT_LT(rows, 1.25 * 0.25 * kScenes);
}

TEST_F(ScenePlacerTest, ClosesTheRowWhereAnObjectIsNotThere) {
  objects.assign(3, {"alpha", {0.6, 0.4, 0.5}});
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].name += std::to_string(i);
  radii.assign(objects.size(), 0.0);
  useVolume({-20, -20, 3}, {20, 20, 3});
  config.rows = 1.0;
  const Placer placer = make();
  placer.world->setPresent({true, false, true});
  int neighbours = 0;
  for (int scene = 0; scene < 100; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    const double apart = (X_GO[2].translation() - X_GO[0].translation()).norm();
    neighbours += apart < 3.0 * 0.6 * 1.5 ? 1 : 0;
  }
  EXPECT_GT(neighbours, 90) << "but for those at the edge of the volume";
}

TEST_F(ScenePlacerTest, TurnsObjectsAnyhowInAVolume) {
  useVolume({-1, -1, 3}, {1, 1, 5});
  useOnlyAlpha();
  const Placer placer = make();
  constexpr int kScenes = 4000;
  double sum = 0.0;
  std::vector<int> octants(8, 0);  // of the directions of the object's z axis
  for (int scene = 0; scene < kScenes; ++scene) {
    const Eigen::Matrix3d R = placer.place(scene)[0].linear();
    sum += Eigen::AngleAxisd(R).angle();
    const Vector3d up = R.col(2);
    ++octants[(up.x() > 0 ? 4U : 0U) + (up.y() > 0 ? 2U : 0U) + (up.z() > 0 ? 1U : 0U)];
  }
  // The angle's density is (1 - cos) / pi: its mean is pi / 2 + 2 / pi, its mean square pi^2 / 3 +
  // 2.
  const double mean = M_PI / 2 + 2 / M_PI;
  const double deviation = std::sqrt(M_PI * M_PI / 3 + 2 - mean * mean);
  EXPECT_NEAR(sum / kScenes, mean, 4.0 * deviation / std::sqrt(kScenes));
  EXPECT_LT(chiSquared(octants), atMost(7));
}

TEST_F(ScenePlacerTest, LeavesUprightWhatIsToBe) {
  useVolume({-1, -1, 3}, {1, 1, 5});
  config.upright = true;
  const Placer placer = make();
  std::vector<int> quarters(4, 0);
  for (int scene = 0; scene < 400; ++scene) {
    const Pose X_GO = placer.place(scene)[1];
    EXPECT_NEAR(X_GO.linear()(2, 2), 1.0, 1e-12);
    ++quarters[(headingOf(X_GO) > 0 ? 2U : 0U) + (std::abs(headingOf(X_GO)) > M_PI / 2 ? 1U : 0U)];
  }
  EXPECT_LT(chiSquared(quarters), atMost(3));
}

TEST_F(ScenePlacerTest, PutsNothingInsideAnythingInAVolume) {
  useVolume({-0.8, -0.8, 0.0}, {0.8, 0.8, 1.2});
  standing.push_back({"wall", {0.2, 3, 3}, at(0, 0, 1.5)});
  const Placer placer = make();
  double deepest = -1e9;
  for (int scene = 0; scene < 200; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    deepest = std::max(deepest, test::depthOf(object(0, X_GO), object(1, X_GO)));
    for (std::size_t i = 0; i < 2; ++i) {
      for (const SolidBox& box : standing) {
        deepest = std::max(deepest, test::depthOf(object(i, X_GO), box));
      }
    }
  }
  EXPECT_LT(deepest, 0.011) << "the contact tolerance is 0.01 m";
  EXPECT_GT(deepest, -0.02) << "but they come near to one another";
}

TEST_F(ScenePlacerTest, MeasuresSafetyRadiiInSpaceInAVolume) {
  useVolume({-0.1, -0.1, 2}, {0.1, 0.1, 4});
  radii = {0.6, 0.6};
  const Placer placer = make();
  for (int scene = 0; scene < 100; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    EXPECT_GE((X_GO[0].translation() - X_GO[1].translation()).norm(), 1.2);
  }
}

// --- Dropped ---

TEST_F(ScenePlacerTest, LaysOnTheFloorWhatIsDropped) {
  useVolume({-0.5, -0.5, 1.0}, {0.5, 0.5, 2.0}, PlacementMode::kDrop);
  const Placer placer = make();
  for (int scene = 0; scene < 10; ++scene) {
    const std::vector<Pose> X_GO = placer.place(scene);
    std::array<double, 2> lowest{1e9, 1e9};
    for (std::size_t i = 0; i < 2; ++i) {
      for (const Vector3d& corner : objects[i].cuboid().corners()) {
        lowest[i] = std::min(lowest[i], (X_GO[i] * corner).z());
      }
      EXPECT_GT(lowest[i], -0.01) << scene;
    }
    EXPECT_LT(std::min(lowest[0], lowest[1]), 0.01) << scene;
    EXPECT_LT(test::depthOf(object(0, X_GO), object(1, X_GO)), 0.011) << scene;
  }
}

TEST_F(ScenePlacerTest, DropsOntoTheWorldAsItWasAtFirst) {
  useVolume({-0.2, -0.2, 1.0}, {0.2, 0.2, 2.0}, PlacementMode::kDrop);
  props.push_back(SolidBox{"crate", {0.5, 0.5, 0.3}, at(0, 0, 0.15)}.model());
  const Placer whole = make();
  for (int scene = 0; scene < 4; ++scene) static_cast<void>(whole.place(scene));
  const std::vector<Pose> X_GO = whole.place(4);
  const Placer alone = make();
  expectSameBits(alone.place(4), X_GO);
  expectSameBits(alone.world->linkPoses(), whole.world->linkPoses());
}

// --- Draws ---

TEST_F(ScenePlacerTest, GivesASceneAloneAsInTheWholeRun) {
  const Placer whole = make();
  for (int scene = 0; scene < 17; ++scene) static_cast<void>(whole.place(scene));
  expectSameBits(make().place(17), whole.place(17));
}

TEST_F(ScenePlacerTest, GivesEachSceneAndSeedPlacesOfItsOwn) {
  const Placer placer = make();
  const Pose X_GO = placer.place(3)[0];
  EXPECT_FALSE(placer.place(4)[0].isApprox(X_GO));
  EXPECT_FALSE(make(2).place(3)[0].isApprox(X_GO));
  EXPECT_FALSE(placer.place(3)[1].isApprox(X_GO)) << "nor does each object";
  EXPECT_TRUE(placer.place(3)[0].isApprox(X_GO));
}

TEST_F(ScenePlacerTest, LeavesAnObjectWhereItIsWithoutTheOthers) {
  map = hall(60, 40);
  const Placer both = make();
  std::swap(objects[0], objects[1]);
  std::swap(radii[0], radii[1]);
  const Placer other_way_round = make();
  objects.erase(objects.begin());
  radii.erase(radii.begin());
  const Placer alone = make();
  ASSERT_EQ(objects[0].name, "alpha");
  int met = 0;
  for (int scene = 0; scene < 100; ++scene) {
    const Pose X_GO = alone.place(scene)[0];
    const std::vector<Pose> before_bravo = both.place(scene);
    const std::vector<Pose> after_bravo = other_way_round.place(scene);
    EXPECT_TRUE(before_bravo[0].matrix() == X_GO.matrix()) << scene;
    const Vector2d apart = (after_bravo[0].translation() - X_GO.translation()).head<2>();
    if (apart.norm() < 1.0) {
      ++met;
    } else {
      EXPECT_TRUE(after_bravo[1].matrix() == X_GO.matrix()) << scene;
    }
  }
  EXPECT_LT(met, 10);
}

TEST_F(ScenePlacerTest, PutsAnObjectThatDoesNotTakePartNowhereAndKeepsNoPlaceForIt) {
  map = hall(60, 40);
  radii[1] = 100.0;  // there is no room for bravo
  const Placer without_bravo = make(1, "bravo");
  objects.pop_back();
  radii.pop_back();
  const Placer alone = make();
  for (int scene = 0; scene < 5; ++scene) {
    const std::vector<std::optional<Pose>> X_GO = without_bravo.placer->place(scene);
    ASSERT_EQ(X_GO.size(), 2U);
    EXPECT_FALSE(X_GO[1].has_value()) << scene;
    EXPECT_TRUE(X_GO[0].value().matrix() == alone.place(scene)[0].matrix()) << scene;
  }
}

// --- What is impossible ---

TEST_F(ScenePlacerTest, NamesEachObjectForWhichTheMapHasNoPlace) {
  map = hall(8, 8);  // 2 m x 2 m
  radii = {5.0, 1.5};
  EXPECT_THAT(
      errors(),
      ElementsAre(AllOf(HasSubstr("placement/map: no place for 'alpha': alpha/safety_radius is "
                                  "5.000 m"),
                        HasSubstr("no free place that is farther than 1.000 m")),
                  HasSubstr("placement/map: no place for 'bravo': bravo/safety_radius is 1.500")));
}

TEST_F(ScenePlacerTest, NamesAMapThatIsFull) {
  map = OccupancyMap(4, 4, 0.5, {}, std::vector<Cell>(16, Cell::kOccupied));
  useOnlyAlpha();
  EXPECT_THAT(errors(),
              ElementsAre(HasSubstr("the map has no free place that is farther than 0.000 m")));
}

TEST_F(ScenePlacerTest, NamesTheWallThatFillsTheVolume) {
  useVolume({-1, -1, 1}, {1, 1, 3});
  standing.push_back({"wall", {9, 9, 9}, at(0, 0, 0)});
  config.tries = 20;
  EXPECT_THAT(errors(),
              ElementsAre(HasSubstr("placement: scene 0, tried 10 times: no place for 'alpha' "
                                    "among 20 (placement/tries): 20 were inside 'wall'")));
}

TEST_F(ScenePlacerTest, NamesTheObjectThatLeavesNoPlace) {
  useVolume({-0.1, -0.1, 2}, {0.1, 0.1, 2.2});
  radii = {0.5, 0.5};
  config.tries = 20;
  EXPECT_THAT(errors(),
              ElementsAre(HasSubstr(
                  "no place for 'bravo' among 20 (placement/tries): 20 were too near 'alpha'")));
}

TEST_F(ScenePlacerTest, TellsThatTheMapLiesOverNothing) {
  standing.clear();
  config.tries = 20;
  EXPECT_THAT(errors(),
              ElementsAre(AllOf(HasSubstr("no place for 'alpha' among 20 (placement/tries): "),
                                HasSubstr(" had nothing below to stand on"))));
}

TEST_F(ScenePlacerTest, TellsThatAllIsTooSteep) {
  standing = {{"ramp", {40, 40, 1}, world::turnedAt({0, 0, 0}, 0.5, {0, 1, 0})}};
  config.surface.highest = 20.0;
  config.tries = 20;
  EXPECT_THAT(errors(), ElementsAre(HasSubstr(" would have stood on something steep")));
}

TEST_F(ScenePlacerTest, TellsWhatFallsForEver) {
  useVolume({-1, -1, 1}, {1, 1, 3}, PlacementMode::kDrop);
  standing.clear();
  config.fall_time = 2.5;
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("what was dropped had not come to rest after "
                                              "placement/fall_time of 2.5 s")));
}

}  // namespace scene_placer_test
}  // namespace synthetic_dataset::randomize
