#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset {
inline namespace v2 {

/// Reads one group of parameters and remembers what was wrong, so that all errors are reported at
/// once.
///
/// A wrong or missing parameter never throws here: the reader notes the error, with the parameter's
/// full name, what was found and what would be right, and answers a harmless value. Who owns the
/// root asks `errors()` at the end.
///
/// Methods that may note something are not const; copies and groups share their root's notes.
///
/// Every parameter that was asked for counts as known; `unknownNames()` gives the others, which are
/// most often misspelt.
///
/// `T` may be bool, int, std::int64_t, double (a whole number will do), std::string,
/// std::vector<double>, std::vector<std::string> (a single string counts as a list of one),
/// std::vector<Eigen::Vector3d> (a list of [x, y, z]) or Value (anything).
class Parameters {
 public:
  /// @param values  a Value::Map (anything else is noted as an error)
  /// @param name  the full name of this group, for messages; empty for the root
  explicit Parameters(Value values, std::string name = "");

  [[nodiscard]] bool has(const std::string& name);

  /// A parameter without which there is no run.
  template <class T>
  [[nodiscard]] T required(const std::string& name);

  /// A parameter with a default, which `defaultsTaken()` lists when it was used.
  template <class T>
  [[nodiscard]] T optional(const std::string& name, const T& fallback);

  /// A parameter whose absence means something of its own.
  template <class T>
  [[nodiscard]] std::optional<T> maybe(const std::string& name);

  /// A number from `least` to `most`, both included; otherwise an error is noted, and the fallback
  /// taken.
  template <class T>
  [[nodiscard]] T optionalBetween(const std::string& name, T fallback, T least, T most);

  /// The same without a default.
  template <class T>
  [[nodiscard]] std::optional<T> maybeBetween(const std::string& name, T least, T most);

  /// A text that is one of a few; otherwise an error is noted, and the fallback taken.
  [[nodiscard]] std::string requiredChoice(const std::string& name,
                                           const std::vector<std::string>& choices);
  [[nodiscard]] std::string optionalChoice(const std::string& name,
                                           const std::vector<std::string>& choices,
                                           const std::string& fallback);
  [[nodiscard]] std::optional<std::string> maybeChoice(const std::string& name,
                                                       const std::vector<std::string>& choices);

  /// The parameters below `name`; an empty group where there are none.
  [[nodiscard]] Parameters group(const std::string& name);

  /// Notes what a parameter is, for forms and references: its `default`, its `choices`, or its
  /// `range` as [least, most]. The methods above do so by themselves.
  void declare(const std::string& name, const std::string& fact, Value value);

  /// Notes an error about a parameter of this group: "<full name>: <message>".
  void addError(const std::string& name, const std::string& message);

  /// Takes note that a parameter is known although nobody reads it here.
  void ignore(const std::string& name);

  /// "group/name" as the user would write it below the node.
  [[nodiscard]] std::string fullName(const std::string& name) const;

  /// Names of this group's entries in alphabetical order.
  [[nodiscard]] std::vector<std::string> names() const;

  /// Full names of the entries in this group and the groups made from it that nobody asked for.
  [[nodiscard]] std::vector<std::string> unknownNames() const;

  /// The names that were asked for in the group that holds `full_name`: what it may have meant.
  [[nodiscard]] std::vector<std::string> knownNeighbours(const std::string& full_name) const;

  /// The full names that were asked for in any group and end like this one: "camera/effects/blur".
  [[nodiscard]] std::vector<std::string> knownElsewhere(const std::string& name) const;

  [[nodiscard]] const std::vector<std::string>& errors() const;

  /// What was declared of each parameter, by full name.
  [[nodiscard]] const std::map<std::string, Value::Map>& declarations() const;

  /// "name: value" of each default used, in order of reading.
  [[nodiscard]] const std::vector<std::string>& defaultsTaken() const;

  /// The same as values, by full name.
  [[nodiscard]] const std::map<std::string, Value>& defaultValues() const;

 private:
  struct Notes;
  Parameters(const Value::Map* values, std::string name, std::shared_ptr<Notes> notes);

  [[nodiscard]] const Value* find(const std::string& name);
  void noteDefault(const std::string& name, const Value& fallback);

  std::shared_ptr<const Value> owned_;
  const Value::Map* values_ = nullptr;
  std::string name_;
  std::shared_ptr<Notes> notes_;
};

}  // namespace v2
}  // namespace synthetic_dataset
