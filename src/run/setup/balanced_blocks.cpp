#include "run/setup/balanced_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

namespace synthetic_dataset::run {
namespace {

/// A recording is cut into this many pieces, or into as many as it has times, if fewer.
constexpr std::size_t kMostPieces = 20;

using Pieces = std::vector<std::size_t>;

ClassCounts& operator+=(ClassCounts& sum, const ClassCounts& more) {
  sum.resize(std::max(sum.size(), more.size()), 0);
  for (std::size_t i = 0; i < more.size(); ++i) sum[i] += more[i];
  return sum;
}

class Divider {
 public:
  Divider(const config::SplitConfig& config, const std::vector<ClassCounts>& labels)
      : config_(config), time_count_(labels.size()) {
    const std::size_t count = std::min(kMostPieces, time_count_);
    for (std::size_t piece = 0; piece < count; ++piece) {
      ClassCounts& sum = labels_.emplace_back();
      for (std::size_t i = beginOf(piece, count); i < beginOf(piece + 1, count); ++i) {
        sum += labels[i];
      }
      total_ += sum;
    }
    owner_.resize(count);
  }

  std::vector<std::uint8_t> divide() {
    std::vector<std::size_t> order(config_.shares.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return config_.shares[a].second < config_.shares[b].second;
    });
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      const std::size_t others = order.size() - 1 - i;  // each of these needs a piece, too
      choose(order[i], others);
    }
    std::vector<std::uint8_t> splits;
    for (std::size_t piece = 0; piece < owner_.size(); ++piece) {
      splits.resize(beginOf(piece + 1, owner_.size()),
                    static_cast<std::uint8_t>(owner_[piece].value_or(order.back())));
    }
    return splits;
  }

 private:
  [[nodiscard]] std::size_t beginOf(std::size_t piece, std::size_t count) const {
    return piece * time_count_ / count;
  }

  [[nodiscard]] Pieces free() const {
    Pieces pieces;
    for (std::size_t i = 0; i < owner_.size(); ++i) {
      if (!owner_[i]) pieces.push_back(i);
    }
    return pieces;
  }

  /// How far a choice is from the ideal for a split: classes that it lacks, or of which it leaves
  /// none for the other splits, count most, and then deviations from its share.
  [[nodiscard]] double cost(const Pieces& chosen, double share) const {
    ClassCounts own(total_.size(), 0);
    ClassCounts rest(total_.size(), 0);
    for (const std::size_t piece : free()) {
      const bool is_chosen = std::find(chosen.begin(), chosen.end(), piece) != chosen.end();
      (is_chosen ? own : rest) += labels_[piece];
    }
    constexpr double kLacks = 10.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < total_.size(); ++i) {
      if (total_[i] == 0) continue;
      if (own[i] == 0) sum += kLacks;
      if (rest[i] == 0) sum += kLacks;
      sum += std::abs(static_cast<double>(own[i]) / static_cast<double>(total_[i]) - share);
    }
    return sum;
  }

  /// Assigns the best contiguous pieces or, if scattered pieces are clearly better, the best ones
  /// one by one.
  void choose(std::size_t split, std::size_t others) {
    const double share = config_.shares[split].second;
    const Pieces pieces = free();
    if (pieces.size() <= others) return;
    const auto wanted =
        static_cast<std::size_t>(std::llround(share * static_cast<double>(owner_.size())));
    const std::size_t count = std::clamp<std::size_t>(wanted, 1, pieces.size() - others);
    Pieces best = bestStretch(pieces, count, share);
    const Pieces scattered = bestOneByOne(pieces, count, share);
    constexpr double kScattered = 1.0;  // more blocks have more neighbours in other splits
    const double of_stretch =
        best.empty() ? kScattered + cost(scattered, share) : cost(best, share);
    if (best.empty() || cost(scattered, share) + kScattered < of_stretch) best = scattered;
    for (const std::size_t piece : best) owner_[piece] = split;
  }

  [[nodiscard]] Pieces bestStretch(const Pieces& pieces, std::size_t count, double share) const {
    Pieces best;
    // Takes the latest of equals, like `blocks`, which has train first.
    for (std::size_t first = 0; first + count <= pieces.size(); ++first) {
      if (pieces[first + count - 1] - pieces[first] != count - 1) continue;  // not contiguous
      const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(first);
      const Pieces stretch(begin, begin + static_cast<std::ptrdiff_t>(count));
      if (best.empty() || cost(stretch, share) <= cost(best, share)) best = stretch;
    }
    return best;
  }

  [[nodiscard]] Pieces bestOneByOne(const Pieces& pieces, std::size_t count, double share) const {
    Pieces best;
    while (best.size() < count) {
      std::optional<std::size_t> next;
      double least = 0.0;
      for (const std::size_t piece : pieces) {
        if (std::find(best.begin(), best.end(), piece) != best.end()) continue;
        Pieces with_it = best;
        with_it.push_back(piece);
        const double its = cost(with_it, share);
        if (next && its > least) continue;
        next = piece;
        least = its;
      }
      best.push_back(*next);
    }
    return best;
  }

  const config::SplitConfig& config_;
  std::size_t time_count_;
  std::vector<ClassCounts> labels_;  ///< of each piece
  ClassCounts total_;
  std::vector<std::optional<std::size_t>> owner_;  ///< of each piece: a share; none: the largest
};

}  // namespace

std::vector<std::uint8_t> balancedBlocks(const config::SplitConfig& config,
                                         const std::vector<ClassCounts>& labels) {
  return labels.empty() || config.shares.empty() ? std::vector<std::uint8_t>()
                                                 : Divider(config, labels).divide();
}

}  // namespace synthetic_dataset::run
