#include "scene/object_variants.h"

#include <algorithm>

#include "base/diagnostics.h"
#include "base/random/random_source.h"
#include "synthetic_dataset/errors.h"
#include "world/files/model_folders.h"

namespace synthetic_dataset::scene {
/// The values of a choice; otherwise the medians of equally likely parts of the distribution.
std::vector<ObjectVariants::Size> ObjectVariants::sizesOf(const base::Distribution& scale,
                                                          int count) {
  std::vector<Size> sizes;
  for (const base::Distribution::Numbers& value : scale.values()) {
    sizes.push_back({value.front(), value.front()});
  }
  if (sizes.empty()) {
    // A fixed seed, so that datasets of several runs have the same sizes.
    base::RandomSource source(0);
    constexpr std::size_t kDrawsOfEach = 1001;  // odd: there is a middle one
    std::vector<double> drawn(kDrawsOfEach * static_cast<std::size_t>(count));
    std::generate(drawn.begin(), drawn.end(), [&] { return scale.drawNumber(source); });
    std::sort(drawn.begin(), drawn.end());
    for (std::size_t first = 0; first < drawn.size(); first += kDrawsOfEach) {
      sizes.push_back({drawn[first + kDrawsOfEach / 2], drawn[first + kDrawsOfEach - 1]});
    }
  }
  std::sort(sizes.begin(), sizes.end(),
            [](const Size& a, const Size& b) { return a.factor < b.factor; });
  std::vector<Size> different;
  for (const Size& size : sizes) {
    if (!different.empty() && different.back().factor == size.factor) {
      different.back().up_to = size.up_to;
    } else {
      different.push_back(size);
    }
  }
  return different;
}

ObjectVariants::ObjectVariants(const ObjectOptions& object,
                               const randomize::Randomization& randomization)
    : entry_("objects/" + object.name) {
  // Objects that do not take part have no variants; distractors have models and sizes of their own.
  if (object.takes_part && !object.is_distractor && !object.stands) {
    config_ = randomization.ofObject(object.name);
  }
  if (!config_.variety) config_.variety.emplace();
  if (config_.model) findModels();
  if (config_.scale) sizes_ = sizesOf(*config_.scale, config_.sizes);
  std::vector<std::optional<std::string>> models(models_.begin(), models_.end());
  if (models.empty()) models.push_back(object.model);
  std::vector<double> factors;
  for (const Size& size : sizes_) factors.push_back(size.factor);
  if (factors.empty()) factors.push_back(1.0);
  for (const auto& model : models) {
    for (const double factor : factors) {
      for (int number = 0; number < varietyCount(); ++number) {
        all_.push_back({model, factor, config_.variety->variety, number});
      }
    }
  }
  constexpr std::size_t kMost = 1000;
  if (all_.size() <= kMost) return;
  throw Error("randomize/" + entry_ + ": found " + std::to_string(models.size()) + " models in " +
              std::to_string(factors.size()) + " sizes" +
              (varietyCount() == 1 ? "" : " and " + std::to_string(varietyCount()) + " variants") +
              "; there should be 1000 of them at most (fewer sizes, variants or models), as all "
              "are made before the first scene");
}

void ObjectVariants::findModels() {
  for (const std::string& text : config_.model->texts) {
    models_of_[text] =
        base::namingPlace("randomize/" + entry_ + "/model", [&] { return world::modelsAt(text); });
    for (const std::string& model : models_of_[text]) {
      const bool is_new = std::find(models_.begin(), models_.end(), model) == models_.end();
      if (is_new) models_.push_back(model);
    }
  }
}

std::size_t ObjectVariants::draw(randomize::EntryDraws& draws) const {
  const std::size_t model = drawModel(draws);
  const std::size_t size = model * std::max<std::size_t>(sizes_.size(), 1) + drawSize(draws);
  return size * static_cast<std::size_t>(varietyCount()) + drawNumber(draws);
}

std::size_t ObjectVariants::drawModel(randomize::EntryDraws& draws) const {
  if (models_.empty()) return 0;
  base::RandomSource source = draws.source(entry_ + "/model");
  const std::vector<std::string>& models = models_of_.at(config_.model->draw(source));
  const std::string& drawn =
      models.size() == 1 ? models.front() : models[source.index(models.size())];
  draws.note(entry_ + "/model", drawn);
  return static_cast<std::size_t>(std::find(models_.begin(), models_.end(), drawn) -
                                  models_.begin());
}

/// Draws a size: the one that represents the drawn number. It is also the one that is noted.
std::size_t ObjectVariants::drawSize(randomize::EntryDraws& draws) const {
  if (sizes_.empty()) return 0;
  base::RandomSource source = draws.source(entry_ + "/scale");
  const double drawn = config_.scale->drawNumber(source);
  auto size = std::find_if(sizes_.begin(), sizes_.end(),
                           [&](const Size& each) { return drawn <= each.up_to; });
  if (size == sizes_.end()) --size;
  draws.note(entry_ + "/scale", size->factor);
  return static_cast<std::size_t>(size - sizes_.begin());
}

/// Draws one of the variants of the model.
std::size_t ObjectVariants::drawNumber(randomize::EntryDraws& draws) const {
  if (config_.variety->variety == randomize::Variety::kNone) return 0;
  const std::size_t number =
      draws.source(entry_ + "/variant").index(static_cast<std::size_t>(varietyCount()));
  draws.note(entry_ + "/variant", static_cast<double>(number));
  return number;
}

}  // namespace synthetic_dataset::scene
