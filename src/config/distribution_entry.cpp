#include "config/distribution_entry.h"

#include <algorithm>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

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

/// What the weights of so many choices should be, where they are not.
std::optional<std::string> weightProblem(const std::optional<std::vector<double>>& weights,
                                         std::size_t count) {
  if (!weights || weights->size() != count) {
    return "a list of " + std::to_string(count) + (count == 1 ? " number" : " numbers") +
           ", one for each choice";
  }
  if (*std::min_element(weights->begin(), weights->end()) < 0.0) return "numbers not below 0";
  if (*std::max_element(weights->begin(), weights->end()) <= 0.0) {
    return "numbers with one above 0";
  }
  return std::nullopt;
}

}  // namespace

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

std::string namesOf(const std::vector<DistributionKind>& kinds) {
  return listed(nameList(kinds), "or");
}

std::string shortText(const Value& value) {
  constexpr std::size_t kLongest = 80;
  const std::string text = value.text();
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

std::optional<double> numberIn(const Value& value) {
  return Parameters(Value::Map{{"number", value}}).maybe<double>("number");
}

std::optional<std::vector<double>> numbersIn(const Value& value) {
  return Parameters(Value::Map{{"numbers", value}}).maybe<std::vector<double>>("numbers");
}

const Value* valueIn(const Value::Map& given, const std::string& name) {
  const auto entry = given.find(name);
  return entry == given.end() || entry->second.isNull() ? nullptr : &entry->second;
}

}  // namespace synthetic_dataset::config
