#include "world/sdf/xml_repair.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace synthetic_dataset::world {
namespace {

bool isXmlBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// The text with its declarations blanked out, which preserves line numbers.
std::string withoutDeclarations(std::string text) {
  for (std::size_t at = text.find("<?"); at != std::string::npos; at = text.find("<?", at)) {
    const std::size_t end = text.find("?>", at);
    if (end == std::string::npos) break;
    std::replace_if(
        text.begin() + static_cast<std::ptrdiff_t>(at),
        text.begin() + static_cast<std::ptrdiff_t>(end + 2), [](char c) { return c != '\n'; }, ' ');
  }
  return text;
}

/// Copies a text, with quotes added around the attributes that lack them.
class Quoter {
 public:
  explicit Quoter(std::string_view text) : text_(text) {}

  std::string quoted() {
    while (at_ < text_.size()) {
      if (text_[at_] != '<') {
        copy(1);
      } else if (!copySection("<!--", "-->") && !copySection("<![CDATA[", "]]>") &&
                 !copySection("<!", ">")) {
        copyTag();
      }
    }
    return std::move(result_);
  }

 private:
  void copy(std::size_t count) {
    result_ += text_.substr(at_, count);
    at_ += count;
  }

  bool copySection(std::string_view start, std::string_view end) {
    if (text_.substr(at_, start.size()) != start) return false;
    const std::size_t last = text_.find(end, at_ + start.size());
    copy(last == std::string_view::npos ? text_.size() - at_ : last + end.size() - at_);
    return true;
  }

  void copyTag() {
    while (at_ < text_.size() && text_[at_] != '>') {
      if (text_[at_] == '"' || text_[at_] == '\'') {
        const std::size_t end = text_.find(text_[at_], at_ + 1);
        copy(end == std::string_view::npos ? text_.size() - at_ : end + 1 - at_);
      } else if (text_[at_] == '=') {
        copyEquals();
      } else {
        copy(1);
      }
    }
  }

  void copyEquals() {
    copy(1);
    while (at_ < text_.size() && isXmlBlank(text_[at_])) copy(1);
    if (at_ == text_.size() || text_[at_] == '"' || text_[at_] == '\'') return;
    result_ += '"';
    while (at_ < text_.size() && !isXmlBlank(text_[at_]) && text_[at_] != '>' &&
           text_.substr(at_, 2) != "/>") {
      copy(1);
    }
    result_ += '"';
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string result_;
};

}  // namespace

std::string repairedXml(const std::string& text) {
  return Quoter(withoutDeclarations(text)).quoted();
}

}  // namespace synthetic_dataset::world
