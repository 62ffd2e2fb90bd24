#include "config/launch_substitution.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "base/ros_packages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace {

const char* const kKnown =
    "$(find PKG), $(env NAME), $(optenv NAME [DEFAULT]) and $(dirname) are known here";

/// A command between `$(` and `)`.
struct Command {
  std::string content;  ///< unchanged
  std::size_t offset;   ///< of the dollar sign
  std::size_t line;     ///< of the dollar sign, from 1

  [[nodiscard]] std::string text() const { return "$(" + content + ")"; }

  /// Splits as roslaunch does: only at spaces, not at tabs and line ends.
  [[nodiscard]] std::vector<std::string> words() const {
    std::vector<std::string> words;
    std::istringstream stream(content);
    for (std::string word; std::getline(stream, word, ' ');) {
      if (!word.empty()) words.push_back(word);
    }
    return words;
  }
};

/// Follows roslaunch's substitution_args.py step by step, so that the result is the same.
class Substitution {
 public:
  Substitution(std::string text, const SubstitutionSources& sources)
      : text_(std::move(text)), sources_(sources) {}

  std::string result() {
    for (const Command& command : commands()) replaceVariable(command);
    // Packages come last: roslaunch needs the path after them to be complete.
    for (const Command& command : commands()) replacePackage(command);
    return text_;
  }

 private:
  [[noreturn]] void fail(const Command& command, const std::string& message) const {
    throw Error(sources_.file + ": line " + std::to_string(command.line) + ": found " + message);
  }

  /// The commands in the current text.
  [[nodiscard]] std::vector<Command> commands() const {
    enum class State { kOutside, kDollar, kOpened, kInside };
    std::vector<Command> commands;
    State state = State::kOutside;
    Command command{"", 0, 1};
    std::size_t line = 1;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '\n') ++line;
      if (c == '$') {
        if (state == State::kOpened || state == State::kInside) failInside(command, c);
        state = State::kDollar;
        command = {"", i, line};
      } else if (c == '(') {
        if (state == State::kOpened || state == State::kInside) failInside(command, c);
        if (state == State::kDollar) state = State::kOpened;
      } else if (c == ')') {
        if (state == State::kInside) commands.push_back(checked(command));
        state = State::kOutside;
      } else if (state == State::kDollar) {
        state = State::kOutside;
      } else if (state == State::kOpened) {
        state = State::kInside;
      }
      if (state == State::kInside) command.content += c;
    }
    return commands;
  }

  [[noreturn]] void failInside(const Command& command, char found) const {
    constexpr std::size_t kLongest = 60;
    const std::string rest = text_.substr(command.offset, kLongest);
    fail(command, "'" + rest.substr(0, rest.find('\n')) + "', in which another '" + found +
                      "' follows; '$(...)' can hold none, or its ')' is missing");
  }

  [[nodiscard]] const Command& checked(const Command& command) const {
    const std::vector<std::string> words = command.words();
    const std::string name = words.empty() ? "" : words[0];
    if (name == "arg" || name == "anon" || name == "eval") {
      fail(command, command.text() + ", which only a launch file can say; " + kKnown);
    }
    if (name != "find" && name != "env" && name != "optenv" && name != "dirname") {
      fail(command, command.text() + "; " + kKnown);
    }
    if ((name == "find" || name == "env") && words.size() != 2) {
      fail(command,
           command.text() + "; it should be $(" + name + (name == "find" ? " PKG)" : " NAME)"));
    }
    if (name == "optenv" && words.size() < 2) {
      fail(command, "$(optenv); it should be $(optenv NAME [DEFAULT])");
    }
    return command;
  }

  void replaceVariable(const Command& command) {
    const std::vector<std::string> words = command.words();
    if (words[0] == "env") {
      const auto value = sources_.environment(words[1]);
      if (!value) {
        fail(command, command.text() + ", but the environment variable " + words[1] +
                          " is not set; $(optenv " + words[1] + " DEFAULT) has a default");
      }
      replaceAll(command.text(), *value);
    } else if (words[0] == "optenv") {
      std::string fallback;
      for (std::size_t i = 2; i < words.size(); ++i) fallback += (i > 2 ? " " : "") + words[i];
      replaceAll(command.text(), sources_.environment(words[1]).value_or(fallback));
    } else if (words[0] == "dirname") {
      const std::filesystem::path file = std::filesystem::absolute(sources_.file);
      replaceAll(command.text(), file.lexically_normal().parent_path().string());
    }
  }

  void replaceAll(const std::string& from, const std::string& to) {
    std::string result;
    std::size_t begin = 0;
    for (std::size_t at = text_.find(from); at != std::string::npos; at = text_.find(from, begin)) {
      result.append(text_, begin, at - begin).append(to);
      begin = at + from.size();
    }
    text_ = result.append(text_, begin, std::string::npos);
  }

  /// Replaces the first occurrence of the command. What follows, up to the next space, is taken as
  /// a path: it is joined with a slash, and its backslashes become slashes.
  void replacePackage(const Command& command) {
    const std::vector<std::string> words = command.words();
    if (words[0] != "find") return;
    const auto folder = sources_.package_folder(words[1]);
    if (!folder) {
      fail(command, command.text() +
                        ", but ROS knows no package of this name (is the "
                        "workspace's setup.bash sourced?)" +
                        base::didYouMeanPackage(words[1]));
    }
    const std::size_t begin = text_.find(command.text());
    if (begin == std::string::npos) return;
    const std::size_t path_begin = begin + command.text().size();
    const std::size_t path_end = std::min(text_.find(' ', path_begin), text_.size());
    std::string path = text_.substr(path_begin, path_end - path_begin);
    std::replace(path.begin(), path.end(), '\\', '/');
    if (!path.empty() && path[0] == '/') path.erase(0, 1);
    if (path.empty()) {
      path = *folder;
    } else if (path[0] != '/') {  // for Python, a folder joined with an absolute path is the latter
      path.insert(0, folder->back() == '/' ? *folder : *folder + '/');
    }
    text_.replace(begin, path_end - begin, path);
  }

  std::string text_;
  const SubstitutionSources& sources_;
};

}  // namespace

std::optional<std::string> environmentVariable(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  if (value == nullptr) return std::nullopt;
  return value;
}

std::string substitute(const std::string& text, const SubstitutionSources& sources) {
  return Substitution(text, sources).result();
}

}  // namespace synthetic_dataset::config
