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

/// A folder of pictures made absolute; `procedural` and `natural` as they are.
[[nodiscard]] std::string picturesFrom(const std::string& text);

/// A path made absolute; a URI as it is.
[[nodiscard]] std::string pathOrUri(const std::string& text);

/// What keeps a text from being a name that stands in label files of all formats: "found a text
/// that <this>", or nothing. Such names are of one line of UTF-8, and may hold anything else.
[[nodiscard]] std::optional<std::string> nameProblem(const std::string& text);

/// One of some words; nothing where it is left out or wrong, which is noted.
template <class Choice>
std::optional<Choice> maybeChoice(Parameters& group, const std::string& name,
                                  const std::vector<std::pair<std::string, Choice>>& choices) {
  std::vector<std::string> words;
  for (const auto& each : choices) words.push_back(each.first);
  const auto word = group.maybeChoice(name, words);
  for (const auto& [each, choice] : choices) {
    if (word == each) return choice;
  }
  return std::nullopt;
}

/// The same; the first where it is left out or wrong.
template <class Choice>
Choice choice(Parameters& group, const std::string& name,
              const std::vector<std::pair<std::string, Choice>>& choices) {
  group.declare(name, "default", choices.front().first);
  return maybeChoice(group, name, choices).value_or(choices.front().second);
}

/// The same, and the default is listed among those that were taken.
template <class Choice>
Choice listedChoice(Parameters& group, const std::string& name,
                    const std::vector<std::pair<std::string, Choice>>& choices) {
  if (!group.has(name)) (void)group.optional(name, choices.front().first);
  return choice(group, name, choices);
}

}  // namespace synthetic_dataset::config
