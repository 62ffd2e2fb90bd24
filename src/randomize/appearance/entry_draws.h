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

/// A value that an entry of `randomize` has drawn in a scene.
struct DrawnValue {
  std::string name;  ///< as in the settings: "lights/sun/intensity"
  std::variant<std::vector<double>, std::string> value;
};

/// Draws the entries of one scene and records what was drawn. Each entry has its own random
/// numbers, from the seed, the scene and its name, so that adding or removing others changes
/// nothing.
class EntryDraws {
 public:
  /// @param owner  a camera's name, for what is drawn for each camera separately
  EntryDraws(std::uint64_t seed, std::int64_t scene, std::string owner = "")
      : seed_(seed), scene_(scene), owner_(std::move(owner)) {}

  /// Nothing if there is no such entry.
  [[nodiscard]] std::optional<double> number(const std::string& name,
                                             const std::optional<base::Distribution>& distribution);
  [[nodiscard]] std::optional<Eigen::Vector3d> vector(
      const std::string& name, const std::optional<base::Distribution>& distribution);

  /// Draws whether something with this probability happens.
  [[nodiscard]] bool happens(const std::string& name, double probability);

  /// The entry's own random numbers, for other kinds of draws.
  [[nodiscard]] base::RandomSource source(const std::string& name) const;
  void note(const std::string& name, const std::string& value) { values_.push_back({name, value}); }
  void note(const std::string& name, double value) {
    values_.push_back({name, std::vector<double>{value}});
  }

  /// Replaces the number recorded for a draw that was overruled.
  void replace(const std::string& name, double value);

  /// All recorded values, in the order of drawing.
  [[nodiscard]] const std::vector<DrawnValue>& values() const { return values_; }

 private:
  std::uint64_t seed_;
  std::int64_t scene_;
  std::string owner_;
  std::vector<DrawnValue> values_;
};

}  // namespace synthetic_dataset::randomize
