#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/parameters.h"

/// What the readers of several groups of parameters share.
namespace synthetic_dataset::config {

/// A number that has to lie above a limit; otherwise that is noted, and the fallback taken.
[[nodiscard]] double numberAbove(Parameters& group, const std::string& name, double fallback,
                                 double limit);

/// A probability, 0 to 1; nothing where it is not there or wrong, which is noted.
[[nodiscard]] std::optional<double> maybeProbability(Parameters& group, const std::string& name);

/// How many scenes there are to be, 1 to 100000000: their files' names have eight digits. Nothing
/// where it is not there or wrong, which is noted.
[[nodiscard]] std::optional<std::int64_t> maybeSceneCount(Parameters& group,
                                                          const std::string& name);

/// A length of time in seconds, at most about 30 years, so that nanoseconds stay in range.
[[nodiscard]] std::optional<double> maybeSeconds(Parameters& group, const std::string& name);

/// Notes each of these that is given, as it would do nothing, which nobody expects: it "has a
/// meaning with `needed` alone", such as "mode: drop".
void refuseWithout(Parameters& group, const std::vector<std::string>& names,
                   const std::string& needed);

/// Whether the parameter is a list without entries.
[[nodiscard]] bool isEmptyList(Parameters& group, const std::string& name);

/// A list of names or whole numbers, or one of them alone, as texts; an empty one is noted.
/// @param of  what they name, for the message
[[nodiscard]] std::vector<std::string> readNames(Parameters& group, const std::string& name,
                                                 const std::string& of);

/// Absolute, with a leading `~/` taken as the user's home; nothing stays nothing.
[[nodiscard]] std::string absolutePath(const std::string& path);

/// An absolute path that ends in `/`.
[[nodiscard]] std::string folderPath(const std::string& path);

/// A path made absolute; a URI as it is.
[[nodiscard]] std::string pathOrUri(const std::string& text);

/// What keeps a text from being a name that stands in label files of all formats: "found a text
/// that <this>", or nothing. Such names are of one line of UTF-8, and may hold anything else.
[[nodiscard]] std::optional<std::string> nameProblem(const std::string& text);

/// One of some words; left out, the first.
template <class Choice>
Choice choice(Parameters& group, const std::string& name,
              const std::vector<std::pair<std::string, Choice>>& choices) {
  auto found = group.maybe<Value>(name);
  if (!found) return choices.front().second;
  // YAML takes `off` for false.
  const std::string text = found->is<bool>() ? (*found->as<bool>() ? "on" : "off") : found->text();
  std::string words;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choices[i].first == text) return choices[i].second;
    words += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i].first;
  }
  const std::string is_bool = found->is<bool>() ? " (" + found->text() +
                                                      ", as YAML reads yes, no, on and off without "
                                                      "quotes)"
                                                : "";
  group.addError(name, "found '" + text + "'" + is_bool + "; it should be " + words);
  return choices.front().second;
}

}  // namespace synthetic_dataset::config
