#include "world/sdf/joined_models.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string>
#include <system_error>

#include <sdf/sdf_config.h>
#include <tinyxml2.h>

#include "world/sdf/xml_text.h"

namespace synthetic_dataset::world {
namespace {

using tinyxml2::XMLElement;

/// Of all copies together [byte].
constexpr std::uintmax_t kMostText = std::uintmax_t{16} << 20U;

std::string versionOf(const XMLElement& root) {
  const char* version = root.Attribute("version");
  return version != nullptr ? version : "";
}

/// What SDF up to 1.7 has of models within models, and later versions as scopes.
bool hasScopes(const XMLElement& element) {
  const char* name = element.Attribute("name");
  if (name != nullptr && std::string(name).find("::") != std::string::npos) return true;
  for (const auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (hasScopes(*child)) return true;
  }
  return false;
}

/// What readers may take for a part of a name, or not.
bool isClear(const std::string& name) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  return name.find("::") == std::string::npos &&
         (name.empty() || !(is_blank(name.front()) || is_blank(name.back())));
}

/// Whether an include says no more than where, what, how it is called and whether it stands still.
bool isPlain(const XMLElement& include) {
  if (include.FirstAttribute() != nullptr) return false;
  std::array<int, 4> counts{};
  constexpr std::array<const char*, 4> kKnown = {"uri", "name", "pose", "static"};
  for (const auto* child = include.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const auto* const known = std::find(kKnown.begin(), kKnown.end(), std::string(child->Name()));
    if (known == kKnown.end() || child->FirstAttribute() != nullptr) return false;
    if (textOf(child).empty() || child->FirstChildElement() != nullptr) return false;
    if (++counts.at(static_cast<std::size_t>(known - kKnown.begin())) > 1) return false;
  }
  return isClear(textOf(include.FirstChildElement("name")));
}

/// Whether what an include may override is right: of a fault in it libsdformat would tell.
bool isSoundPose(const XMLElement* pose) {
  if (pose == nullptr) return true;
  std::istringstream text(textOf(pose));
  text.imbue(std::locale::classic());
  int numbers = 0;
  for (double each = 0.0; text >> each;) ++numbers;
  // A pose without numbers is the origin; one with attributes may be in a frame of the file's.
  return pose->FirstAttribute() == nullptr && text.eof() && (numbers == 6 || numbers == 0);
}

bool isSoundSwitch(const XMLElement* element) {
  bool value = false;
  return element == nullptr || element->QueryBoolText(&value) == tinyxml2::XML_SUCCESS;
}

/// The model that a file holds alone, or null.
const XMLElement* loneModel(const XMLElement& root) {
  const XMLElement* model = root.FirstChildElement();
  const bool is_lone = model != nullptr && model->NextSiblingElement() == nullptr;
  if (!is_lone || std::string(model->Name()) != "model") return nullptr;
  const char* name = model->Attribute("name");
  const bool is_sound = name != nullptr && *name != '\0' &&
                        isSoundPose(model->FirstChildElement("pose")) &&
                        isSoundSwitch(model->FirstChildElement("static"));
  return is_sound && !hasScopes(*model) ? model : nullptr;
}

/// The model in the place of its own element of this name, if it has one.
void override(XMLElement& model, const XMLElement& include, const char* name) {
  const XMLElement* given = include.FirstChildElement(name);
  if (given == nullptr) return;
  while (XMLElement* own = model.FirstChildElement(name)) model.DeleteChild(own);
  model.InsertFirstChild(given->DeepClone(model.GetDocument()));
}

void replace(XMLElement& include, const XMLElement& model, const std::filesystem::path& file) {
  XMLElement* joined = model.DeepClone(include.GetDocument())->ToElement();
  const std::string name = textOf(include.FirstChildElement("name"));
  if (!name.empty()) joined->SetAttribute("name", name.c_str());
  override(*joined, include, "pose");
  override(*joined, include, "static");
  joined->SetAttribute(kJoinedFrom, file.c_str());
  include.Parent()->InsertAfterChild(&include, joined);
}

}  // namespace

bool joinModels(XMLElement& root,
                const std::function<IncludedFile(const std::filesystem::path&)>& included) {
  XMLElement* world = root.FirstChildElement("world");
  // Older ones drop attributes that are not SDF's.
  if (SDF_MAJOR_VERSION < 11 || world == nullptr) return false;
  bool any = false;
  std::uintmax_t size = 0;
  XMLElement* next = nullptr;
  for (XMLElement* include = world->FirstChildElement("include"); include != nullptr;
       include = next) {
    next = include->NextSiblingElement("include");
    if (!isPlain(*include)) continue;
    const std::filesystem::path copy = textOf(include->FirstChildElement("uri"));
    const IncludedFile from = included(copy);
    const XMLElement* model = from.root != nullptr ? loneModel(*from.root) : nullptr;
    if (model == nullptr || versionOf(*from.root) != versionOf(root)) continue;
    std::error_code unknown;
    size += std::filesystem::file_size(copy, unknown);
    if (unknown || size > kMostText) break;
    replace(*include, *model, from.file);
    world->DeleteChild(include);
    any = true;
  }
  return any;
}

}  // namespace synthetic_dataset::world
