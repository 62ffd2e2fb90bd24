#include "world/urdf/urdf_document.h"

#include <exception>
#include <set>
#include <utility>

#include <urdf_parser/urdf_parser.h>

namespace synthetic_dataset::world {
namespace {

/// urdfdom's reasons, in the order in which it gave them; the later ones only say what failed for
/// the earlier.
std::string joined(const std::vector<std::string>& reasons) {
  std::string text;
  for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
  return text.empty() ? "urdfdom cannot read it" : text;
}

/// What urdfdom has thrown away of a robot that it gives all the same. Of an element it says what
/// is wrong, then "Could not parse visual element for Link [a]"; what follows in that link goes as
/// well. Of a material it says nothing more, and goes on without its colour.
void reportLosses(const std::vector<std::string>& reasons, const std::string& name,
                  Findings& findings) {
  const auto startsWith = [](const std::string& reason, const std::string& start) {
    return reason.rfind(start, 0) == 0;
  };
  std::vector<std::string> causes;
  const auto report = [&] {
    if (!causes.empty() && startsWith(causes.back(), "Material")) {
      findings.addNote(name + ": " + joined(causes) + "; drawn in the default colour");
    } else if (!causes.empty()) {
      findings.addMissing(name + ": " + joined(causes));
    }
    causes.clear();
  };
  for (const std::string& reason : reasons) {
    const bool of_material = startsWith(reason, "Material");
    if (!causes.empty() && startsWith(causes.back(), "Material") != of_material) report();
    causes.push_back(reason);
    if (startsWith(reason, "Could not parse")) report();
  }
  report();
}

/// Null, with the error reported, where urdfdom refuses the text.
urdf::ModelInterfaceSharedPtr parse(const std::string& text, const std::string& name,
                                    Findings& findings) {
  const UrdfConsole console;
  std::vector<std::string> reasons;
  try {
    urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(text);
    if (robot && robot->getRoot()) {
      reportLosses(console.errors(), name, findings);
      return robot;
    }
  } catch (const std::exception& error) {
    reasons.emplace_back(error.what());
  }
  const std::vector<std::string> errors = console.errors();
  reasons.insert(reasons.end(), errors.begin(), errors.end());
  findings.addError(name + ": " + joined(reasons));
  return nullptr;
}

/// Whether every link has at most one parent; links that hang on two are reported.
bool hasOneParentEach(const urdf::ModelInterface& robot, const std::string& name,
                      Findings& findings) {
  bool sound = true;
  std::map<std::string, std::string> joint_of;
  for (const auto& [joint, content] : robot.joints_) {
    const auto [first, added] = joint_of.emplace(content->child_link_name, joint);
    if (added) continue;
    findings.addError(name + ": link '" + content->child_link_name + "' is the child of joint '" +
                      first->second + "' and of joint '" + joint +
                      "'; a link of a URDF can have one parent only");
    sound = false;
  }
  return sound;
}

void gatherBelow(const urdf::Link& link, std::set<std::string>& names) {
  names.insert(link.name);
  for (const urdf::LinkSharedPtr& child : link.child_links) gatherBelow(*child, names);
}

/// Whether all links hang on the root; those in a loop of their own are reported.
bool isTree(const urdf::ModelInterface& robot, const std::string& name, Findings& findings) {
  std::set<std::string> reached;
  gatherBelow(*robot.getRoot(), reached);
  std::string loop;
  for (const auto& [link, content] : robot.links_) {
    if (reached.count(link) == 0) loop += (loop.empty() ? "'" : ", '") + link + "'";
  }
  if (loop.empty()) return true;
  findings.addError(name + ": the links " + loop +
                    " hang on one another in a loop, and not on the root link '" +
                    robot.getRoot()->name + "'");
  return false;
}

}  // namespace

UrdfConsole::UrdfConsole() : handler_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

UrdfConsole::~UrdfConsole() { console_bridge::useOutputHandler(handler_); }

void UrdfConsole::log(const std::string& text, console_bridge::LogLevel level, const char*, int) {
  if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) errors_.push_back(text);
}

UrdfDocument readUrdf(const ModelText& model, Findings& findings) {
  std::optional<UrdfText> prepared = prepareUrdf(model, findings);
  if (!prepared) return {};
  UrdfDocument document;
  document.robot = parse(prepared->text, model.name, findings);
  document.gazebo_materials = std::move(prepared->gazebo_materials);
  if (document.robot && !(hasOneParentEach(*document.robot, model.name, findings) &&
                          isTree(*document.robot, model.name, findings))) {
    document.robot.reset();
  }
  return document;
}

}  // namespace synthetic_dataset::world
