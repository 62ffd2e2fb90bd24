#include "run/setup/model_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace synthetic_dataset::run {
namespace {

constexpr std::size_t kHues = 12;

/// Colours of like hue, by how much they stand out.
struct Hue {
  double weight = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  ///< of colours times their weight
};

using Hues = std::array<Hue, kHues>;

/// @param colour  red, green, blue, 0 .. 1
void add(const Eigen::Vector3d& colour, double share, Hues& hues) {
  constexpr double kGrey = 0.3;  // of the brightest channel; less is no colour
  const double high = colour.maxCoeff();
  const double range = high - colour.minCoeff();
  if (range < kGrey * high || high <= 0.0) return;
  double turn = 0.0;  // sixths, from red over green to blue
  if (high == colour.x()) {
    turn = (colour.y() - colour.z()) / range;
  } else if (high == colour.y()) {
    turn = 2.0 + (colour.z() - colour.x()) / range;
  } else {
    turn = 4.0 + (colour.x() - colour.y()) / range;
  }
  const double place = (turn / 6.0 - std::floor(turn / 6.0)) * static_cast<double>(kHues);
  Hue& hue = hues.at(static_cast<std::size_t>(place) % kHues);
  hue.weight += share * range;
  hue.sum += share * range * colour;
}

void addMaterial(const world::Material& material, Hues& hues) {
  const Eigen::Vector3d diffuse = material.diffuse.head<3>().cast<double>();
  if (!material.texture) return add(diffuse, 1.0, hues);
  constexpr int kSteps = 64;  // along each side: enough to know the colours
  const cv::Mat& pixels = material.texture->pixels;
  if (pixels.type() != CV_8UC4) return;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const auto& pixel = pixels.at<cv::Vec4b>((i / kSteps) * pixels.rows / kSteps,
                                             (i % kSteps) * pixels.cols / kSteps);
    const Eigen::Vector3d colour = Eigen::Vector3d(pixel[2], pixel[1], pixel[0]) / 255.0;
    add(colour.cwiseProduct(diffuse), 1.0 / (kSteps * kSteps), hues);
  }
}

}  // namespace

std::vector<Eigen::Vector3d> strikingColours(const world::Model& model) {
  Hues hues;
  for (const world::Link& link : model.links) {
    for (const world::Visual& visual : link.visuals) {
      for (const world::Surface& surface : visual.surfaces) addMaterial(surface.material, hues);
    }
  }
  std::array<std::size_t, kHues> order{};
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return hues[a].weight > hues[b].weight; });
  constexpr std::size_t kMost = 2;
  constexpr double kLeast = 0.25;  // of the weight of the first
  std::vector<Eigen::Vector3d> colours;
  for (std::size_t i = 0; i < kMost; ++i) {
    const Hue& hue = hues[order[i]];
    const bool counts = hue.weight > 0.0 && hue.weight >= kLeast * hues[order[0]].weight;
    if (counts) colours.emplace_back(hue.sum / hue.weight);
  }
  return colours;
}

}  // namespace synthetic_dataset::run
