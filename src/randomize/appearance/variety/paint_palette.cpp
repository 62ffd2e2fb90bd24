#include "randomize/appearance/variety/paint_palette.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace synthetic_dataset::randomize {
namespace {

constexpr float kSamePaint = 0.32F;  // distance of features
constexpr std::size_t kMostPaints = 8;

/// Hue and saturation, which shading hardly changes, and a little of the lightness, to tell white
/// from black.
Eigen::Vector3f featureOf(const Eigen::Vector3f& colour) {
  const float lightness = lightnessOf(colour);
  constexpr float kDark = 0.15F;  // below which hues are hardly visible
  return {(colour[2] - lightness) / (lightness + kDark),
          (colour[0] - lightness) / (lightness + kDark), 0.5F * lightness};
}

}  // namespace

void ColourCount::add(const Eigen::Vector3f& colour, double amount) {
  const auto index = [&](int channel) {
    const float scaled = std::clamp(colour[channel], 0.0F, 1.0F) * kSide;
    return std::min(static_cast<std::size_t>(scaled), kSide - 1);
  };
  Cell& cell = cells_[(index(0) * kSide + index(1)) * kSide + index(2)];
  cell.sum += amount * colour.cast<double>();
  cell.amount += amount;
}

/// The most common colours become paints; others belong to the paints they are most like.
PaintPalette::PaintPalette(const ColourCount& count) {
  std::vector<std::size_t> order(count.cells_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return count.cells_[a].amount > count.cells_[b].amount;
  });
  double all = 0.0;
  for (const ColourCount::Cell& cell : count.cells_) all += cell.amount;
  constexpr double kLeast = 0.01;  // of the surface, in one cell
  for (const std::size_t i : order) {
    const ColourCount::Cell& cell = count.cells_[i];
    if (paints_.size() == kMostPaints || cell.amount <= 0.0) break;
    const Eigen::Vector3f mean = (cell.sum / cell.amount).cast<float>();
    const Eigen::Vector3f feature = featureOf(mean);
    const bool is_known = std::any_of(
        features_.begin(), features_.end(),
        [&](const Eigen::Vector3f& other) { return (feature - other).norm() < kSamePaint; });
    if (is_known || (!paints_.empty() && cell.amount < kLeast * all)) continue;
    paints_.push_back({mean, 0.0});
    features_.push_back(feature);
  }
  if (paints_.empty()) {
    paints_.push_back({Eigen::Vector3f::Constant(0.7F), 1.0});
    features_.push_back(featureOf(paints_.front().colour));
    return;
  }
  for (int round = 0; round < 2; ++round) merge(count);
}

/// Lloyd's step: each paint becomes the mean of the colours closest to it.
void PaintPalette::merge(const ColourCount& count) {
  std::vector<ColourCount::Cell> sums(paints_.size());
  double all = 0.0;
  for (const ColourCount::Cell& cell : count.cells_) {
    if (cell.amount <= 0.0) continue;
    ColourCount::Cell& sum = sums[likeness((cell.sum / cell.amount).cast<float>()).first];
    sum.sum += cell.sum;
    sum.amount += cell.amount;
    all += cell.amount;
  }
  for (std::size_t i = 0; i < paints_.size(); ++i) {
    if (sums[i].amount <= 0.0) continue;
    paints_[i] = {(sums[i].sum / sums[i].amount).cast<float>(), sums[i].amount / all};
    features_[i] = featureOf(paints_[i].colour);
  }
}

PaintPalette::Likeness PaintPalette::likeness(const Eigen::Vector3f& colour) const {
  const Eigen::Vector3f feature = featureOf(colour);
  float nearest = std::numeric_limits<float>::max();
  float next = std::numeric_limits<float>::max();
  Likeness result;
  for (std::size_t i = 0; i < features_.size(); ++i) {
    const float distance = (features_[i] - feature).norm();
    if (distance < nearest) {
      next = nearest;
      result.second = result.first;
      nearest = distance;
      result.first = i;
    } else if (distance < next) {
      next = distance;
      result.second = i;
    }
  }
  const bool is_alone = features_.size() == 1;
  // Halfway between two paints a colour is a mixture, near one of them it is that one only.
  const float share = is_alone ? 0.0F : nearest / std::max(nearest + next, 1e-6F);
  result.share = std::clamp(2.0F * (share - 0.25F), 0.0F, 0.5F);
  return result;
}

}  // namespace synthetic_dataset::randomize
