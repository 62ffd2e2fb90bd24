#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "randomize/appearance/entry_draws.h"
#include "randomize/appearance/randomize_options.h"
#include "scene/object_options.h"

namespace synthetic_dataset::scene {

/// A form that an object may take in a scene.
struct ObjectVariant {
  std::optional<std::string> model;  ///< as ObjectOptions::model
  double scale = 1.0;                ///< factor of the model's size
  randomize::Variety variety = randomize::Variety::kNone;
  int number = 0;  ///< of the varieties of the model; 0: the model as it is
};

/// The models, sizes and variants of which an object has one in each scene, as `randomize/objects`
/// says. All are made before the first scene, so a size that is drawn from a range is replaced by
/// one of a few that are spread over that range, each of them as likely as the part of the range
/// that it represents.
class ObjectVariants {
 public:
  /// @throws Error naming a folder without models, or if there are more variants than can be made
  ObjectVariants(const ObjectOptions& object, const randomize::Randomization& randomization);

  /// All variants: at least one.
  [[nodiscard]] const std::vector<ObjectVariant>& all() const { return all_; }

  [[nodiscard]] bool hasSeveralModels() const { return models_.size() > 1; }

  /// How many are made of each model in each size.
  [[nodiscard]] int varietyCount() const {
    return config_.variety->variety == randomize::Variety::kNone ? 1 : config_.variety->variants;
  }

  /// Draws the active variant: an index in all().
  [[nodiscard]] std::size_t draw(randomize::EntryDraws& draws) const;

 private:
  /// A size, and the largest drawn number that it represents.
  struct Size {
    double factor;
    double up_to;
  };

  [[nodiscard]] static std::vector<Size> sizesOf(const base::Distribution& scale, int count);
  void findModels();
  [[nodiscard]] std::size_t drawModel(randomize::EntryDraws& draws) const;
  [[nodiscard]] std::size_t drawSize(randomize::EntryDraws& draws) const;
  [[nodiscard]] std::size_t drawNumber(randomize::EntryDraws& draws) const;

  std::string entry_;                                          ///< "objects/NAME"
  randomize::ObjectRandomization config_;                      ///< its variety is always set
  std::map<std::string, std::vector<std::string>> models_of_;  ///< by the drawn text: that model,
                                                               ///< or the models in that folder
  std::vector<std::string> models_;  ///< of all of these, each once; empty: only its own
  std::vector<Size> sizes_;          ///< ascending; empty: none is drawn
  std::vector<ObjectVariant> all_;   ///< ordered by model, then size, then variant
};

}  // namespace synthetic_dataset::scene
