#include "loaders/hard_cases.h"

#include "base/random/random_source.h"
#include "support/bag_builder.h"
#include "support/robot_arm.h"

namespace synthetic_dataset::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A name with what is special in XML, JSON, YAML and CSV, and is not ASCII.
constexpr char kOddClass[] = "b\u00e4ll <\"1\", a & b>: #x";

/// The pose of an object whose origin falls on a pixel: turned by `angle` about a skew axis.
Pose at(double u, double v, double z, double angle = 0.0) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, -0.5).normalized();
  return makePose(LoaderCamera::behind(u, v, z),
                  Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)));
}

Pose turnedAboutX(const Eigen::Vector3d& position, double angle) {
  return makePose(position, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX())));
}

/// A box of 0.4 m x 0.3 m x 0.2 m with a keypoint on each of four faces and one inside.
LoaderObject rover(const std::string& name, const std::string& colour) {
  return {name,
          "rover",
          colour,
          {boxVisual("0.05 0 0 0 0 0", "0.4 0.3 0.2")},
          {{0.25, 0.0, 0.0}, {0.05, 0.15, 0.0}, {0.05, -0.15, 0.0}, {0.05, 0.0, 0.1}, {0, 0, 0}},
          ""};
}

/// Four bars around a hole of 0.6 m.
LoaderObject frame() {
  return {"frame",
          "frame",
          "0.9 0.8 0.1",
          {boxVisual("0 0.35 0 0 0 0", "0.8 0.1 0.1"), boxVisual("0 -0.35 0 0 0 0", "0.8 0.1 0.1"),
           boxVisual("0.35 0 0 0 0 0", "0.1 0.6 0.1"), boxVisual("-0.35 0 0 0 0 0", "0.1 0.6 0.1")},
          {{0.35, 0.35, -0.05}, {-0.35, 0.35, -0.05}, {0.0, 0.0, 0.0}},
          ""};
}

/// Floor, ceiling and two walls, with nothing ahead and behind.
LoaderObject tunnel() {
  return {"tunnel",
          "tunnel",
          "0.4 0.5 0.6",
          {boxVisual("0 1 0 0 0 0", "2 0.1 6"), boxVisual("0 -1 0 0 0 0", "2 0.1 6"),
           boxVisual("1 0 0 0 0 0", "0.1 2 6"), boxVisual("-1 0 0 0 0 0", "0.1 2 6")},
          {},
          ""};
}

/// Where the links of the robot arm are, in the arm.
std::map<std::string, Pose> armLinks(double shoulder, double elbow) {
  const Pose X_OU = poseAt(0, 0, 0.2, shoulder);
  const Pose X_UF =
      makePose({0, 0, 0.5}, Eigen::Quaterniond(Eigen::AngleAxisd(elbow, Eigen::Vector3d::UnitY())));
  return {{"upper", X_OU}, {"fore", Pose(X_OU * X_UF)}};
}

std::string staticBox(const std::string& name, const std::string& pose, const std::string& size) {
  return "<model name='" + name + "'><static>true</static><pose>" + pose +
         "</pose><link name='body'><visual name='v'><geometry><box><size>" + size +
         "</size></box></geometry></visual></link></model>\n";
}

/// A box that stands on its origin.
LoaderObject standing(const std::string& name, const std::string& class_name,
                      const std::string& colour, const Eigen::Vector3d& size) {
  const auto text = [](double number) { return std::to_string(number); };
  return {name,
          class_name,
          colour,
          {boxVisual("0 0 " + text(size.z() / 2) + " 0 0 0",
                     text(size.x()) + " " + text(size.y()) + " " + text(size.z()))},
          {},
          ""};
}

}  // namespace

LoaderDataset hardCases() {
  LoaderObject arm{"arm", "arm", "", {}, {{0.2, 0.0, 0.1}}, kRobotArm};
  LoaderDataset dataset({rover("alpha", "0.9 0.2 0.1"),
                         rover("bravo", "0.1 0.3 0.9"),
                         rover("charlie", "0.2 0.8 0.3"),
                         frame(),
                         tunnel(),
                         arm,
                         {"ball 1",
                          kOddClass,
                          "0.8 0.3 0.8",
                          {sphereVisual("0 0 0 0 0 0", 0.2)},
                          {{0.0, 0.0, -0.2}},
                          ""}});
  dataset.set("classes", Value::Map{{"rover", 0},
                                    {"frame", 2},
                                    {"tunnel", 3},
                                    {kOddClass, 5},
                                    {"arm", 6},
                                    {"never seen", 8}});
  dataset.addToWorld(staticBox("post", "0.9 0 2 0 0 0", "0.06 3 0.06"));
  const Pose upright = turnedAboutX({-0.4, 0.5, 2.5}, kPi / 2);  // the arm's z up, the image's -y
  // Partly out of the image, on each side.
  dataset.addTime({{"alpha", at(0, 120, 2, 0.4)},
                   {"bravo", at(320, 100, 2.5, 1.0)},
                   {"ball 1", at(100, 2, 2)},
                   {"frame", at(200, 239, 3, 0.2)}});
  // A corner of the image, and out of it on two sides at once; bravo and charlie wholly outside.
  dataset.addTime({{"alpha", at(318, 238, 1.5, 0.7)},
                   {"tunnel", at(160, 120, 9)},
                   {"bravo", at(-200, 100, 2)},
                   {"charlie", at(100, 600, 2)}});
  // Fully hidden behind another, and seen through the hole of a third.
  dataset.addTime({{"alpha", at(80, 120, 2)},
                   {"bravo", at(80, 120, 4)},
                   {"frame", at(220, 120, 2, 0.1)},
                   {"ball 1", at(225, 122, 4)}});
  // The camera inside an object.
  dataset.addTime({{"tunnel", poseAt(0, 0, 1)}, {"alpha", at(120, 150, 3, 2.0)}});
  // A pixel large, smaller than a pixel, and two of one class that touch.
  dataset.addTime({{"ball 1", at(60, 60, 110)},
                   {"frame", at(100.5, 60.5, 900)},
                   {"alpha", poseAt(-0.25, 0.2, 2)},
                   {"bravo", poseAt(0.15, 0.2, 2)},
                   {"charlie", poseAt(0.15, -0.1, 2)}});
  // Behind the camera alone, with nothing in view.
  dataset.addTime({{"alpha", poseAt(0, 0, -0.5)}, {"bravo", poseAt(0.2, 0.1, -3)}});
  // Half behind the camera: beside it, through its image plane.
  dataset.addTime({{"frame", turnedAboutX({0.0, 0.05, 0.2}, 1.2)}, {"charlie", at(200, 80, 2)}});
  // Cut in two by the post, which is of the world; and the arm with its elbow bent.
  dataset.addTime({{"alpha", poseAt(1.35, 0.0, 3)}, {"arm", upright}}, armLinks(0.5, -0.8));
  dataset.addTime({{"arm", upright}, {"ball 1", at(100, 120, 2)}}, armLinks(-0.5, 1.2));
  // One before the other, turned in all axes.
  dataset.addTime({{"alpha", at(140, 110, 2.0, 2.5)},
                   {"bravo", at(170, 130, 2.4, -1.0)},
                   {"charlie", at(120, 130, 2.9, 0.9)},
                   {"frame", at(150, 120, 1.8, 0.6)}});
  return dataset;
}

LoaderDataset hardCasesThroughLens() {
  LoaderDataset dataset = hardCases();
  dataset.setDistortion({-0.25, 0.08, 0.002, -0.003, 0.0});
  return dataset;
}

LoaderDataset emptyScenes() {
  LoaderDataset dataset({rover("alpha", "0.9 0.2 0.1"), frame()});
  dataset.addTime({});
  dataset.addTime({{"alpha", at(-300, 120, 2)}});
  return dataset;
}

LoaderDataset manyObjects() {
  constexpr int kColumns = 20;
  constexpr int kRows = 15;
  std::vector<LoaderObject> objects;
  std::map<std::string, Pose> places;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const std::string name = "o" + std::to_string(i);
    const std::string colour = std::to_string(0.2 + 0.002 * i) + " 0.5 0.4";
    objects.push_back({name,
                       i % 3 == 0 ? "0" : "4",
                       colour,
                       {boxVisual("0 0 0 0 0 0", "0.24 0.2 0.1")},
                       {{0.12, 0.0, 0.0}},
                       ""});
    places[name] = at(8 + 16 * (i % kColumns), 8 + 16 * (i / kColumns), 5, 0.01 * i);
  }
  LoaderDataset dataset(objects);
  dataset.addTime(places);
  dataset.addTime(places);
  return dataset;
}

LoaderDataset camerasAndSplits() {
  LoaderDataset dataset({rover("alpha", "0.9 0.2 0.1"), rover("bravo", "0.1 0.3 0.9"), frame()});
  constexpr int kTimes = 10;
  for (int i = 0; i < kTimes; ++i) {
    dataset.addTime({{"alpha", at(20.0 + 30 * i, 100, 2, 0.3 * i)},
                     {"bravo", at(300.0 - 25 * i, 130, 2.5, 0.2 * i)},
                     {"frame", at(160, 120, 3.2, 0.1 * i)}});
  }
  dataset.addCamera("rear", makePose({-1.5, 0.3, 1.0}, Eigen::Quaterniond(Eigen::AngleAxisd(
                                                           0.7, Eigen::Vector3d::UnitY()))));
  dataset.set("split", Value::Map{{"train", 0.6}, {"val", 0.2}, {"test", 0.2}});
  return dataset;
}

LoaderDataset lidarScenes() {
  LoaderDataset dataset({rover("alpha", "0.9 0.2 0.1"), rover("bravo", "0.1 0.3 0.9"), frame()});
  const auto upright = [](double x, double z) { return turnedAboutX({x, 0.1, z}, kPi / 2.0); };
  constexpr int kTimes = 6;
  for (int i = 0; i < kTimes; ++i) {
    // `bravo` is to the left of the picture.
    dataset.addTime({{"alpha", upright(0.1, 2.0)},
                     {"bravo", upright(-2.2, 2.0)},
                     {"frame", upright(0.3, 3.0)}});
  }
  const Value::Map beams{{"count", 48}, {"first", -0.3}, {"last", 0.3}};
  // x ahead is the optical frame's z, y left its -x.
  const Value::List pose{0.0, -0.2, 0.1, 0.5, -0.5, 0.5, 0.5};
  dataset.set("lidars", Value::Map{{"top", Value::Map{{"beams", beams},
                                                      {"columns", 400},
                                                      {"azimuth", Value::List{1.0, -1.0}},
                                                      {"pose", pose}}}});
  dataset.set("split", Value::Map{{"train", 0.5}, {"val", 0.5}});
  return dataset;
}

LoaderDataset movingLidar() {
  LoaderDataset dataset({tunnel(), rover("carrier", "0.2 0.6 0.3")});
  // x ahead is the optical frame's z, y left its -x.
  const Eigen::Quaterniond level(0.5, 0.5, -0.5, 0.5);
  constexpr int kTimes = 10;
  for (int i = 0; i < kTimes; ++i) {
    const Eigen::AngleAxisd turn(0.1 * i, Eigen::Vector3d::UnitZ());
    dataset.addTime({{"tunnel", Pose::Identity()},
                     {"carrier", makePose({0.0, 0.5, 1.1 + 0.2 * i}, level * turn)}});
  }
  dataset.set(
      "lidars",
      Value::Map{
          {"top", Value::Map{{"beams", Value::Map{{"count", 16}, {"first", -0.3}, {"last", 0.3}}},
                             {"columns", 200},
                             {"mounted_on", "carrier"},
                             {"pose", Value::List{0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0}}}}});
  return dataset;
}

LoaderDataset streets() {
  constexpr int kRows = 3;
  constexpr int kTimes = 120;
  constexpr double kBetweenRows = 4.5;
  const std::string car = "vehicle.car";
  const std::string pedestrian = "human.pedestrian.adult";
  const std::string cone = "movable_object.trafficcone";
  std::vector<LoaderObject> objects;
  for (int i = 0; i < kRows; ++i) {
    const std::string number = std::to_string(i);
    objects.push_back(standing("car" + number, car, "0.8 0.2 0.2", {4.0, 1.7, 1.5}));
    objects.push_back(standing("person" + number, pedestrian, "0.2 0.3 0.8", {0.5, 0.6, 1.75}));
    objects.push_back(standing("cone" + number, cone, "0.9 0.5 0.1", {0.4, 0.4, 0.7}));
  }
  LoaderDataset dataset(objects);
  dataset.addToWorld(staticBox("road", "20 0 -0.05 0 0 0", "60 80 0.1"));
  dataset.addToWorld(staticBox("wall", "30 0 3 0 0 0", "0.2 80 6"));
  dataset.addToWorld(
      "<light name='noon' type='directional'><direction>0.3 0.4 -0.8</direction></light>");
  dataset.addCamera("front", makePose({0, 0, 1.6}, Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5)));
  base::RandomSource random(1);
  for (int i = 0; i < kTimes; ++i) {
    std::map<std::string, Pose> places;
    for (int row = 0; row < kRows; ++row) {
      const std::string number = std::to_string(row);
      const double x = 7.0 + kBetweenRows * row;
      const double y = random.uniform(-0.3, 0.3) * x;
      const double side = random.index(2) == 0 ? 1.0 : -1.0;
      const auto beside = [&](double direction) {  // Statements, for the order of the numbers.
        const double aside = direction * random.uniform(2.6, 3.2);
        const double ahead = random.uniform(-1, 1);
        return poseAt(x + ahead, y + aside, 0, random.angle());
      };
      places["car" + number] = poseAt(x, y, 0, random.angle());
      places["person" + number] = beside(side);
      places["cone" + number] = beside(-side);
    }
    dataset.addTime(places);
  }
  const Value::Map beams{{"count", 32}, {"first", -0.3}, {"last", 0.1}};
  // From time to time objects leap, so that a sweep has to be short: they move 2 cm in its half.
  dataset.set("lidars",
              Value::Map{{"top", Value::Map{{"beams", beams},
                                            {"columns", 300},
                                            {"azimuth", Value::List{0.8, -0.8}},
                                            {"rate", 1000.0},
                                            {"pose", Value::List{0, 0, 1.8, 0, 0, 0, 1}}}}});
  dataset.set("split", Value::Map{{"train", 0.84}, {"val", 0.08}, {"test", 0.08}});
  const Value::Map types{{car, "Car"}, {pedestrian, "Pedestrian"}, {cone, "Misc"}};
  dataset.set("kitti_lidar", Value::Map{{"class_names", types}});
  return dataset;
}

}  // namespace synthetic_dataset::test
