#include "world/material/ogre_script.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

enum class OgreTokenKind { kWord, kQuoted, kOpen, kClose, kColon, kLineEnd };

struct OgreToken {
  OgreTokenKind kind = OgreTokenKind::kWord;
  std::string text;  ///< of words, without quotes
  int line = 0;
};

class Lexer {
 public:
  explicit Lexer(const std::string& text) : text_(text) {}

  std::vector<OgreToken> read() {
    while (at_ < text_.size()) readOne();
    add(OgreTokenKind::kLineEnd);
    return std::move(tokens_);
  }

 private:
  void readOne() {
    const char c = text_[at_];
    if (c == '\n') {
      add(OgreTokenKind::kLineEnd);
      ++line_;
      ++at_;
    } else if (isBlank(c)) {
      ++at_;
    } else if (text_.compare(at_, 2, "//") == 0) {
      skipTo("\n");
    } else if (text_.compare(at_, 2, "/*") == 0) {
      skipBlockComment();
    } else if (c == '"') {
      readQuoted();
    } else if (c == '{' || c == '}' || c == ':') {
      add(c == '{'   ? OgreTokenKind::kOpen
          : c == '}' ? OgreTokenKind::kClose
                     : OgreTokenKind::kColon);
      ++at_;
    } else {
      readWord();
    }
  }

  /// Lines end with '\n'; carriage returns and a byte order mark count as blanks.
  static bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\xEF' ||
           c == '\xBB' || c == '\xBF';
  }

  void add(OgreTokenKind kind, const std::string& text = "") {
    tokens_.push_back({kind, text, line_});
  }

  void skipTo(const char* end) {
    const std::size_t found = text_.find(end, at_);
    at_ = found == std::string::npos ? text_.size() : found;
  }

  void skipBlockComment() {
    const int first_line = line_;
    const std::size_t end = text_.find("*/", at_ + 2);
    if (end == std::string::npos) fail(first_line, "a comment '/*' without its '*/'");
    for (; at_ < end; ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
    at_ = end + 2;
  }

  void readQuoted() {
    const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
    if (end == std::string::npos || text_[end] == '\n') fail(line_, "an unclosed quoted name");
    add(OgreTokenKind::kQuoted, text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
  }

  void readWord() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_]) && text_[at_] != '\n' && text_[at_] != '{' &&
           text_[at_] != '}') {
      ++at_;
    }
    add(OgreTokenKind::kWord, text_.substr(begin, at_ - begin));
  }

  [[noreturn]] static void fail(int line, const std::string& what) {
    throw Error("line " + std::to_string(line) + ": " + what);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<OgreToken> tokens_;
};

/// Splits an OGRE script into words, braces, colons and line ends; comments are dropped. As in
/// OGRE, a colon or a comment counts as such only where a word could begin, so that `http://x` is
/// one word.
/// @throws Error "line 7: an unclosed quoted name"
std::vector<OgreToken> readOgreTokens(const std::string& text) { return Lexer(text).read(); }

/// The deepest nesting of sections; real scripts have four levels.
constexpr int kDeepestBraces = 32;

[[noreturn]] void fail(int line, const std::string& what) {
  throw Error("line " + std::to_string(line) + ": " + what);
}

class Parser {
 public:
  explicit Parser(std::vector<OgreToken> tokens) : tokens_(std::move(tokens)) {}

  OgreScript read() {
    OgreObject root;
    readContent(root, 0);
    if (at_ < tokens_.size()) fail(tokens_[at_].line, "'}' without a '{' before it");
    script_.objects = std::move(root.objects);
    return std::move(script_);
  }

 private:
  using Kind = OgreTokenKind;

  [[nodiscard]] bool is(Kind kind) const {
    return at_ < tokens_.size() && tokens_[at_].kind == kind;
  }
  [[nodiscard]] bool isText() const { return is(Kind::kWord) || is(Kind::kQuoted); }

  /// Reads up to the section's '}' or the end of the text.
  void readContent(OgreObject& into, int depth) {
    if (depth > kDeepestBraces) fail(into.line, "its sections are nested too deep");
    while (at_ < tokens_.size() && !is(Kind::kClose)) {
      if (is(Kind::kLineEnd)) {
        ++at_;
      } else if (isText()) {
        readStatement(into, depth);
      } else {
        fail(tokens_[at_].line,
             "found '" + std::string(is(Kind::kOpen) ? "{" : ":") + "' where a name should be");
      }
    }
  }

  /// Reads a line and, if a '{' follows it, the section that it begins.
  void readStatement(OgreObject& into, int depth) {
    const int line = tokens_[at_].line;
    std::vector<std::string> words = readWords();
    const bool has_parents = is(Kind::kColon);
    std::vector<std::string> parents;
    if (has_parents) {
      ++at_;
      parents = readWords();
    }
    if (opensSection()) {
      into.objects.push_back(readSection(std::move(words), std::move(parents), line, depth));
    } else if (depth == 0 && words.front() == "import") {
      script_.imports.push_back(importOf(words, line));
    } else if (!has_parents) {
      const std::string name = words.front();
      words.erase(words.begin());
      into.properties.push_back({name, std::move(words), line});
    } else {
      fail(line, "'" + words.front() + "' has parents but no section in '{' and '}'");
    }
  }

  std::vector<std::string> readWords() {
    std::vector<std::string> words;
    for (; isText(); ++at_) words.push_back(tokens_[at_].text);
    return words;
  }

  /// Moves past a '{', which may be on a line of its own, if one follows.
  bool opensSection() {
    std::size_t next = at_;
    while (next < tokens_.size() && tokens_[next].kind == Kind::kLineEnd) ++next;
    if (next == tokens_.size() || tokens_[next].kind != Kind::kOpen) return false;
    at_ = next + 1;
    return true;
  }

  OgreObject readSection(std::vector<std::string> words, std::vector<std::string> parents, int line,
                         int depth) {
    OgreObject object;
    object.line = line;
    if (words.size() > 1 && words.front() == "abstract") words.erase(words.begin());
    object.kind = words[0];
    if (words.size() > 1) object.name = words[1];
    object.parents = std::move(parents);
    readContent(object, depth + 1);
    if (!is(Kind::kClose)) {
      fail(line, "the section '" + object.kind + (object.name.empty() ? "" : " " + object.name) +
                     "' has no '}' at its end");
    }
    ++at_;
    return object;
  }

  /// The file that an import statement names.
  static std::string importOf(const std::vector<std::string>& words, int line) {
    const auto from = std::find(words.begin(), words.end(), "from");
    if (from == words.end() || from + 1 == words.end()) {
      fail(line, "an import should read: import NAME from \"FILE\"");
    }
    return *(from + 1);
  }

  std::vector<OgreToken> tokens_;
  std::size_t at_ = 0;
  OgreScript script_;
};

/// A real property has a dozen values; variables of many words could make it grow without bound.
constexpr std::size_t kMostValues = 1000;

using Variables = std::map<std::string, std::vector<std::string>>;

void replaceIn(OgreProperty& property, const Variables& variables) {
  std::vector<std::string> values;
  for (const std::string& value : property.values) {
    if (value.empty() || value.front() != '$') {
      values.push_back(value);
      continue;
    }
    const auto found = variables.find(value);
    if (found == variables.end()) {
      fail(property.line, "the variable '" + value + "' has no value");
    }
    values.insert(values.end(), found->second.begin(), found->second.end());
    if (values.size() <= kMostValues) continue;
    fail(property.line, "its variables give '" + property.name + "' more than " +
                            std::to_string(kMostValues) + " values");
  }
  property.values = std::move(values);
}

/// The value of a variable, which may be several words between quotes.
std::vector<std::string> wordsOf(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += value + " ";
  std::vector<std::string> words;
  for (const OgreToken& token : readOgreTokens(text)) {
    if (token.kind == OgreTokenKind::kWord) words.push_back(token.text);
  }
  return words;
}

void replaceWith(OgreObject& object, Variables variables) {
  for (OgreProperty& property : object.properties) {
    if (property.name != "set" || property.values.empty()) continue;
    variables[property.values.front()] =
        wordsOf({property.values.begin() + 1, property.values.end()});
  }
  for (OgreProperty& property : object.properties) {
    if (property.name != "set") replaceIn(property, variables);
  }
  for (OgreObject& inner : object.objects) replaceWith(inner, variables);
}

}  // namespace

OgreScript parseOgreScript(const std::string& text) { return Parser(readOgreTokens(text)).read(); }

void replaceVariables(OgreObject& object) { replaceWith(object, {}); }

}  // namespace synthetic_dataset::world
