/// Measures how many sweeps per second a lidar makes: 64 rings of 1024 columns, all labels, in a
/// hall with 16 balls of some 5,000 triangles that move all the time. This includes advancing the
/// world through the sweep, poses and rays.
///   benchmark_sweeps [SECONDS]

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lidar/sweep_taker.h"
#include "motion/frame_source.h"
#include "world/world.h"

namespace synthetic_dataset {
namespace {

constexpr Stamp kStart = std::chrono::seconds(1'600'000'000);
constexpr int kBalls = 16;

Pose at(double x, double y, double z, double yaw = 0.0) {
  return makePose({x, y, z}, Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())));
}

/// A ball of 2 x 50 x 50 triangles.
std::shared_ptr<const world::Mesh> ball(float radius) {
  constexpr std::uint32_t kSteps = 50;
  auto mesh = std::make_shared<world::Mesh>();
  for (std::uint32_t i = 0; i <= kSteps; ++i) {
    for (std::uint32_t j = 0; j <= kSteps; ++j) {
      const float down = static_cast<float>(M_PI) * static_cast<float>(i) / kSteps;
      const float around = 2.0F * static_cast<float>(M_PI) * static_cast<float>(j) / kSteps;
      const Eigen::Vector3f n(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around),
                              std::cos(down));
      mesh->positions.emplace_back(radius * n);
      mesh->normals.push_back(n);
    }
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    for (std::uint32_t j = 0; j < kSteps; ++j) {
      const std::uint32_t a = i * (kSteps + 1) + j;
      const std::uint32_t b = a + kSteps + 1;
      for (const std::uint32_t corner : {a, b, b + 1, a, b + 1, a + 1}) {
        mesh->indices.push_back(corner);
      }
    }
  }
  return mesh;
}

std::shared_ptr<const world::Mesh> wall(double length) {
  auto mesh = std::make_shared<world::Mesh>();
  const auto half = static_cast<float>(0.5 * length);
  mesh->positions = {{0, -half, -2}, {0, half, -2}, {0, half, 4}, {0, -half, 4}};
  mesh->normals.assign(4, Eigen::Vector3f(-1, 0, 0));
  mesh->indices = {0, 2, 1, 0, 3, 2};
  return mesh;
}

world::Model modelOf(const std::string& name, const std::shared_ptr<const world::Mesh>& mesh,
                     const Pose& X_WM, bool is_static) {
  world::Visual visual;
  visual.surfaces.push_back({mesh, {}});
  visual.surfaces.back().material.double_sided = true;
  world::Link link;
  link.name = "body";
  link.visuals.push_back(visual);
  world::Model model;
  model.name = name;
  model.is_static = is_static;
  model.X_WM = X_WM;
  model.links.push_back(link);
  return model;
}

/// A scanner that drives at 2 m/s and turns at 1 rad/s.
class Driving : public motion::FrameSource {
 public:
  Driving() : FrameSource("map") { (void)names_.findOrAdd("scanner"); }
  [[nodiscard]] const motion::FrameNames& names() const override { return names_; }
  [[nodiscard]] std::optional<Pose> pose(motion::FrameId /*frame*/, Stamp time) const override {
    const double t = toSeconds(time - kStart);
    return at(2.0 * std::sin(t), -2.0 * std::cos(t), 0.2, t);
  }
  [[nodiscard]] motion::Timeline timeline(const std::vector<std::string>& /*frames*/,
                                          const motion::TimelineOptions&) const override {
    return {};
  }
  [[nodiscard]] std::string title() const override { return "the way"; }

 private:
  motion::FrameNames names_;
};

world::ObjectPose ballPose(int ball, Stamp time) {
  const double t = toSeconds(time - kStart);
  const double angle = 0.6 * t + 2.0 * M_PI * ball / kBalls;
  const double radius = 4.0 + (ball % 4);
  return at(radius * std::cos(angle), radius * std::sin(angle), 0.1 * (ball % 5), t);
}

void run(double seconds) {
  world::Description description;
  for (int i = 0; i < 4; ++i) {
    const double yaw = 0.5 * M_PI * i;
    description.models.push_back(modelOf("wall" + std::to_string(i), wall(24),
                                         at(12 * std::cos(yaw), 12 * std::sin(yaw), 0, yaw), true));
  }
  std::vector<world::MovingObject> objects;
  for (int i = 0; i < kBalls; ++i) {
    objects.emplace_back(modelOf("ball" + std::to_string(i), ball(0.5F), Pose::Identity(), false));
  }
  world::World world(std::move(description), std::move(objects), world::PhysicsOptions());
  const Driving frames;
  lidar::LidarOptions options;
  options.name = "top";
  options.frame = "scanner";
  options.model = *lidar::modelOf("OS1-64");
  base::Diagnostics notes;
  const std::vector<lidar::LidarRig> lidars = {lidar::makeLidarRig(options, {}, frames, notes)};
  std::vector<lidar::LinkLabel> labels;
  for (const world::LinkInstance& link : world.links()) {
    labels.push_back({static_cast<std::uint16_t>(link.object + 1), 0, 0, 0});
  }
  lidar::SweepTaker taker(world, frames, lidars, labels, render::GlassInLabels::kOfObjects, 7);
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t processor_begin = std::clock();
  double passed = 0.0;
  std::int64_t sweeps = 0;
  std::size_t points = 0;
  for (; passed < seconds; ++sweeps) {
    const Stamp stamp = kStart + sweeps * std::chrono::milliseconds(100);
    taker.begin(stamp);
    for (const Duration offset : taker.offsets(stamp)) {
      world.advanceTo(stamp + offset, ballPose);
      taker.look(offset);
    }
    points += taker.take(sweeps, {})().clouds.front()->points.size();
    passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  const double processor =
      static_cast<double>(std::clock() - processor_begin) / static_cast<double>(CLOCKS_PER_SEC);
  std::printf("%.1f sweeps a second of 65536 rays, %zu points each, %.1f ms of processor time\n",
              static_cast<double>(sweeps) / passed, points / static_cast<std::size_t>(sweeps),
              1000.0 * processor / static_cast<double>(sweeps));
}

}  // namespace
}  // namespace synthetic_dataset

int main(int argc, char** argv) {
  synthetic_dataset::run(argc > 1 ? std::atof(argv[1]) : 5.0);
  return 0;
}
