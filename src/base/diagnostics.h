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
  kError,    ///< prevents the run
  kWarning,  ///< something that the user should know; also listed in the manifest
  kNote,     ///< something that the user may like to know
};

/// One finding in the user's settings and files.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string where;  ///< the setting, or the file and line; empty: none, or `what` names it
  std::string what;
  std::int64_t count = 1;  ///< how often it was found

  /// "<where>: <what>"
  [[nodiscard]] std::string message() const;
};

/// Something that a run warns of.
struct Warning {
  std::string kind;         ///< warnings of one kind are counted together
  std::string detail = "";  ///< of this warning
  std::int64_t count = 1;
};

/// Collects the findings of steps that do not depend on each other, so that the user sees all of
/// them at once. Each finding is listed once, in the order of discovery.
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

  /// Adds a finding; one that is already listed is counted again.
  void add(Diagnostic found);

  /// Adds messages that name their places themselves.
  void add(Severity severity, const std::vector<std::string>& messages);

  /// Adds a thrown error; for an ErrorList, each of its errors.
  void add(const Error& thrown);

  /// Appends what another object has collected.
  void merge(const Diagnostics& other);

  /// Runs a step and keeps the errors that it throws.
  /// @return what the step returns, or nullopt if it failed; for a step that returns void, whether
  ///     it succeeded
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
  std::map<std::pair<Severity, std::string>, std::size_t> places_;  ///< of messages in all_
};

/// Does some work for a setting or a file and names that in any error thrown: "<where>: <error>".
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
