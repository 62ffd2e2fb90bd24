#include "world/urdf/urdf_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tinyxml2.h>

#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

using tinyxml2::XMLElement;

void forEachElement(XMLElement& parent, const std::function<void(XMLElement&)>& visit) {
  visit(parent);
  for (XMLElement* child = parent.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    forEachElement(*child, visit);
  }
}

/// The value of `$(command argument rest)`, or nothing if only roslaunch or xacro knows it.
std::optional<std::string> resolved(const std::string& substitution) {
  const std::size_t space = substitution.find(' ');
  if (space == std::string::npos) return std::nullopt;
  const std::string command = substitution.substr(0, space);
  const std::string rest = trimmed(substitution.substr(space));
  const std::size_t end = std::min(rest.find(' '), rest.size());
  const std::string name = rest.substr(0, end);
  const bool finds = command == "find" || command == "find-pkg-share";  // of ROS 1 and of ROS 2
  if (finds && end == rest.size()) return "package://" + name;
  if (command != "env" && command != "optenv") return std::nullopt;
  if (const char* value = std::getenv(name.c_str())) return std::string(value);
  if (command == "env") return std::nullopt;
  return trimmed(rest.substr(end));
}

/// The text with each `$(...)` resolved; nothing if one cannot be.
std::optional<std::string> withoutSubstitutions(const std::string& text) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = text.find("$("); at != std::string::npos; at = text.find("$(", from)) {
    const std::size_t end = text.find(')', at);
    if (end == std::string::npos) return std::nullopt;
    const auto value = resolved(trimmed(text.substr(at + 2, end - at - 2)));
    if (!value) return std::nullopt;
    result += text.substr(from, at - from) + *value;
    from = end + 1;
  }
  return result + text.substr(from);
}

/// Prepares one URDF text for reading.
class Preparation {
 public:
  Preparation(SdfFile& file, Findings& findings) : file_(file), findings_(findings) {}

  bool run() {
    XMLElement& robot = *file_.document.RootElement();
    for (XMLElement* child = robot.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string name = child->Name();
      const bool is_read =
          name == "link" || name == "joint" || name == "material" || startsWith(name, "xacro:");
      if (!is_read) continue;  // it belongs to another program
      forEachElement(*child, [&](XMLElement& element) { checkXacro(element); });
      if (sound_) forEachElement(*child, [&](XMLElement& element) { resolveAttributes(element); });
    }
    return sound_;
  }

 private:
  std::string at(const XMLElement& element) const {
    return file_.path.string() + ": line " + std::to_string(element.GetLineNum()) + ": ";
  }

  void checkXacro(const XMLElement& element) {
    if (!sound_) return;  // one error is enough: it concerns the file as a whole
    std::string found = startsWith(element.Name(), "xacro:") ? element.Name() : "";
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      if (std::string(attribute->Value()).find("${") != std::string::npos) {
        found = attribute->Value();
      }
    }
    if (found.empty()) return;
    findings_.addError(at(element) + "'" + found +
                       "' is xacro's, which expands it if the file's name ends in "
                       ".xacro; or run 'rosrun xacro xacro robot.urdf.xacro -o "
                       "robot.urdf'");
    sound_ = false;
  }

  void resolveAttributes(XMLElement& element) {
    std::vector<std::string> unknown;
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      const std::string text = attribute->Value();
      if (text.find("$(") == std::string::npos) continue;
      const auto value = withoutSubstitutions(text);
      if (!value) {
        unknown.emplace_back(attribute->Name());
        findings_.addNote(at(element) + "<" + element.Name() + " " + attribute->Name() + "=\"" +
                          text +
                          "\">: roslaunch or xacro would have to resolve it; it is left out");
      } else {
        element.SetAttribute(attribute->Name(), value->c_str());
      }
    }
    for (const std::string& name : unknown) element.DeleteAttribute(name.c_str());
  }

  SdfFile& file_;
  Findings& findings_;
  bool sound_ = true;
};

}  // namespace

bool prepareUrdf(const SdfFile& urdf, SdfFile& prepared, Findings& findings) {
  prepared.path = urdf.path;
  readXml(urdf.text, prepared);  // which has succeeded before
  return Preparation(prepared, findings).run();
}

}  // namespace synthetic_dataset::world
