#include "world/sdf/mentioned_meshes.h"

#include <utility>

#include <tinyxml2.h>

#include "world/sdf/xml_text.h"

namespace synthetic_dataset::world {
namespace {

bool isCalled(const tinyxml2::XMLElement* element, const std::string& name) {
  return element != nullptr && element->Name() == name;
}

/// Whether the mesh is a visual's that has no material.
bool showsPictures(const tinyxml2::XMLElement& mesh) {
  const tinyxml2::XMLNode* geometry = mesh.Parent();
  const tinyxml2::XMLNode* above = geometry != nullptr ? geometry->Parent() : nullptr;
  const tinyxml2::XMLElement* visual = above != nullptr ? above->ToElement() : nullptr;
  return isCalled(visual, "visual") && visual->FirstChildElement("material") == nullptr;
}

}  // namespace

std::vector<MentionedMesh> mentionedMeshes(const tinyxml2::XMLElement& element,
                                           const std::filesystem::path& folder) {
  std::vector<MentionedMesh> meshes;
  if (isCalled(&element, "mesh")) {
    const std::string uri = textOf(element.FirstChildElement("uri"));
    if (!uri.empty()) meshes.push_back({uri, folder, showsPictures(element)});
    return meshes;
  }
  for (const auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    for (MentionedMesh& each : mentionedMeshes(*child, folder)) meshes.push_back(std::move(each));
  }
  return meshes;
}

}  // namespace synthetic_dataset::world
