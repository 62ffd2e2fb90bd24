#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {

enum class Severity {
  kError,    ///< there is no run with it
  kWarning,  ///< something that the user should know; the manifest lists it, too
  kNote,     ///< something that the user may like to know
};

/// One thing that was found in the user's settings and files.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string where;  ///< the setting, or the file and line; empty: nowhere, or `what` names it
  std::string what;
  std::int64_t count = 1;  ///< how often it was found

  /// "<where>: <what>"
  [[nodiscard]] std::string message() const;
};

/// Something that a run has to say.
struct Warning {
  std::string kind;         ///< what is counted together
  std::string detail = "";  ///< of this one
  std::int64_t count = 1;
};

/// Collects what is found by steps that do not depend on each other, so that the user sees all of
/// it at once. Each thing is listed once, in the order in which they were found.
class Diagnostics {
 public:
  void error(std::string where, std::string what) {
    add({Severity::kError, std::move(where), std::move(what)});
  }
  void warning(std::string where, std::string what, std::int64_t count = 1) {
    add({Severity::kWarning, std::move(where), std::move(what), count});
  }
  void note(std::string where, std::string what) {
    add({Severity::kNote, std::move(where), std::move(what)});
  }

  /// A thing that is listed already is counted again.
  void add(Diagnostic found);

  /// Messages that name their places themselves.
  void add(Severity severity, const std::vector<std::string>& messages);

  /// What was thrown: an ErrorList as its errors.
  void add(const Error& thrown);

  /// Appends what another one has collected.
  void merge(const Diagnostics& other);

  /// Runs a step and keeps the errors that it throws.
  /// @return what the step returns, or nothing when it failed; of a step that returns nothing,
  ///     whether it succeeded
  template <class Step>
  auto attempt(const Step& step) {
    if constexpr (std::is_void_v<decltype(step())>) {
      return attemptToReturn([&] {
               step();
               return true;
             })
          .has_value();
    } else {
      return attemptToReturn(step);
    }
  }

  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }

  /// The messages of one severity, as the user sees them.
  [[nodiscard]] std::vector<std::string> messages(Severity severity) const;

  [[nodiscard]] bool hasErrors() const;

  /// @throws ErrorList with all errors, if there are any
  void throwIfAny() const;

 private:
  template <class Step>
  auto attemptToReturn(const Step& step) -> std::optional<decltype(step())> {
    try {
      return step();
    } catch (const Error& thrown) {
      add(thrown);
    }
    return std::nullopt;
  }

  std::vector<Diagnostic> all_;
  std::map<std::pair<Severity, std::string>, std::size_t> places_;  ///< of their messages in it
};

/// Does some work for a setting or a file; errors that it throws name that then:
/// "<where>: <error>".
template <class Work>
auto namingPlace(const std::string& where, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const ErrorList& list) {
    std::vector<std::string> messages;
    for (const std::string& each : list.messages()) messages.push_back(where + ": " + each);
    throw ErrorList(std::move(messages));
  } catch (const Error& error) {
    throw Error(where + ": " + error.what());
  }
}

}  // namespace synthetic_dataset::base
