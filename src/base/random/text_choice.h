#pragma once

#include <string>
#include <vector>

#include "base/random/random_source.h"
#include "base/random/weighted_index.h"

namespace synthetic_dataset::base {

/// Texts, such as the names of models, of which one is drawn.
struct TextChoice {
  std::vector<std::string> texts;  ///< at least one
  std::vector<double> weights;     ///< as weightedIndex has them; empty: all alike

  [[nodiscard]] const std::string& draw(RandomSource& source) const {
    return texts[weightedIndex(source, texts.size(), weights)];
  }
};

}  // namespace synthetic_dataset::base
