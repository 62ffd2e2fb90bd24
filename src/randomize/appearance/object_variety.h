#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "randomize/appearance/randomize_options.h"
#include "randomize/appearance/variety/shape_change.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

class PaintedModel;

/// A model that looks like another one of its kind.
struct VariedModel {
  world::Model model;
  std::optional<ShapeChange> shape;  ///< how it differs in shape; nothing: not at all
};

/// Makes variants of a model: worn ones of the same object, or others of the same class. They
/// follow from the model, the seed and each one's number.
class ObjectVariety {
 public:
  /// @param variety  not none
  ObjectVariety(const world::Model& model, Variety variety, std::uint64_t seed);
  ~ObjectVariety();
  ObjectVariety(ObjectVariety&&) noexcept;

  /// @param number  0: the model as it is
  [[nodiscard]] VariedModel variant(int number) const;

 private:
  std::unique_ptr<const world::Model> model_;
  Variety variety_;
  std::uint64_t seed_;
  std::unique_ptr<PaintedModel> painted_;
};

}  // namespace synthetic_dataset::randomize
