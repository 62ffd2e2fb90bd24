#include "run/setup/model_varieties.h"

#include "world/material/default_paint.h"

namespace synthetic_dataset::run {

const randomize::VariedModel& ModelVarieties::variantOf(const world::Model& own,
                                                        world::Simulator simulator,
                                                        const scene::ObjectVariant& variant,
                                                        const scene::ObjectOptions& object,
                                                        std::uint64_t seed) {
  if (seed != seed_) varieties_.clear();
  seed_ = seed;
  Varieties& varieties = varieties_[{variant.model, variant.model ? "" : object.name,
                                     object.model_arguments, simulator, variant.variety}];
  if (!varieties.source) {
    world::Model painted = own;
    world::paintDefaults(simulator, painted);
    varieties.source.emplace(painted, variant.variety, seed);
  }
  const auto made = varieties.made.find(variant.number);
  if (made != varieties.made.end()) return made->second;
  return varieties.made.emplace(variant.number, varieties.source->variant(variant.number))
      .first->second;
}

}  // namespace synthetic_dataset::run
