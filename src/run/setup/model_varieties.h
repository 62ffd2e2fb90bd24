#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "randomize/appearance/object_variety.h"
#include "scene/object_options.h"
#include "scene/object_variants.h"
#include "world/description.h"
#include "world/files/template_file.h"

namespace synthetic_dataset::run {

/// Variants of models, each made once: objects with the same model share them, and so do motions.
class ModelVarieties {
 public:
  /// @param own  the model of the object's variant as it is
  /// @param variant  whose number is not 0
  /// @param seed  of the run; what was made with another one is let go of
  const randomize::VariedModel& variantOf(const world::Model& own, world::Simulator simulator,
                                          const scene::ObjectVariant& variant,
                                          const scene::ObjectOptions& object, std::uint64_t seed);

 private:
  /// The model, or the object whose model is the world's, and the kind of variety.
  using Key = std::tuple<std::optional<std::string>, std::string, world::TemplateArguments,
                         world::Simulator, randomize::Variety>;

  /// Variants of a model, by their numbers.
  struct Varieties {
    std::optional<randomize::ObjectVariety> source;
    std::map<int, randomize::VariedModel> made;
  };

  std::uint64_t seed_ = 0;
  std::map<Key, Varieties> varieties_;
};

}  // namespace synthetic_dataset::run
