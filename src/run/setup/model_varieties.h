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

/// Variants of models, each made once and shared by all objects and motions with the same model.
class ModelVarieties {
 public:
  /// @param own  the unmodified model of the object's variant
  /// @param variant  its number is not 0
  /// @param seed  of the run; variants made with another seed are released
  const randomize::VariedModel& variantOf(const world::Model& own, world::Simulator simulator,
                                          const scene::ObjectVariant& variant,
                                          const scene::ObjectOptions& object, std::uint64_t seed);

 private:
  /// The model (or the object, if its model comes from the world) and the kind of variety.
  using Key = std::tuple<std::optional<std::string>, std::string, world::TemplateArguments,
                         world::Simulator, randomize::Variety>;

  /// Variants of a model, by number.
  struct Varieties {
    std::optional<randomize::ObjectVariety> source;
    std::map<int, randomize::VariedModel> made;
  };

  std::uint64_t seed_ = 0;
  std::map<Key, Varieties> varieties_;
};

}  // namespace synthetic_dataset::run
