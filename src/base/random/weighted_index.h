#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/random/random_source.h"

namespace synthetic_dataset::base {

/// 0 <= number < count, each with a probability in proportion to its weight.
/// @param count  > 0
/// @param weights  `count` of them, none below 0 and at least one above it; empty: all equal
[[nodiscard]] std::size_t weightedIndex(RandomSource& source, std::size_t count,
                                        const std::vector<double>& weights);

/// Texts, such as the names of models, of which one is drawn.
struct TextChoice {
  std::vector<std::string> texts;  ///< at least one
  std::vector<double> weights;     ///< as in weightedIndex; empty: all equal

  [[nodiscard]] const std::string& draw(RandomSource& source) const {
    return texts[weightedIndex(source, texts.size(), weights)];
  }
};

}  // namespace synthetic_dataset::base
