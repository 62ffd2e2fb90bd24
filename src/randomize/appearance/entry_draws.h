#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "base/random/distribution.h"
#include "base/random/random_source.h"

namespace synthetic_dataset::randomize {

/// What an entry of `randomize` has drawn in a scene.
struct DrawnValue {
  std::string name;  ///< as the settings have it: "lights/sun/intensity"
  std::variant<std::vector<double>, std::string> value;
};

/// Draws the entries of one scene and keeps what was drawn. Each entry has random numbers of its
/// own, from the seed, the scene and its name: whether others are there or not changes nothing.
class EntryDraws {
 public:
  /// @param owner  a camera's name, for what each camera draws on its own
  EntryDraws(std::uint64_t seed, std::int64_t scene, std::string owner = "")
      : seed_(seed), scene_(scene), owner_(std::move(owner)) {}

  /// Nothing where there is no such entry.
  [[nodiscard]] std::optional<double> number(const std::string& name,
                                             const std::optional<base::Distribution>& distribution);
  [[nodiscard]] std::optional<Eigen::Vector3d> vector(
      const std::string& name, const std::optional<base::Distribution>& distribution);

  /// Whether something of this probability is so.
  [[nodiscard]] bool happens(const std::string& name, double probability);

  /// The entry's own random numbers, for what is drawn in other ways.
  [[nodiscard]] base::RandomSource source(const std::string& name) const;
  void note(const std::string& name, const std::string& value) { values_.push_back({name, value}); }
  void note(const std::string& name, double value) {
    values_.push_back({name, std::vector<double>{value}});
  }

  /// Puts a number in the place of what was drawn, where that does not count after all.
  void replace(const std::string& name, double value);

  /// All of them, in the order of drawing.
  [[nodiscard]] const std::vector<DrawnValue>& values() const { return values_; }

 private:
  std::uint64_t seed_;
  std::int64_t scene_;
  std::string owner_;
  std::vector<DrawnValue> values_;
};

}  // namespace synthetic_dataset::randomize
