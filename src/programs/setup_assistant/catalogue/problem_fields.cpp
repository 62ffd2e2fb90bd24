#include "programs/setup_assistant/catalogue/catalogue.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "programs/settings/documented_settings.h"

namespace synthetic_dataset::programs {
namespace {

const std::set<std::string>& documentedPaths() {
  static const std::set<std::string> kPaths = [] {
    std::set<std::string> paths;
    for (const DocumentedSetting& each : documentedSettings()) {
      paths.insert(each.path);
    }
    return paths;
  }();
  return kPaths;
}

const Value::Map* groupOf(const Value& value) { return value.as<Value::Map>(); }

std::string memberText(const Value::Map& map, const std::string& name) {
  const auto found = map.find(name);
  const auto* text = found == map.end() ? nullptr : found->second.as<std::string>();
  return text == nullptr ? "" : *text;
}

bool isIndex(const std::string& word) {
  return !word.empty() && word.size() < 9 &&
         std::all_of(word.begin(), word.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

Value::List pathOfName(const std::string& name) {
  Value::List path;
  std::istringstream parts(name);
  for (std::string part; std::getline(parts, part, '/');) {
    path.push_back(isIndex(part) ? Value(std::stoi(part)) : Value(part));
  }
  return path;
}

/// A word of a text, and whether the text marks it as a name.
struct Word {
  std::string text;
  bool is_marked = false;
};

std::vector<Word> wordsOf(const std::string& text) {
  std::vector<Word> words;
  Word word;
  bool in_backquotes = false;
  const auto finish = [&] {
    while (!word.text.empty() && word.text.back() == '/') word.text.pop_back();
    if (!word.text.empty()) words.push_back(word);
    word = {"", in_backquotes};
  };
  for (const char c : text) {
    if (c == '`') {
      finish();
      in_backquotes = !in_backquotes;
      word.is_marked = in_backquotes;
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/') {
      word.text += c;
    } else {
      finish();
      word.is_marked = in_backquotes;
    }
  }
  finish();
  return words;
}

/// Finds the setting whose value, the name of a file, occurs in a text; of several, the longest.
struct NamedFile {
  void findIn(const Value& value, const std::string& text, Value::List& above) {
    if (const auto* name = value.as<std::string>()) {
      const bool is_file = name->find_first_of("./") != std::string::npos;
      if (!is_file || name->size() <= longest || text.find(*name) == std::string::npos) return;
      longest = name->size();
      path = above;
    } else if (const auto* map = value.as<Value::Map>()) {
      for (const auto& each : *map) findBelow(Value(each.first), each.second, text, above);
    } else if (const auto* list = value.as<Value::List>()) {
      for (std::size_t i = 0; i < list->size(); ++i) {
        findBelow(Value(static_cast<std::int64_t>(i)), (*list)[i], text, above);
      }
    }
  }

  void findBelow(const Value& step, const Value& value, const std::string& text,
                 Value::List& above) {
    above.push_back(step);
    findIn(value, text, above);
    above.pop_back();
  }

  std::size_t longest = 3;  ///< a shorter name may occur by chance
  Value::List path;
};

class FieldFinder {
 public:
  explicit FieldFinder(const Value& settings) : settings_(groupOf(settings)) {}

  [[nodiscard]] std::optional<Value::List> find(const Value::Map& problem) const {
    const std::string about = memberText(problem, "about");
    if (isSetting(about) && (about.find('/') != std::string::npos || isGiven(about))) {
      return pathOfName(about);
    }
    for (const Word& word : wordsOf(about)) {  // "front and rover_1", "camera front"
      if (isNamed("robot_list", word.text)) return Value::List{Value(word.text)};
      if (isNamed("cameras", word.text)) return Value::List{Value("cameras"), Value(word.text)};
    }
    if (about == "camera" || about.rfind("camera ", 0) == 0) return Value::List{Value("camera")};
    NamedFile file;
    if (settings_ != nullptr) {
      Value::List path;
      file.findIn(Value(*settings_), about + " " + memberText(problem, "found"), path);
    }
    if (!file.path.empty()) return file.path;
    for (const char* part : {"cure", "found"}) {
      for (const Word& word : wordsOf(memberText(problem, part))) {
        const bool is_name = word.is_marked || word.text.find_first_of("_/") != std::string::npos;
        if (is_name && isSetting(word.text)) return pathOfName(word.text);
      }
    }
    if (isSetting(about)) return pathOfName(about);  // or a word: "scenes", "labels"
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool isGiven(const std::string& name) const {
    return settings_ != nullptr && settings_->count(name) != 0;
  }

  /// Whether a setting is documented, or lies in a group that the user has named.
  [[nodiscard]] bool isSetting(const std::string& name) const {
    if (name.empty() || name.front() == '/' || name.find(' ') != std::string::npos) return false;
    const std::string first = name.substr(0, name.find('/'));
    return documentedPaths().count(name) != 0 || documentedPaths().count(first) != 0 ||
           isGiven(first);
  }

  /// Whether a setting (a list of names, a list of groups with a `name`, or a group) has the name.
  [[nodiscard]] bool isNamed(const std::string& list, const std::string& name) const {
    if (!isGiven(list)) return false;
    const Value& value = settings_->at(list);
    if (const auto* map = groupOf(value)) return map->count(name) != 0;
    const auto* entries = value.as<Value::List>();
    return entries != nullptr &&
           std::any_of(entries->begin(), entries->end(), [&](const Value& entry) {
             const auto* group = groupOf(entry);
             return entry == Value(name) ||
                    (group != nullptr && memberText(*group, "name") == name);
           });
  }

  const Value::Map* settings_;
};

}  // namespace

void addFields(Value::Map& setup, const Value& settings) {
  auto* problems = setup["problems"].as<Value::List>();
  if (problems == nullptr) return;
  const FieldFinder finder(settings);
  for (Value& each : *problems) {
    auto* problem = each.as<Value::Map>();
    if (problem == nullptr) continue;
    problem->erase("path");
    if (const auto path = finder.find(*problem)) (*problem)["path"] = *path;
  }
}

}  // namespace synthetic_dataset::programs
