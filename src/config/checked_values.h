#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/parameters.h"

/// Helpers that several parameter readers share.
namespace synthetic_dataset::config {

/// A number that has to be above a limit; otherwise an error is noted and the fallback returned.
[[nodiscard]] double numberAbove(Parameters& group, const std::string& name, double fallback,
                                 double limit);

/// The number of scenes to make, 1 to 100000000, as their files' names have eight digits. nullopt
/// if it is missing or wrong; the latter is noted.
[[nodiscard]] std::optional<std::int64_t> maybeSceneCount(Parameters& group,
                                                          const std::string& name);

/// A length of time in seconds, at most about 30 years, so that nanoseconds stay in range.
[[nodiscard]] std::optional<double> maybeSeconds(Parameters& group, const std::string& name);

/// Notes an error for each of these that is given, as it would unexpectedly have no effect: it "has
/// a meaning with `needed` alone", where `needed` is, for example, "mode: drop".
void refuseWithout(Parameters& group, const std::vector<std::string>& names,
                   const std::string& needed);

/// Whether the parameter is a list without entries.
[[nodiscard]] bool isEmptyList(Parameters& group, const std::string& name);

/// A list of names or whole numbers, or a single one, as texts; an empty list is noted.
/// @param of  what they name, for the message
[[nodiscard]] std::vector<std::string> readNames(Parameters& group, const std::string& name,
                                                 const std::string& of);

/// The absolute path, with a leading `~/` replaced by the user's home; an empty one stays empty.
[[nodiscard]] std::string absolutePath(const std::string& path);

/// An absolute path that ends in `/`.
[[nodiscard]] std::string folderPath(const std::string& path);

/// A folder of pictures made absolute; `procedural` and `natural` as they are.
[[nodiscard]] std::string picturesFrom(const std::string& text);

/// A path made absolute; a URI as it is.
[[nodiscard]] std::string pathOrUri(const std::string& text);

/// Why a text cannot be a name in the label files of all formats, as in "found a text that <this>";
/// nullopt if it can. Such a name is one line of UTF-8 without control characters.
[[nodiscard]] std::optional<std::string> nameProblem(const std::string& text);

/// One of several words; nullopt if it is left out or wrong; the latter is noted.
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

/// The same, but the first word if it is left out or wrong.
template <class Choice>
Choice choice(Parameters& group, const std::string& name,
              const std::vector<std::pair<std::string, Choice>>& choices) {
  group.declare(name, "default", choices.front().first);
  return maybeChoice(group, name, choices).value_or(choices.front().second);
}

/// The same, but a default is also listed among the defaults taken.
template <class Choice>
Choice listedChoice(Parameters& group, const std::string& name,
                    const std::vector<std::pair<std::string, Choice>>& choices) {
  if (!group.has(name)) (void)group.optional(name, choices.front().first);
  return choice(group, name, choices);
}

}  // namespace synthetic_dataset::config
