#include "world/sdf/sdf_copies.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <tinyxml2.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolderName = "synthetic_dataset_sdf.";

/// Text of an element or an attribute (XML 1.0, section 2.4).
std::string escaped(const char* text) {
  std::string result;
  for (; *text != '\0'; ++text) {
    switch (*text) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += *text;
    }
  }
  return result;
}

/// Writes elements on the lines where they were read.
class LinedWriter {
 public:
  explicit LinedWriter(std::ostream& stream) : stream_(stream) {}

  void write(const tinyxml2::XMLElement& element) {
    while (line_ < element.GetLineNum()) put("\n");
    put(std::string("<") + element.Name());
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      put(std::string(" ") + attribute->Name() + "=\"" + escaped(attribute->Value()) + '"');
    }
    put(">");
    for (const auto* child = element.FirstChild(); child != nullptr; child = child->NextSibling()) {
      if (child->ToElement() != nullptr) write(*child->ToElement());
      if (child->ToText() != nullptr) put(escaped(child->Value()));
    }
    put(std::string("</") + element.Name() + ">");
  }

 private:
  void put(const std::string& text) {
    for (const char c : text) line_ += c == '\n' ? 1 : 0;
    stream_ << text;
  }

  std::ostream& stream_;
  int line_ = 1;
};

}  // namespace

SdfCopies::SdfCopies() : folder_(kFolderName) {}

fs::path SdfCopies::copyOf(const fs::path& original) const {
  return folder_.path() / original.relative_path();
}

void SdfCopies::write(const fs::path& original, const tinyxml2::XMLElement& root) const {
  const fs::path copy = copyOf(original);
  std::error_code ignored;
  fs::create_directories(copy.parent_path(), ignored);
  std::ofstream stream(copy, std::ios::binary);
  LinedWriter(stream).write(root);
  stream.close();
  if (stream.fail()) {
    throw Error("'" + copy.string() + "': cannot be written: " + std::strerror(errno));
  }
}

std::string SdfCopies::withOriginalPaths(std::string message) const {
  const std::string folder = folder_.path().string();
  for (std::size_t at = message.find(folder); at != std::string::npos;
       at = message.find(folder, at)) {
    message.erase(at, folder.size());
  }
  return message;
}

std::string originalOf(const std::string& path) {
  const std::size_t mark = path.find(std::string("/") + kFolderName);
  if (mark == std::string::npos) return path;
  const std::size_t end = path.find('/', mark + 1);
  return end == std::string::npos ? path : path.substr(end);
}

}  // namespace synthetic_dataset::world
