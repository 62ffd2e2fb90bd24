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
/// A wrong or missing parameter never throws: the reader notes the error, with the parameter's full
/// name, what was found and what would be right, and returns a harmless value. The owner of the
/// root checks `errors()` at the end.
///
/// Methods that may note something are not const; copies and groups share their root's notes.
///
/// Every parameter that was asked for counts as known; `unknownNames()` returns the others, which
/// are usually misspelt.
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

  /// A mandatory parameter; an error is noted if it is missing.
  template <class T>
  [[nodiscard]] T required(const std::string& name);

  /// A parameter with a default, which `defaultsTaken()` lists if it was used.
  template <class T>
  [[nodiscard]] T optional(const std::string& name, const T& fallback);

  /// A parameter whose absence has a meaning of its own.
  template <class T>
  [[nodiscard]] std::optional<T> maybe(const std::string& name);

  /// A number from `least` to `most`, both included; otherwise an error is noted and the fallback
  /// returned.
  template <class T>
  [[nodiscard]] T optionalBetween(const std::string& name, T fallback, T least, T most);

  /// The same without a default.
  template <class T>
  [[nodiscard]] std::optional<T> maybeBetween(const std::string& name, T least, T most);

  /// One of the texts in `choices`; for any other, an error is noted and the fallback returned (if
  /// there is none, "" or nullopt).
  [[nodiscard]] std::string requiredChoice(const std::string& name,
                                           const std::vector<std::string>& choices);
  [[nodiscard]] std::string optionalChoice(const std::string& name,
                                           const std::vector<std::string>& choices,
                                           const std::string& fallback);
  [[nodiscard]] std::optional<std::string> maybeChoice(const std::string& name,
                                                       const std::vector<std::string>& choices);

  /// The parameters below `name`; an empty group if there are none.
  [[nodiscard]] Parameters group(const std::string& name);

  /// Notes a fact about a parameter for forms and reference pages: its `default`, its `choices`, or
  /// its `range` as [least, most]. The methods above do so themselves.
  void declare(const std::string& name, const std::string& fact, Value value);

  /// Notes an error about a parameter of this group: "<full name>: <message>".
  void addError(const std::string& name, const std::string& message);

  /// Marks a parameter as known although nothing reads it.
  void ignore(const std::string& name);

  /// "group/name" as the user would write it below the node.
  [[nodiscard]] std::string fullName(const std::string& name) const;

  /// Names of this group's entries in alphabetical order.
  [[nodiscard]] std::vector<std::string> names() const;

  /// Full names of the entries that nobody asked for, in this group and the groups made from it.
  [[nodiscard]] std::vector<std::string> unknownNames() const;

  /// The names that were asked for in the group of `full_name`: what the user may have meant by it.
  [[nodiscard]] std::vector<std::string> knownNeighbours(const std::string& full_name) const;

  /// The full names that were asked for, in any group, and whose last part is `name`:
  /// "camera/effects/blur".
  [[nodiscard]] std::vector<std::string> knownElsewhere(const std::string& name) const;

  [[nodiscard]] const std::vector<std::string>& errors() const;

  /// What was declared about each parameter, by full name.
  [[nodiscard]] const std::map<std::string, Value::Map>& declarations() const;

  /// "name: value" of each default used, in order of reading.
  [[nodiscard]] const std::vector<std::string>& defaultsTaken() const;

  /// The defaults used, as values by full name.
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
