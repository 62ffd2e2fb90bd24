#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/parameters.h"

/// What the readers of distributions of numbers and of texts share.
namespace synthetic_dataset::config {

/// A kind of distribution, and what may stand beside it in its group.
struct DistributionKind {
  std::string name;
  std::vector<std::string> beside = {};
};

/// An entry of the settings that says what something is drawn from.
class DistributionEntry {
 public:
  /// @param group  which holds it; outlives this
  DistributionEntry(Parameters& group, std::string name) : group_(group), name_(std::move(name)) {}

  /// Notes what is wrong.
  /// @return nothing, for a reader to end with
  std::nullopt_t refuse(const std::string& found, const std::string& should) const;

  /// The only kind that the entry's group is of.
  /// @return nothing where there are others or none, which is noted
  [[nodiscard]] std::optional<DistributionKind> kindOf(
      const Value::Map& given, const std::vector<DistributionKind>& kinds) const;

  /// The weights of so many choices; empty where none are given.
  /// @return nothing where they are wrong, which is noted
  [[nodiscard]] std::optional<std::vector<double>> weightsOf(const Value::Map& given,
                                                             std::size_t count) const;

 private:
  Parameters& group_;
  std::string name_;
};

/// "uniform, normal or choice".
[[nodiscard]] std::string namesOf(const std::vector<DistributionKind>& kinds);

/// As messages show a value: long lists would hide what they have to say.
[[nodiscard]] std::string shortText(const Value& value);

/// A number, or a list of them, as Parameters reads them: whole ones will do, and texts such as
/// 1e-05. Nothing for anything else.
[[nodiscard]] std::optional<double> numberIn(const Value& value);
[[nodiscard]] std::optional<std::vector<double>> numbersIn(const Value& value);

/// An entry of a group; nullptr where there is none, or it is nothing.
[[nodiscard]] const Value* valueIn(const Value::Map& given, const std::string& name);

}  // namespace synthetic_dataset::config
