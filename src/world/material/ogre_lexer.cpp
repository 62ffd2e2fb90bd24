#include "world/material/ogre_lexer.h"

#include <cstddef>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

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

  /// Line ends are '\n'; those of Windows and a byte order mark are blanks.
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
    if (end == std::string::npos || text_[end] == '\n')
      fail(line_, "a quoted name without its end");
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

}  // namespace

std::vector<OgreToken> readOgreTokens(const std::string& text) { return Lexer(text).read(); }

}  // namespace synthetic_dataset::world
