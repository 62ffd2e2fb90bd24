#include "run/setup/scene_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {
namespace {

/// Divides `total` in proportion to the shares, without a remainder.
std::vector<std::int64_t> apportion(const std::vector<double>& shares, std::int64_t total) {
  std::vector<std::int64_t> counts;
  for (const double share : shares) {
    counts.push_back(static_cast<std::int64_t>(std::floor(share * static_cast<double>(total))));
  }
  std::vector<std::size_t> order(shares.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto remainder = [&](std::size_t i) {
    return shares[i] * static_cast<double>(total) - static_cast<double>(counts[i]);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainder(a) > remainder(b); });
  const std::int64_t given = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  for (std::size_t i = 0; i < order.size() && given + static_cast<std::int64_t>(i) < total; ++i) {
    ++counts[order[i]];
  }
  return counts;
}

bool isEnough(const std::vector<SharingMotion>& motions, const std::vector<std::int64_t>& counts) {
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (counts[i] > motions[i].available) return false;
  }
  return true;
}

/// The shares of the largest total for which every motion has enough scenes.
std::vector<std::int64_t> maxKept(const std::vector<SharingMotion>& motions,
                                  const std::vector<double>& shares) {
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < motions.size(); ++i) {
    most = std::min(most, static_cast<double>(motions[i].available) / shares[i]);
  }
  // Rounding may give a motion one more than its share.
  constexpr double kRounding = 1e-9;
  auto total = static_cast<std::int64_t>(std::floor(most * (1.0 + kRounding)));
  while (total > 0 && !isEnough(motions, apportion(shares, total))) --total;
  return apportion(shares, total);
}

}  // namespace

std::vector<std::int64_t> sharesOf(const std::vector<SharingMotion>& motions,
                                   std::optional<std::int64_t> total) {
  double sum = 0.0;
  for (const SharingMotion& motion : motions) sum += motion.weight;
  std::vector<double> shares;
  for (const SharingMotion& motion : motions) shares.push_back(motion.weight / sum);
  const std::vector<std::int64_t> counts =
      total ? apportion(shares, *total) : maxKept(motions, shares);
  std::vector<std::string> errors;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const SharingMotion& motion = motions[i];
    const std::string found = motion.group + "/weight: found " + Value(motion.weight).text() +
                              " of " + Value(sum).text() + " in all, ";
    if (counts[i] > motion.available) {
      errors.push_back(
          found + "which is " + std::to_string(counts[i]) + " of the " + std::to_string(*total) +
          " scenes; this motion has " + std::to_string(motion.available) +
          " (fewer scenes in all, a smaller weight or more scenes of this motion help)");
    } else if (counts[i] == 0) {
      errors.push_back(found + "which is less than one scene; it should be larger" +
                       (total ? ", or scenes should" : ""));
    }
  }
  if (!errors.empty()) throw ErrorList(std::move(errors));
  return counts;
}

}  // namespace synthetic_dataset::run
