#include "world/sdf/stand_in_model.h"

#include <string>

#include <tinyxml2.h>

#include "world/files/fuel.h"
#include "world/sdf/include_graph.h"
#include "world/sdf/xml_text.h"

namespace synthetic_dataset::world {
namespace {

using tinyxml2::XMLElement;

/// The name that an include gives its model, else the one that its URI leads to expect.
std::string nameOf(const XMLElement& include) {
  const std::string given = textOf(include.FirstChildElement("name"));
  if (!given.empty()) return given;
  const std::string uri = textOf(include.FirstChildElement("uri"));
  if (const auto fuel = parseFuelUri(uri)) return fuel->name;
  const std::size_t end = uri.find_last_not_of('/') + 1;
  const std::size_t slash = uri.substr(0, end).rfind('/');
  return uri.substr(slash + 1, end - slash - 1);
}

/// Whether SDF allows the name for a model (names reserved: "__x__"; scopes: "a::b").
bool isUsable(const std::string& name) {
  return !name.empty() && name.rfind("__", 0) != 0 && name.find("::") == std::string::npos &&
         name != "world";
}

bool isTaken(const std::string& name, const XMLElement& include) {
  const auto* parent = include.Parent()->ToElement();
  for (const auto* each = parent->FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    if (each == &include) continue;
    const char* attribute = each->Attribute("name");
    if (attribute != nullptr && attribute == name) return true;
    if (std::string(each->Name()) == "include" && nameOf(*each) == name) return true;
  }
  return false;
}

bool isJointOf(const XMLElement& joint, const std::string& name) {
  for (const char* end : {"parent", "child"}) {
    const XMLElement* element = joint.FirstChildElement(end);
    const char* attribute = element != nullptr ? element->Attribute("link") : nullptr;
    const std::string link = attribute != nullptr ? attribute : textOf(element);
    if (link.rfind(name + "::", 0) == 0) return true;
  }
  return false;
}

void removeJoints(XMLElement& parent, const std::string& name) {
  XMLElement* next = nullptr;
  for (auto* joint = parent.FirstChildElement("joint"); joint != nullptr; joint = next) {
    next = joint->NextSiblingElement("joint");
    if (isJointOf(*joint, name)) parent.DeleteChild(joint);
  }
}

XMLElement& addChild(XMLElement& parent, const char* name) {
  XMLElement* child = parent.GetDocument()->NewElement(name);
  parent.InsertEndChild(child);
  return *child;
}

}  // namespace

void replaceByStandIn(XMLElement& include) {
  XMLElement& parent = *include.Parent()->ToElement();
  const std::string name = nameOf(include);
  const bool merged = include.BoolAttribute("merge");
  const bool taken = isTaken(name, include);
  if (!taken) removeJoints(parent, name);
  if (isUsable(name) && !merged && !taken) {
    XMLElement* model = parent.GetDocument()->NewElement("model");
    model->SetAttribute("name", name.c_str());
    parent.InsertAfterChild(&include, model);
    addChild(*model, "static").SetText(true);
    addChild(*model, "link").SetAttribute("name", kStandInLink);
    XMLElement* pose = include.FirstChildElement("pose");
    if (pose != nullptr) model->InsertEndChild(pose);
  }
  parent.DeleteChild(&include);
}

}  // namespace synthetic_dataset::world
