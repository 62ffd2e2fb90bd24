#include "randomize/appearance/entry_draws.h"

namespace synthetic_dataset::randomize {

base::RandomSource EntryDraws::source(const std::string& name) const {
  return {seed_, scene_, "randomize/" + (owner_.empty() ? "" : owner_ + ":") + name};
}

std::optional<double> EntryDraws::number(const std::string& name,
                                         const std::optional<base::Distribution>& distribution) {
  if (!distribution) return std::nullopt;
  base::RandomSource random = source(name);
  const double value = distribution->drawNumber(random);
  values_.push_back({name, std::vector<double>{value}});
  return value;
}

std::optional<Eigen::Vector3d> EntryDraws::vector(
    const std::string& name, const std::optional<base::Distribution>& distribution) {
  if (!distribution) return std::nullopt;
  base::RandomSource random = source(name);
  const std::vector<double> value = distribution->draw(random);
  values_.push_back({name, value});
  return Eigen::Vector3d(value[0], value[1], value[2]);
}

bool EntryDraws::happens(const std::string& name, double probability) {
  const bool happens = source(name).unit() < probability;
  values_.push_back({name, std::vector<double>{happens ? 1.0 : 0.0}});
  return happens;
}

void EntryDraws::replace(const std::string& name, double value) {
  for (DrawnValue& drawn : values_) {
    if (drawn.name == name) drawn.value = std::vector<double>{value};
  }
}

}  // namespace synthetic_dataset::randomize
