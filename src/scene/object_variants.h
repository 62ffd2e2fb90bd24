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

/// What an object may look like in a scene.
struct ObjectVariant {
  std::optional<std::string> model;  ///< as ObjectConfig::model
  double scale = 1.0;                ///< times the model's size
  randomize::Variety variety = randomize::Variety::kNone;
  int number = 0;  ///< of those that are made of the model; 0: the model as it is
};

/// The models, sizes and variants of which an object has one in each scene, as `randomize/objects`
/// says.
/// They are made before the first scene, so of a size that is drawn from a range there are some few
/// all over that range, each as likely as what it stands for.
class ObjectVariants {
 public:
  /// @throws Error naming a folder without models, or more variants than can be made
  ObjectVariants(const ObjectOptions& object, const randomize::Randomization& randomization);

  /// All of them: at least one.
  [[nodiscard]] const std::vector<ObjectVariant>& all() const { return all_; }

  [[nodiscard]] bool hasSeveralModels() const { return models_.size() > 1; }

  /// How many are made of each model in each size.
  [[nodiscard]] int varietyCount() const {
    return config_.variety->variety == randomize::Variety::kNone ? 1 : config_.variety->variants;
  }

  /// Which one is active: an index in all of them.
  [[nodiscard]] std::size_t draw(randomize::EntryDraws& draws) const;

 private:
  /// A size, and the greatest number for which it stands.
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
  randomize::ObjectRandomization config_;                      ///< its variety is there
  std::map<std::string, std::vector<std::string>> models_of_;  ///< by what is drawn: it, or the
                                                               ///< models in the folder that it is
  std::vector<std::string> models_;  ///< of all of these, each once; empty: its own alone
  std::vector<Size> sizes_;          ///< ascending; empty: none is drawn
  std::vector<ObjectVariant> all_;   ///< model by model, of each its sizes, of each its variants
};

}  // namespace synthetic_dataset::scene
