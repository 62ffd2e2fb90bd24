#include "lidar/firing_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace synthetic_dataset::lidar {
namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;

double turnShare(const LidarModel& model) {
  return std::abs(model.last_azimuth - model.first_azimuth) / kTurn;
}

}  // namespace

bool isWholeTurn(const LidarModel& model) {
  constexpr double kRounding = 1e-3;  // [rad]; files give pi with few decimals
  return std::abs(model.last_azimuth - model.first_azimuth) >= kTurn - kRounding;
}

int columnsOf(const LidarModel& model) {
  if (!model.column_period) return model.columns;
  const double count = turnShare(model) / (model.rate * *model.column_period);
  return std::max(1, static_cast<int>(std::floor(count + 1e-6)));
}

Duration sweepTime(const LidarModel& model) {
  return Duration(static_cast<std::int64_t>(1e9 * turnShare(model) / model.rate));
}

FiringPlan::FiringPlan(const LidarModel& model)
    : columns_(columnsOf(model)),
      length_(sweepTime(model)),
      first_azimuth_(model.first_azimuth),
      steps_(isWholeTurn(model) || columns_ == 1 ? columns_ : columns_ - 1),
      azimuth_offsets_(model.azimuth_offsets),
      shares_(model.elevations.size(), 0.0) {
  azimuth_step_ = (model.last_azimuth - model.first_azimuth) / steps_;
  for (const double each : model.elevations) {
    elevations_.push_back({std::cos(each), std::sin(each)});
  }
  azimuth_offsets_.resize(elevations_.size(), 0.0);
  const double column_time = toSeconds(length_) / steps_;
  for (std::size_t ring = 0; ring < model.firing_times.size() && column_time > 0.0; ++ring) {
    shares_[ring] = std::min(model.firing_times[ring] / column_time, 1.0);
  }
  const auto isNone = [](double each) { return each == 0.0; };
  if (!std::all_of(shares_.begin(), shares_.end(), isNone) ||
      !std::all_of(azimuth_offsets_.begin(), azimuth_offsets_.end(), isNone)) {
    return;
  }
  for (int column = 0; column < columns_; ++column) {
    const double azimuth = first_azimuth_ + column * azimuth_step_;
    azimuths_.push_back({std::cos(azimuth), std::sin(azimuth)});
  }
}

Duration FiringPlan::columnTime(int column) const {
  const auto whole = static_cast<double>(length_.count());
  const std::int64_t half = length_.count() / 2;
  const double share = std::min(column / steps_, 1.0);
  return Duration(std::min(std::llround(share * whole) - half, static_cast<long long>(half)));
}

Eigen::Vector3d FiringPlan::direction(int column, int ring) const {
  const auto at = static_cast<std::size_t>(ring);
  const auto& [flat, up] = elevations_[at];
  if (!azimuths_.empty()) {
    const auto& [cosine, sine] = azimuths_[static_cast<std::size_t>(column)];
    return {flat * cosine, flat * sine, up};
  }
  const double azimuth =
      first_azimuth_ + (column + shares_[at]) * azimuth_step_ + azimuth_offsets_[at];
  return {flat * std::cos(azimuth), flat * std::sin(azimuth), up};
}

}  // namespace synthetic_dataset::lidar
