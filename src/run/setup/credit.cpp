#include "run/setup/credit.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <system_error>
#include <vector>

#include <tinyxml2.h>

#include "base/input_file.h"
#include "base/xml_text.h"
#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"
#include "world/files/text.h"

namespace synthetic_dataset::run {
namespace {

namespace fs = std::filesystem;

constexpr int kLevels = 6;  // folders searched, starting with the file's own
constexpr std::size_t kHead = std::size_t{1} << 20U;  // [byte] searched for a mesh's `asset`

std::string headOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(kHead, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(kHead));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return head;
}

void add(std::string& all, const std::string& text) {
  const std::string name = world::trimmed(text);
  if (name.empty() || ("; " + all + "; ").find("; " + name + "; ") != std::string::npos) return;
  all += (all.empty() ? "" : "; ") + name;
}

std::string textOf(const tinyxml2::XMLElement* element) {
  return element != nullptr && element->GetText() != nullptr ? element->GetText() : "";
}

template <class Use>
void forEachChild(const tinyxml2::XMLElement& element, const char* name, const Use& use) {
  for (const auto* child = element.FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name)) {
    use(*child);
  }
}

/// Makes a credit that names `file` as the source of both texts.
Credit namedIn(const fs::path& file, const std::string& author, const std::string& license) {
  return {author, author.empty() ? fs::path() : file, license, license.empty() ? fs::path() : file};
}

Credit creditOfCollada(const fs::path& file) {
  const std::string head = headOf(file);
  const std::string end = "</asset>";
  const std::size_t first = head.find("<asset");
  const std::size_t last = first == std::string::npos ? first : head.find(end, first);
  if (last == std::string::npos) return {};
  tinyxml2::XMLDocument document;
  const auto fault = base::parseXml(document, head.substr(first, last + end.size() - first));
  const tinyxml2::XMLElement* asset = document.RootElement();
  if (fault || asset == nullptr) return {};
  std::string author;
  std::string license;
  forEachChild(*asset, "contributor", [&](const tinyxml2::XMLElement& contributor) {
    add(author, textOf(contributor.FirstChildElement("author")));
    add(license, textOf(contributor.FirstChildElement("copyright")));
  });
  return namedIn(file, author, license);
}

/// The text of a JSON object, from its opening to its closing brace.
std::string objectAt(const std::string& text, std::size_t brace) {
  int depth = 0;
  bool is_quoted = false;
  for (std::size_t i = brace; i < text.size(); ++i) {
    const char c = text[i];
    if (is_quoted) {
      if (c == '\\') ++i;
      if (c == '"') is_quoted = false;
    } else if (c == '"') {
      is_quoted = true;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return text.substr(brace, i + 1 - brace);
    }
  }
  return "";
}

Credit creditOfGltf(const fs::path& file) {
  const std::string head = headOf(file);
  const std::size_t key = head.find("\"asset\"");
  const std::size_t brace = key == std::string::npos ? key : head.find('{', key);
  if (brace == std::string::npos) return {};
  try {
    const Value asset = base::parseYaml(objectAt(head, brace), file.string());
    const auto* entries = asset.as<Value::Map>();
    const auto found =
        entries == nullptr ? Value::Map::const_iterator() : entries->find("copyright");
    if (entries == nullptr || found == entries->end()) return {};
    return namedIn(file, "", world::trimmed(found->second.text()));
  } catch (const Error&) {  // not JSON: reported when the mesh is read
    return {};
  }
}

/// The root element of a file; null if the file does not exist or is not XML.
const tinyxml2::XMLElement* rootOf(const fs::path& file, tinyxml2::XMLDocument& document) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return nullptr;
  try {
    return base::parseXml(document, base::readInput(file)) ? nullptr : document.RootElement();
  } catch (const Error&) {  // not readable
    return nullptr;
  }
}

Credit creditOfModelConfig(const fs::path& file) {
  tinyxml2::XMLDocument document;
  const tinyxml2::XMLElement* root = rootOf(file, document);
  if (root == nullptr) return {};
  std::string author;
  std::string license;
  forEachChild(*root, "author", [&](const tinyxml2::XMLElement& each) {
    add(author, textOf(each.FirstChildElement("name")));
  });
  forEachChild(*root, "license",
               [&](const tinyxml2::XMLElement& each) { add(license, textOf(&each)); });
  return namedIn(file, author, license);
}

Credit creditOfPackage(const fs::path& file) {
  tinyxml2::XMLDocument document;
  const tinyxml2::XMLElement* root = rootOf(file, document);
  if (root == nullptr) return {};
  std::string author;
  std::string license;
  for (const char* role : {"author", "maintainer"}) {
    if (!author.empty()) break;
    forEachChild(*root, role,
                 [&](const tinyxml2::XMLElement& each) { add(author, textOf(&each)); });
  }
  forEachChild(*root, "license",
               [&](const tinyxml2::XMLElement& each) { add(license, textOf(&each)); });
  return namedIn(file, author, license);
}

Credit creditOfLicenseFile(const fs::path& folder) {
  for (const char* stem : {"LICENSE", "LICENCE", "COPYING", "license", "licence"}) {
    for (const char* end : {"", ".txt", ".md", ".rst"}) {
      std::error_code ignored;
      const fs::path file = folder / (std::string(stem) + end);
      if (fs::is_regular_file(file, ignored)) return {"", {}, file.filename().string(), file};
    }
  }
  return {};
}

/// Fills in from `other` what `credit` lacks.
Credit completed(Credit credit, const Credit& other) {
  if (credit.author.empty()) {
    credit.author = other.author;
    credit.author_in = other.author_in;
  }
  if (credit.license.empty()) {
    credit.license = other.license;
    credit.license_in = other.license_in;
  }
  return credit;
}

}  // namespace

const Credit& CreditFinder::creditOfFolder(const fs::path& folder) {
  if (const auto found = folders_.find(folder); found != folders_.end()) return found->second;
  Credit credit = creditOfModelConfig(folder / "model.config");
  credit = completed(credit, creditOfPackage(folder / "package.xml"));
  credit = completed(credit, creditOfLicenseFile(folder));
  return folders_.emplace(folder, std::move(credit)).first->second;
}

Credit CreditFinder::creditOf(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Credit credit;
  if (extension == ".dae") credit = creditOfCollada(file);
  if (extension == ".gltf" || extension == ".glb") credit = creditOfGltf(file);
  fs::path folder = file.parent_path();
  for (int level = 0; level < kLevels && folder.has_relative_path(); ++level) {
    credit = completed(credit, creditOfFolder(folder));
    folder = folder.parent_path();
  }
  return credit;
}

}  // namespace synthetic_dataset::run
