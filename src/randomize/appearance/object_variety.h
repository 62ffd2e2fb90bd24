#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "randomize/appearance/randomize_options.h"
#include "randomize/appearance/variety/shape_change.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

class PaintedModel;

/// A model that looks like another specimen of its kind.
struct VariedModel {
  world::Model model;
  std::optional<ShapeChange> shape;  ///< how its shape differs; nothing if it does not
};

/// Makes variants of a model: worn specimens of the same object, or other objects of the same
/// class. They depend on the model, the seed and each variant's number.
class ObjectVariety {
 public:
  /// @param variety  not kNone
  ObjectVariety(const world::Model& model, Variety variety, std::uint64_t seed);
  ~ObjectVariety();
  ObjectVariety(ObjectVariety&&) noexcept;

  /// @param number  0 for the unchanged model
  [[nodiscard]] VariedModel variant(int number) const;

 private:
  std::unique_ptr<const world::Model> model_;
  Variety variety_;
  std::uint64_t seed_;
  std::unique_ptr<PaintedModel> painted_;
};

}  // namespace synthetic_dataset::randomize
