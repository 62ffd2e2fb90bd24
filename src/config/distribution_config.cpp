#include "config/distribution_config.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

using base::Distribution;
using Numbers = Distribution::Numbers;

/// A kind of distribution, and the entries that may accompany it in its group.
struct DistributionKind {
  std::string name;
  std::vector<std::string> beside = {};
};

using Names = std::vector<std::string>;

/// "a, b or c".
std::string listed(const Names& names, const std::string& last_word) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " " + last_word + " " : ", ";
    text += names[i];
  }
  return text;
}

Names nameList(const std::vector<DistributionKind>& kinds) {
  Names names;
  for (const DistributionKind& kind : kinds) names.push_back(kind.name);
  return names;
}

bool isAmong(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What the weights of `count` choices should be; nullopt if they are right.
std::optional<std::string> weightProblem(const std::optional<std::vector<double>>& weights,
                                         std::size_t count) {
  if (!weights || weights->size() != count) {
    return "a list of " + std::to_string(count) + (count == 1 ? " number" : " numbers") +
           ", one for each choice";
  }
  if (*std::min_element(weights->begin(), weights->end()) < 0.0) return "numbers not below 0";
  if (*std::max_element(weights->begin(), weights->end()) <= 0.0) {
    return "numbers, at least one above 0";
  }
  return std::nullopt;
}

/// "uniform, normal or choice".
std::string namesOf(const std::vector<DistributionKind>& kinds) {
  return listed(nameList(kinds), "or");
}

/// A value as shown in messages: shortened, as a long list would hide the rest of the message.
std::string shortText(const Value& value) {
  constexpr std::size_t kLongest = 80;
  const std::string text = value.text();
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

/// A number, or a list of numbers, as read by Parameters: also integers, and texts such as 1e-05.
/// nullopt for anything else.
std::optional<double> numberIn(const Value& value) {
  return Parameters(Value::Map{{"number", value}}).maybe<double>("number");
}

std::optional<std::vector<double>> numbersIn(const Value& value) {
  return Parameters(Value::Map{{"numbers", value}}).maybe<std::vector<double>>("numbers");
}

/// An entry of a group; nullptr if it is missing or null.
const Value* valueIn(const Value::Map& given, const std::string& name) {
  const auto entry = given.find(name);
  return entry == given.end() || entry->second.isNull() ? nullptr : &entry->second;
}

/// An entry of the settings that gives a distribution.
class DistributionEntry {
 public:
  /// @param group  that contains the entry; must outlive this object
  DistributionEntry(Parameters& group, std::string name) : group_(group), name_(std::move(name)) {}

  /// Notes what is wrong.
  /// @return nullopt, for a reader to return
  std::nullopt_t refuse(const std::string& found, const std::string& should) const;

  /// The only kind of distribution in the entry's group.
  /// @return nullopt if there are several, none, or other entries, which is noted
  [[nodiscard]] std::optional<DistributionKind> kindOf(
      const Value::Map& given, const std::vector<DistributionKind>& kinds) const;

  /// The weights of `count` choices; empty if none are given.
  /// @return nullopt if they are wrong, which is noted
  [[nodiscard]] std::optional<std::vector<double>> weightsOf(const Value::Map& given,
                                                             std::size_t count) const;

 private:
  Parameters& group_;
  std::string name_;
};

std::nullopt_t DistributionEntry::refuse(const std::string& found,
                                         const std::string& should) const {
  group_.addError(name_, "found " + found + "; it should be " + should);
  return std::nullopt;
}

std::optional<DistributionKind> DistributionEntry::kindOf(
    const Value::Map& given, const std::vector<DistributionKind>& kinds) const {
  std::vector<DistributionKind> found;
  Names others;
  for (const auto& [name, value] : given) others.push_back(name);
  for (const DistributionKind& kind : kinds) {
    const auto place = std::find(others.begin(), others.end(), kind.name);
    if (place == others.end()) continue;
    found.push_back(kind);
    others.erase(place);
  }
  const std::string should = "a group with " + namesOf(kinds);
  if (found.size() > 1) return refuse(listed(nameList(found), "and") + " at once", should);
  if (found.empty() && others.empty()) return refuse("an empty group", should);
  if (found.empty()) {
    return refuse("'" + others.front() + "'", should + didYouMean(others.front(), nameList(kinds)));
  }
  const auto& [name, beside] = found.front();
  for (const std::string& other : others) {
    if (isAmong(beside, other)) continue;
    const std::string most =
        beside.empty() ? " alone" : " with " + listed(beside, "and") + " at most";
    return refuse("'" + other + "' beside " + name, name + most + didYouMean(other, beside));
  }
  return found.front();
}

std::optional<std::vector<double>> DistributionEntry::weightsOf(const Value::Map& given,
                                                                std::size_t count) const {
  const Value* value = valueIn(given, "weights");
  if (value == nullptr) return std::vector<double>();
  auto weights = numbersIn(*value);
  if (const auto should = weightProblem(weights, count)) {
    return refuse("weights: " + shortText(*value), *should);
  }
  return weights;
}

constexpr double kLeastAboveZero = std::numeric_limits<double>::denorm_min();

const std::vector<DistributionKind>& kindsOfNumbers() {
  static const std::vector<DistributionKind> kKinds = {
      {"uniform"}, {"log_uniform"}, {"normal", {"min", "max"}}, {"choice", {"weights"}}};
  return kKinds;
}

/// Whether low <= high in each component.
bool isOrdered(const Numbers& low, const Numbers& high) {
  for (std::size_t i = 0; i < std::max(low.size(), high.size()); ++i) {
    if (base::componentOf(low, i) > base::componentOf(high, i)) return false;
  }
  return true;
}

/// Reads a distribution that is given.
class DistributionReader {
 public:
  DistributionReader(DistributionEntry entry, const DistributionRange& range)
      : entry_(std::move(entry)), range_(range) {}

  [[nodiscard]] std::optional<Distribution> constant(const Value& given) const {
    const auto numbers = componentsIn(given);
    if (!numbers) {
      return entry_.refuse(shortText(given) + " (" + given.kind() + ")",
                           component() + ", or a group with " + namesOf(kindsOfNumbers()));
    }
    if (!isInRange(*numbers)) return entry_.refuse(shortText(given), rangeText());
    return Distribution::constant(vectorOf(*numbers));
  }

  [[nodiscard]] std::optional<Distribution> fromGroup(const Value::Map& given) const {
    const auto kind = entry_.kindOf(given, kindsOfNumbers());
    if (!kind) return std::nullopt;
    if (kind->name == "normal") return normal(given);
    if (kind->name == "choice") return choice(given);
    return between(kind->name, given.at(kind->name));
  }

 private:
  using Pair = std::array<Numbers, 2>;

  /// Reads `uniform` or `log_uniform`.
  [[nodiscard]] std::optional<Distribution> between(const std::string& kind,
                                                    const Value& given) const {
    const std::string found = kind + ": " + shortText(given);
    auto ends = pairIn(given);
    if (!ends) return entry_.refuse(found, "[low, high], each " + component());
    auto& [low, high] = *ends;
    if (!isOrdered(low, high)) return entry_.refuse(found, "[low, high], low not above high");
    const bool is_log = kind == "log_uniform";
    if (is_log && !isOrdered({kLeastAboveZero}, low)) {
      return entry_.refuse(found, "[low, high], both above 0");
    }
    if (!isInRange(low) || !isInRange(high)) return entry_.refuse(found, rangeText());
    const auto make = is_log ? Distribution::logUniform : Distribution::uniform;
    return make(parameter(low), parameter(high), range_.dimension);
  }

  [[nodiscard]] std::optional<Distribution> normal(const Value::Map& given) const {
    const std::string found = "normal: " + shortText(given.at("normal"));
    auto numbers = pairIn(given.at("normal"));
    if (!numbers) return entry_.refuse(found, "[mean, stddev], each " + component());
    auto& [mean, stddev] = *numbers;
    if (!isOrdered({0.0}, stddev)) {
      return entry_.refuse(found, "[mean, stddev], stddev not below 0");
    }
    if (!isInRange(mean)) return entry_.refuse(found, rangeText());
    if (range_.is_angle && !isOrdered(stddev, {kHalfTurn})) {
      return entry_.refuse(
          found, "[mean, stddev], stddev at most half a turn of 3.142" + std::string(kAngleUnit));
    }
    auto low = bound(given, "min", range_.low);
    auto high = bound(given, "max", range_.high);
    if (!low || !high) return std::nullopt;
    // With a mean out of bounds, a thousand draws could fail, and the result be the bound itself.
    if (!isOrdered(*low, mean) || !isOrdered(mean, *high)) {
      return entry_.refuse(found + boundsText(given),
                           "[mean, stddev], mean not below min and not above max");
    }
    return Distribution::normalBetween(parameter(mean), parameter(stddev), parameter(*low),
                                       parameter(*high), range_.dimension);
  }

  /// A bound of a normal distribution; by default the end of the range.
  [[nodiscard]] std::optional<Numbers> bound(const Value::Map& given, const std::string& name,
                                             double end_of_range) const {
    const Value* value = valueIn(given, name);
    if (value == nullptr) return Numbers{end_of_range};
    const std::string found = name + ": " + shortText(*value);
    auto numbers = componentsIn(*value);
    if (!numbers) return entry_.refuse(found, component());
    if (!isInRange(*numbers)) return entry_.refuse(found, rangeText());
    return numbers;
  }

  [[nodiscard]] std::optional<Distribution> choice(const Value::Map& given) const {
    const Value& value = given.at("choice");
    const auto* list = value.as<Value::List>();
    if (list == nullptr || list->empty()) {
      return entry_.refuse("choice: " + shortText(value), "a list, each entry " + component());
    }
    std::vector<Numbers> values;
    for (const Value& each : *list) {
      const auto numbers = componentsIn(each);
      const std::string found = shortText(each) + " in choice";
      if (!numbers) return entry_.refuse(found, component());
      if (!isInRange(*numbers)) return entry_.refuse(found, rangeText());
      values.push_back(vectorOf(*numbers));
    }
    auto weights = entry_.weightsOf(given, values.size());
    if (!weights) return std::nullopt;
    return Distribution::choice(std::move(values), std::move(*weights));
  }

  /// One number, or one for each component.
  [[nodiscard]] std::optional<Numbers> componentsIn(const Value& value) const {
    if (!value.is<Value::List>()) {
      const auto number = numberIn(value);
      return number ? std::optional(Numbers{*number}) : std::nullopt;
    }
    auto numbers = numbersIn(value);
    const bool is_vector = range_.dimension > 1 && numbers && numbers->size() == range_.dimension;
    return is_vector ? numbers : std::nullopt;
  }

  [[nodiscard]] std::optional<Pair> pairIn(const Value& value) const {
    const auto* list = value.as<Value::List>();
    if (list == nullptr || list->size() != 2) return std::nullopt;
    auto first = componentsIn(list->front());
    auto second = componentsIn(list->back());
    if (!first || !second) return std::nullopt;
    return Pair{std::move(*first), std::move(*second)};
  }

  [[nodiscard]] Numbers vectorOf(const Numbers& numbers) const {
    return numbers.size() == 1 ? Numbers(range_.dimension, numbers.front()) : numbers;
  }

  [[nodiscard]] Numbers parameter(const Numbers& numbers) const {
    return range_.draws_each ? vectorOf(numbers) : numbers;
  }

  [[nodiscard]] bool isInRange(const Numbers& numbers) const {
    return isOrdered({range_.low}, numbers) && isOrdered(numbers, {range_.high});
  }

  [[nodiscard]] std::string component() const {
    if (range_.dimension == 1) return "a number";
    return "a number or a list of " + std::to_string(range_.dimension);
  }

  [[nodiscard]] std::string rangeText() const {
    const std::string low = Value(range_.low).text();
    const std::string high = Value(range_.high).text();
    const std::string unit = range_.is_angle ? kAngleUnit : "";
    if (std::isinf(range_.high)) return low + " or more" + unit;
    return (std::isinf(range_.low) ? high + " or less" : low + " to " + high) + unit;
  }

  [[nodiscard]] static std::string boundsText(const Value::Map& given) {
    std::string text;
    for (const char* name : {"min", "max"}) {
      const Value* value = valueIn(given, name);
      if (value != nullptr) text += std::string(", ") + name + ": " + shortText(*value);
    }
    return text;
  }

  DistributionEntry entry_;
  DistributionRange range_;
};

std::vector<std::string> textsIn(const Value& value) {
  std::vector<std::string> texts;
  const auto* list = value.as<Value::List>();
  if (list == nullptr) return texts;
  for (const Value& each : *list) {
    const auto* text = each.as<std::string>();
    if (text == nullptr) return {};
    texts.push_back(*text);
  }
  return texts;
}

std::optional<base::TextChoice> choiceOfTexts(const DistributionEntry& entry,
                                              const Value::Map& given) {
  const auto kind = entry.kindOf(given, {{"choice", {"weights"}}});
  if (!kind) return std::nullopt;
  const Value& value = given.at(kind->name);
  auto texts = textsIn(value);
  if (texts.empty()) return entry.refuse("choice: " + shortText(value), "a list of texts");
  auto weights = entry.weightsOf(given, texts.size());
  if (!weights) return std::nullopt;
  return base::TextChoice{std::move(texts), std::move(*weights)};
}

}  // namespace

std::optional<Distribution> maybeDistribution(Parameters group, const std::string& name,
                                              const DistributionRange& range) {
  const auto given = group.maybe<Value>(name);
  if (std::isfinite(range.low + range.high)) {
    group.declare(name, "range", Value::List{range.low, range.high});
  }
  if (!given) return std::nullopt;
  const DistributionReader reader({group, name}, range);
  const auto* map = given->as<Value::Map>();
  return map == nullptr ? reader.constant(*given) : reader.fromGroup(*map);
}

std::optional<base::TextChoice> maybeChoice(Parameters group, const std::string& name) {
  const auto given = group.maybe<Value>(name);
  if (!given) return std::nullopt;
  if (const auto* text = given->as<std::string>()) return base::TextChoice{{*text}, {}};
  const DistributionEntry entry(group, name);
  if (const auto* map = given->as<Value::Map>()) return choiceOfTexts(entry, *map);
  return entry.refuse(shortText(*given) + " (" + given->kind() + ")",
                      "a text, or a group with choice");
}

}  // namespace synthetic_dataset::config
