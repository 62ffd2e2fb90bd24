#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/random/random_source.h"

namespace synthetic_dataset::base {

/// 0 <= number < count, each as likely as its weight says.
/// @param count  > 0
/// @param weights  as many as count, none below 0 and one above it; empty: all alike
[[nodiscard]] std::size_t weightedIndex(RandomSource& source, std::size_t count,
                                        const std::vector<double>& weights);

/// Texts, such as the names of models, of which one is drawn.
struct TextChoice {
  std::vector<std::string> texts;  ///< at least one
  std::vector<double> weights;     ///< as weightedIndex has them; empty: all alike

  [[nodiscard]] const std::string& draw(RandomSource& source) const {
    return texts[weightedIndex(source, texts.size(), weights)];
  }
};

}  // namespace synthetic_dataset::base
