#include "world/urdf/urdf_tree.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "base/name_list.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::world {
namespace {

/// The longest chain of links; robots have dozens, and the tree is read recursively.
constexpr std::size_t kDeepestTree = 1000;

std::string quoted(const std::string& name) { return "'" + name + "'"; }

class TreeReader {
 public:
  TreeReader(const SourceLocation& location, SdfReading& reading)
      : location_(location), reading_(reading) {}

  std::optional<UrdfTree> read(const Element& robot) {
    for (const Element& link : robot.children("link")) addLink(link);
    if (tree_.links.empty()) error(robot, "has no <link>; a robot has at least one");
    for (const Element& joint : robot.children("joint")) addJoint(joint);
    if (is_sound_) findRoot(robot);
    if (is_sound_) checkConnected(robot);
    return is_sound_ ? std::optional<UrdfTree>(std::move(tree_)) : std::nullopt;
  }

 private:
  void error(const Element& element, const std::string& message) {
    reading_.findings.addError(location_.atLine(element.line()).message(message));
    is_sound_ = false;
  }

  void addLink(const Element& link) {
    const std::string name = link.attribute("name");
    if (name.empty()) return error(link, "a <link> has no name");
    if (tree_.links.emplace(name, link).second) return;
    error(link, "link '" + name + "' is there twice; each link has a name of its own");
  }

  void addJoint(const Element& element) {
    const UrdfJoint joint{element, element.attribute("name"),
                          element.child("parent").attribute("link"),
                          element.child("child").attribute("link")};
    const std::string its = "joint '" + joint.name + "'";
    if (!joints_.insert(joint.name).second) {
      return error(element, its + " is there twice; each joint has a name of its own");
    }
    if (!knows(joint.parent, its, "parent", element) ||
        !knows(joint.child, its, "child", element)) {
      return;
    }
    const auto [first, added] = joint_of_.emplace(joint.child, joint.name);
    if (!added) {
      return error(element, "link '" + joint.child + "' is the child of joint '" + first->second +
                                "' and of " + its + "; a link of a URDF can have one parent only");
    }
    std::vector<UrdfJoint>& siblings = tree_.below[joint.parent];
    const auto at = std::find_if(siblings.begin(), siblings.end(),
                                 [&](const UrdfJoint& other) { return joint.name < other.name; });
    siblings.insert(at, joint);
  }

  bool knows(const std::string& link, const std::string& joint, const std::string& role,
             const Element& element) {
    if (tree_.links.count(link) != 0) return true;
    std::vector<std::string> names;
    for (const auto& [name, content] : tree_.links) names.push_back(name);
    error(element, joint + ": its " + role +
                       (link.empty() ? " is missing"
                                     : " '" + link + "' is not a link of the robot" +
                                           didYouMean(link, names)));
    return false;
  }

  void findRoot(const Element& robot) {
    std::vector<std::string> roots;
    for (const auto& [name, link] : tree_.links) {
      if (joint_of_.count(name) == 0) roots.push_back(quoted(name));
    }
    if (roots.size() == 1) {
      tree_.root = roots.front().substr(1, roots.front().size() - 2);
    } else if (roots.empty()) {
      error(robot, "all links have parents, forming a loop; one has to be the root");
    } else {
      constexpr std::size_t kMost = 5;
      error(robot, "the links " + base::listed(roots, kMost) +
                       " have no parent; a robot has one root, and joints hold all other links");
    }
  }

  /// Level by level instead of recursively, as a file can have a chain of any length.
  void checkConnected(const Element& robot) {
    std::set<std::string> reached{tree_.root};
    std::vector<std::string> level{tree_.root};
    std::size_t depth = 0;
    for (; !level.empty(); ++depth) {
      std::vector<std::string> next;
      for (const std::string& parent : level) {
        for (const UrdfJoint& joint : tree_.below[parent]) next.push_back(joint.child);
      }
      reached.insert(next.begin(), next.end());
      level = std::move(next);
    }
    if (depth > kDeepestTree) {
      error(robot, "a chain of " + std::to_string(depth) +
                       " links, each on the one before it; at most " +
                       std::to_string(kDeepestTree) + " can be read");
    }
    std::vector<std::string> loop;
    for (const auto& [name, link] : tree_.links) {
      if (reached.count(name) == 0) loop.push_back(quoted(name));
    }
    if (loop.empty()) return;
    error(robot, "the links " + base::listed(loop) + " form a loop apart from the root link '" +
                     tree_.root + "'");
  }

  const SourceLocation& location_;
  SdfReading& reading_;
  UrdfTree tree_;
  std::set<std::string> joints_;
  std::map<std::string, std::string> joint_of_;  ///< the joint that holds each link
  bool is_sound_ = true;
};

}  // namespace

std::optional<UrdfTree> readUrdfTree(const Element& robot, const SourceLocation& location,
                                     SdfReading& reading) {
  return TreeReader(location, reading).read(robot);
}

}  // namespace synthetic_dataset::world
