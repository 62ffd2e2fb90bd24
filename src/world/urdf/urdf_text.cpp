#include "world/urdf/urdf_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include <tinyxml2.h>

#include "base/input_file.h"
#include "base/xml_text.h"
#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

using tinyxml2::XMLElement;

/// Links below one another; robots have dozens, and what reads their tree calls itself for each.
constexpr std::size_t kDeepestTree = 1000;

std::string valueOf(const XMLElement& element, const char* attribute) {
  const char* value = element.Attribute(attribute);
  return value == nullptr ? "" : value;
}

void forEachElement(XMLElement& parent, const std::function<void(XMLElement&)>& visit) {
  visit(parent);
  for (XMLElement* child = parent.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    forEachElement(*child, visit);
  }
}

/// What `$(command argument rest)` means, or nothing where only roslaunch or xacro knows.
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

/// The text with each `$(...)` resolved; nothing where one cannot be.
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

/// How many links hang below one another at most, by the longest way where there are several.
/// Links in a loop and below it do not count.
std::size_t depthOf(const XMLElement& robot) {
  std::map<std::string, std::vector<std::string>> children;
  std::map<std::string, std::size_t> open_parents;
  for (const XMLElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const XMLElement* parent = joint->FirstChildElement("parent");
    const XMLElement* child = joint->FirstChildElement("child");
    if (parent == nullptr || child == nullptr) continue;
    children[valueOf(*parent, "link")].push_back(valueOf(*child, "link"));
    ++open_parents[valueOf(*child, "link")];
  }
  std::vector<std::string> level;
  for (const auto& [parent, below] : children) {
    if (open_parents.count(parent) == 0) level.push_back(parent);
  }
  std::size_t depth = 0;
  for (; !level.empty(); ++depth) {
    std::vector<std::string> next;
    for (const std::string& parent : level) {
      for (const std::string& child : children[parent]) {
        if (--open_parents[child] == 0) next.push_back(child);
      }
    }
    level = std::move(next);
  }
  return depth;
}

/// Makes one URDF text readable for urdfdom.
class Preparation {
 public:
  Preparation(const ModelText& model, Findings& findings) : model_(model), findings_(findings) {}

  std::optional<UrdfText> run() {
    if (const auto fault = base::parseXml(document_, model_.text)) {
      const std::string of_text = base::textFault(model_.text);
      addError(fault->line,
               of_text.empty() ? "cannot be read as XML (" + fault->reason + ")" : of_text);
      return std::nullopt;
    }
    XMLElement& robot = *document_.RootElement();
    dropOtherPrograms(robot);
    forEachElement(robot, [&](XMLElement& element) { checkXacro(element); });
    if (!sound_) return std::nullopt;
    forEachElement(robot, [&](XMLElement& element) { resolveAttributes(element); });
    dropUnknownMaterials(robot);
    checkDepth(robot);
    if (!sound_) return std::nullopt;
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    result_.text = printer.CStr();
    return std::move(result_);
  }

 private:
  void addError(int line, const std::string& message) {
    findings_.addError(model_.name + ": line " + std::to_string(line) + ": " + message);
    sound_ = false;
  }

  /// What stands below <robot> and is neither link nor joint nor material.
  void dropOtherPrograms(XMLElement& robot) {
    XMLElement* next = nullptr;
    for (XMLElement* child = robot.FirstChildElement(); child != nullptr; child = next) {
      next = child->NextSiblingElement();
      const std::string name = child->Name();
      if (name == "gazebo") noteGazeboMaterial(*child);
      const bool is_robots = name == "link" || name == "joint" || name == "material";
      if (!is_robots && !startsWith(name, "xacro:")) robot.DeleteChild(child);
    }
  }

  void noteGazeboMaterial(const XMLElement& gazebo) {
    const XMLElement* material = gazebo.FirstChildElement("material");
    const std::string link = valueOf(gazebo, "reference");
    if (material == nullptr || material->GetText() == nullptr || link.empty()) return;
    result_.gazebo_materials[link] = trimmed(material->GetText());
  }

  void checkXacro(const XMLElement& element) {
    if (!sound_) return;  // one is enough: the file as a whole is meant
    std::string found = startsWith(element.Name(), "xacro:") ? element.Name() : "";
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      if (std::string(attribute->Value()).find("${") != std::string::npos) {
        found = attribute->Value();
      }
    }
    if (found.empty()) return;
    addError(element.GetLineNum(),
             "'" + found +
                 "' is xacro's, which expands it where the file's name ends in "
                 ".xacro; or run 'rosrun xacro xacro robot.urdf.xacro -o "
                 "robot.urdf'");
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
        findings_.addNote(model_.name + ": line " + std::to_string(element.GetLineNum()) + ": <" +
                          element.Name() + " " + attribute->Name() + "=\"" + text +
                          "\">: roslaunch or xacro would have to resolve it; it is left out");
      } else {
        element.SetAttribute(attribute->Name(), value->c_str());
      }
    }
    for (const std::string& name : unknown) element.DeleteAttribute(name.c_str());
  }

  /// urdfdom (up to 3.0) goes on with a model that it has thrown away when a material is unknown.
  /// A visual that names one has the default colour, as in RViz.
  void dropUnknownMaterials(XMLElement& robot) {
    std::set<std::string> defined;
    forEachElement(robot, [&](XMLElement& element) {
      const bool has_content =
          element.FirstChildElement("color") != nullptr || element.FirstChildElement("texture");
      if (std::string(element.Name()) == "material" && has_content) {
        defined.insert(valueOf(element, "name"));
      }
    });
    std::map<std::string, std::vector<std::string>> unknown;  // where, by name
    for (XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      for (XMLElement* visual = link->FirstChildElement("visual"); visual != nullptr;
           visual = visual->NextSiblingElement("visual")) {
        XMLElement* material = visual->FirstChildElement("material");
        if (material == nullptr) continue;
        const std::string name = valueOf(*material, "name");
        const bool left_empty = name.empty() && material->NoChildren();  // SolidWorks' exporter
        if (!left_empty && defined.count(name) > 0) continue;
        if (!left_empty) {
          unknown[name].push_back("line " + std::to_string(material->GetLineNum()) + ": link '" +
                                  valueOf(*link, "name") + "'");
        }
        visual->DeleteChild(material);
      }
    }
    for (const auto& [name, places] : unknown) noteUnknownMaterial(name, places);
  }

  void noteUnknownMaterial(const std::string& name, const std::vector<std::string>& places) {
    const std::string more =
        places.size() > 1 ? " (and of " + std::to_string(places.size() - 1) + " more visuals)" : "";
    findings_.addNote(model_.name + ": " + places.front() + more + ": the material '" + name +
                      "' is defined nowhere; drawn in the default colour (give it a <color> or a "
                      "<texture>)");
  }

  void checkDepth(const XMLElement& robot) {
    const std::size_t depth = depthOf(robot);
    if (depth <= kDeepestTree) return;
    addError(robot.GetLineNum(), "a chain of " + std::to_string(depth) +
                                     " links, each on the one before it; at most " +
                                     std::to_string(kDeepestTree) + " can be read");
  }

  const ModelText& model_;
  Findings& findings_;
  tinyxml2::XMLDocument document_;
  UrdfText result_;
  bool sound_ = true;
};

}  // namespace

std::optional<UrdfText> prepareUrdf(const ModelText& model, Findings& findings) {
  return Preparation(model, findings).run();
}

}  // namespace synthetic_dataset::world
