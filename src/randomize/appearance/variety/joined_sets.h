#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace synthetic_dataset::randomize {

/// Disjoint sets that are merged two at a time (Galler and Fischer 1964).
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t find(std::size_t each) {
    while (parent_[each] != each) each = parent_[each] = parent_[parent_[each]];
    return each;
  }

  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace synthetic_dataset::randomize
