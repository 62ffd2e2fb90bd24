#include "synthetic_dataset/parameters.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

/// Converts a value, or says in `problem` what would be right.
template <class T>
std::optional<T> convert(const Value& value, std::string& problem);

template <>
std::optional<Value> convert(const Value& value, std::string& /*problem*/) {
  return value;
}

template <>
std::optional<bool> convert(const Value& value, std::string& problem) {
  if (const bool* flag = value.as<bool>()) return *flag;
  problem = "it should be true or false";
  return std::nullopt;
}

template <>
std::optional<std::int64_t> convert(const Value& value, std::string& problem) {
  if (const auto* number = value.as<std::int64_t>()) return *number;
  problem = "it should be a whole number";
  return std::nullopt;
}

template <>
std::optional<int> convert(const Value& value, std::string& problem) {
  const auto number = convert<std::int64_t>(value, problem);
  if (number && *number >= -2147483648LL && *number <= 2147483647LL) {
    return static_cast<int>(*number);
  }
  problem = "it should be a whole number";
  return std::nullopt;
}

/// A number such as 1e-05, which yaml-cpp writes but YAML 1.1, and so roslaunch, reads as a text.
std::optional<double> numberIn(const std::string& text) {
  if (text.find_first_not_of("+-.0123456789eE") != std::string::npos) return std::nullopt;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (!(stream >> number) || !stream.eof()) return std::nullopt;
  return number;
}

/// An angle in degrees given as a text, as in private parameters: in settings files, rosparam's
/// `deg(90)` is already a number.
std::optional<double> degreesIn(const std::string& text) {
  const bool is_angle = text.rfind("deg(", 0) == 0 && text.back() == ')';
  const auto number = is_angle ? numberIn(text.substr(4, text.size() - 5)) : std::nullopt;
  return number ? std::optional(*number * M_PI / 180.0) : std::nullopt;
}

template <>
std::optional<double> convert(const Value& value, std::string& problem) {
  if (const auto* number = value.as<std::int64_t>()) return static_cast<double>(*number);
  if (const auto* number = value.as<double>(); number && std::isfinite(*number)) return *number;
  if (const auto* text = value.as<std::string>()) {
    if (const auto number = numberIn(*text)) return number;
    if (const auto number = degreesIn(*text)) return number;
  }
  problem = "it should be a finite number";
  return std::nullopt;
}

template <>
std::optional<std::string> convert(const Value& value, std::string& problem) {
  if (const auto* text = value.as<std::string>()) return *text;
  problem = "it should be a text";
  return std::nullopt;
}

/// Converts each entry of a list; the problem names the entry.
template <class T>
std::optional<std::vector<T>> convertList(const Value& value, const std::string& should,
                                          std::string& problem) {
  const auto* list = value.as<Value::List>();
  if (list == nullptr) {
    problem = "it should be " + should;
    return std::nullopt;
  }
  std::vector<T> result;
  for (std::size_t i = 0; i < list->size(); ++i) {
    std::string entry_problem;
    auto entry = convert<T>((*list)[i], entry_problem);
    if (!entry) {
      problem = "entry " + std::to_string(i + 1) + " is " + (*list)[i].text() + "; it should be " +
                should;
      return std::nullopt;
    }
    result.push_back(std::move(*entry));
  }
  return result;
}

template <>
std::optional<std::vector<double>> convert(const Value& value, std::string& problem) {
  return convertList<double>(value, "a list of numbers", problem);
}

template <>
std::optional<std::vector<std::string>> convert(const Value& value, std::string& problem) {
  if (const auto* text = value.as<std::string>()) return std::vector<std::string>{*text};
  return convertList<std::string>(value, "a list of texts", problem);
}

template <>
std::optional<Eigen::Vector3d> convert(const Value& value, std::string& problem) {
  const auto numbers = convert<std::vector<double>>(value, problem);
  if (numbers && numbers->size() == 3) {
    return Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  }
  return std::nullopt;
}

template <>
std::optional<std::vector<Eigen::Vector3d>> convert(const Value& value, std::string& problem) {
  return convertList<Eigen::Vector3d>(value, "a list of points, each [x, y, z] in metres", problem);
}

/// Shortened, as a long list would hide the rest of the message.
std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 80;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

}  // namespace

/// The state shared by all groups of one root.
struct Parameters::Notes {
  std::vector<std::string> errors;
  std::vector<std::string> defaults;
  std::map<std::string, Value> default_values;
  std::map<std::string, std::set<std::string>> known;  // by the group's full name
  std::map<std::string, Value::Map> declarations;
};

Parameters::Parameters(Value values, std::string name)
    : owned_(std::make_shared<const Value>(std::move(values))),
      values_(owned_->as<Value::Map>()),
      name_(std::move(name)),
      notes_(std::make_shared<Notes>()) {
  if (values_ == nullptr && !owned_->isNull()) {
    notes_->errors.push_back((name_.empty() ? "the parameters" : name_) + ": found " +
                             owned_->kind() + "; it should be a group of named values");
  }
}

Parameters::Parameters(const Value::Map* values, std::string name, std::shared_ptr<Notes> notes)
    : values_(values), name_(std::move(name)), notes_(std::move(notes)) {}

const Value* Parameters::find(const std::string& name) {
  notes_->known[name_].insert(name);
  if (values_ == nullptr) return nullptr;
  const auto entry = values_->find(name);
  return entry == values_->end() || entry->second.isNull() ? nullptr : &entry->second;
}

bool Parameters::has(const std::string& name) { return find(name) != nullptr; }

template <class T>
std::optional<T> Parameters::maybe(const std::string& name) {
  const Value* value = find(name);
  if (value == nullptr) return std::nullopt;
  std::string problem;
  std::optional<T> result = convert<T>(*value, problem);
  if (!result) {
    addError(name, "found " + shortened(value->text()) + " (" + value->kind() + "); " + problem);
  }
  return result;
}

template <class T>
T Parameters::required(const std::string& name) {
  if (find(name) == nullptr) {
    addError(name, "required, but missing");
    return T{};
  }
  return maybe<T>(name).value_or(T{});
}

void Parameters::noteDefault(const std::string& name, const Value& fallback) {
  declare(name, "default", fallback);
  if (find(name) != nullptr) return;
  notes_->defaults.push_back(fullName(name) + ": " + fallback.text());
  notes_->default_values[fullName(name)] = fallback;
}

template <class T>
T Parameters::optional(const std::string& name, const T& fallback) {
  noteDefault(name, fallback);
  return maybe<T>(name).value_or(fallback);
}

template <class T>
T Parameters::optionalBetween(const std::string& name, T fallback, T least, T most) {
  noteDefault(name, fallback);
  return maybeBetween(name, least, most).value_or(fallback);
}

template <class T>
std::optional<T> Parameters::maybeBetween(const std::string& name, T least, T most) {
  declare(name, "range", Value::List{Value(least), Value(most)});
  const std::optional<T> number = maybe<T>(name);
  if (!number || (*number >= least && *number <= most)) return number;
  addError(name, "found " + Value(*number).text() + "; it should be " + Value(least).text() +
                     " to " + Value(most).text());
  return std::nullopt;
}

std::optional<std::string> Parameters::maybeChoice(const std::string& name,
                                                   const std::vector<std::string>& choices) {
  declare(name, "choices", Value::List(choices.begin(), choices.end()));
  const Value* value = find(name);
  if (value == nullptr) return std::nullopt;
  const bool* flag = value->as<bool>();
  const std::string choice = flag == nullptr ? value->text() : *flag ? "on" : "off";
  if (std::find(choices.begin(), choices.end(), choice) != choices.end()) return choice;
  std::string all = choices.front();
  for (std::size_t i = 1; i < choices.size(); ++i) {
    all += (i + 1 < choices.size() ? ", " : " or ") + choices[i];
  }
  const std::string is_flag =
      flag == nullptr
          ? ""
          : " (" + value->text() + ", as YAML reads yes, no, on and off without quotes)";
  addError(name, "found '" + choice + "'" + is_flag + "; it should be " + all +
                     didYouMean(choice, choices));
  return std::nullopt;
}

std::string Parameters::requiredChoice(const std::string& name,
                                       const std::vector<std::string>& choices) {
  if (find(name) == nullptr) (void)required<std::string>(name);
  return maybeChoice(name, choices).value_or("");
}

std::string Parameters::optionalChoice(const std::string& name,
                                       const std::vector<std::string>& choices,
                                       const std::string& fallback) {
  noteDefault(name, fallback);
  return maybeChoice(name, choices).value_or(fallback);
}

// The types that the header lists; lists have no printable default.
template std::optional<bool> Parameters::maybe(const std::string&);
template std::optional<int> Parameters::maybe(const std::string&);
template std::optional<std::int64_t> Parameters::maybe(const std::string&);
template std::optional<double> Parameters::maybe(const std::string&);
template std::optional<std::string> Parameters::maybe(const std::string&);
template std::optional<Value> Parameters::maybe(const std::string&);
template std::optional<std::vector<double>> Parameters::maybe(const std::string&);
template std::optional<std::vector<std::string>> Parameters::maybe(const std::string&);
template std::optional<std::vector<Eigen::Vector3d>> Parameters::maybe(const std::string&);
template bool Parameters::required(const std::string&);
template int Parameters::required(const std::string&);
template std::int64_t Parameters::required(const std::string&);
template double Parameters::required(const std::string&);
template std::string Parameters::required(const std::string&);
template Value Parameters::required(const std::string&);
template std::vector<double> Parameters::required(const std::string&);
template std::vector<std::string> Parameters::required(const std::string&);
template std::vector<Eigen::Vector3d> Parameters::required(const std::string&);
template bool Parameters::optional(const std::string&, const bool&);
template int Parameters::optional(const std::string&, const int&);
template std::int64_t Parameters::optional(const std::string&, const std::int64_t&);
template double Parameters::optional(const std::string&, const double&);
template std::string Parameters::optional(const std::string&, const std::string&);
template int Parameters::optionalBetween(const std::string&, int, int, int);
template std::int64_t Parameters::optionalBetween(const std::string&, std::int64_t, std::int64_t,
                                                  std::int64_t);
template double Parameters::optionalBetween(const std::string&, double, double, double);
template std::optional<int> Parameters::maybeBetween(const std::string&, int, int);
template std::optional<std::int64_t> Parameters::maybeBetween(const std::string&, std::int64_t,
                                                              std::int64_t);
template std::optional<double> Parameters::maybeBetween(const std::string&, double, double);

Parameters Parameters::group(const std::string& name) {
  const Value* value = find(name);
  const Value::Map* map = value == nullptr ? nullptr : value->as<Value::Map>();
  if (value != nullptr && map == nullptr) {
    addError(name, "found " + value->text() + " (" + value->kind() +
                       "); it should be a group of named values");
  }
  Parameters result(map, fullName(name), notes_);
  result.owned_ = owned_;  // the group's values live in the root's
  notes_->known[result.name_];
  return result;
}

void Parameters::addError(const std::string& name, const std::string& message) {
  notes_->errors.push_back(fullName(name) + ": " + message);
}

void Parameters::declare(const std::string& name, const std::string& fact, Value value) {
  notes_->declarations[fullName(name)][fact] = std::move(value);
}

void Parameters::ignore(const std::string& name) { notes_->known[name_].insert(name); }

std::string Parameters::fullName(const std::string& name) const {
  if (name_.empty()) return name;
  return name.empty() ? name_ : name_ + "/" + name;
}

std::vector<std::string> Parameters::names() const {
  std::vector<std::string> result;
  if (values_ != nullptr) {
    for (const auto& [name, value] : *values_) result.push_back(name);
  }
  return result;
}

std::vector<std::string> Parameters::unknownNames() const {
  std::vector<std::string> result;
  const auto& known = notes_->known[name_];
  for (const std::string& name : names()) {
    if (known.count(name) == 0) {
      result.push_back(fullName(name));
      continue;
    }
    const auto* map = values_->at(name).as<Value::Map>();
    if (map == nullptr || notes_->known.count(fullName(name)) == 0) continue;
    const Parameters below(map, fullName(name), notes_);
    for (std::string& unknown : below.unknownNames()) result.push_back(std::move(unknown));
  }
  return result;
}

std::vector<std::string> Parameters::knownNeighbours(const std::string& full_name) const {
  const std::size_t slash = full_name.rfind('/');
  const auto group =
      notes_->known.find(slash == std::string::npos ? "" : full_name.substr(0, slash));
  if (group == notes_->known.end()) return {};
  return {group->second.begin(), group->second.end()};
}

std::vector<std::string> Parameters::knownElsewhere(const std::string& name) const {
  std::vector<std::string> full_names;
  for (const auto& [group, known] : notes_->known) {
    if (known.count(name) == 0) continue;
    full_names.push_back(group.empty() ? name : group + "/" + name);
  }
  return full_names;
}

const std::vector<std::string>& Parameters::errors() const { return notes_->errors; }

const std::map<std::string, Value::Map>& Parameters::declarations() const {
  return notes_->declarations;
}

const std::vector<std::string>& Parameters::defaultsTaken() const { return notes_->defaults; }

const std::map<std::string, Value>& Parameters::defaultValues() const {
  return notes_->default_values;
}

}  // namespace v2
}  // namespace synthetic_dataset
