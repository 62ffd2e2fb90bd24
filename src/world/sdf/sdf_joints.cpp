#include "world/sdf/sdf_joints.h"

#include <cstddef>
#include <optional>
#include <vector>

#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

/// Nothing unless there is a link of this name; the world is not a link.
std::optional<std::size_t> findLink(const std::vector<Link>& links, const std::string& name) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].name == name) return i;
  }
  return std::nullopt;
}

/// The link that represents a whole model: its first.
std::optional<std::size_t> firstLinkOf(const std::vector<Link>& links, const std::string& model) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (startsWith(links[i].name, model + "::")) return i;
  }
  return std::nullopt;
}

bool isDescendantOf(const std::vector<Link>& links, std::size_t link, std::size_t ancestor) {
  for (std::optional<std::size_t> at = link; at; at = links[*at].parent) {
    if (*at == ancestor) return true;
  }
  return false;
}

class JointReader {
 public:
  JointReader(const ModelSource& source, const std::string& prefix, SdfReading& reading,
              Model& model)
      : source_(source), prefix_(prefix), reading_(reading), links_(model.links) {}

  bool read() {
    for (const Element& joint : source_.element.children("joint")) readJoint(joint);
    return is_held_;
  }

 private:
  void readJoint(const Element& joint) {
    const std::string parent_name = readText(joint, "parent");
    const std::string child_name = readText(joint, "child");
    const auto child = linkOf(child_name);
    const auto parent = linkOf(parent_name);
    // Either end may be the world.
    if ((child && parent_name == "world") || (parent && child_name == "world")) {
      is_held_ = true;
      return;
    }
    if (!child || !parent) {
      noteUnknown(joint, child ? parent_name : child_name);
      return;
    }
    if (links_[*child].parent || isDescendantOf(links_, *parent, *child)) return;
    links_[*child].parent = parent;
    if (joint.attribute("type") != "fixed") {
      links_[*child].moving_joint = prefix_ + joint.attribute("name");
    }
  }

  void noteUnknown(const Element& joint, const std::string& name) {
    if (source_.has_gaps) return;
    reading_.findings.addNote(locationOf(joint, source_.location),
                              "found '" + name +
                                  "', which is not a link of the model; "
                                  "the joint is left out");
  }

  /// The link that a joint means by a name, which may be that of a link, of a frame attached to
  /// one, or of a model.
  [[nodiscard]] std::optional<std::size_t> linkOf(std::string name) const {
    constexpr int kLongestChain = 100;  // of frames; there may be a cycle
    for (int i = 0; i < kLongestChain; ++i) {
      if (const auto link = findLink(links_, prefix_ + name)) return link;
      const std::string attached_to = frameNamed(name).attribute("attached_to");
      if (attached_to.empty()) break;
      name = attached_to;
    }
    return firstLinkOf(links_, prefix_ + name);
  }

  [[nodiscard]] Element frameNamed(const std::string& name) const {
    for (const Element& frame : source_.element.children("frame")) {
      if (frame.attribute("name") == name) return frame;
    }
    return {};
  }

  const ModelSource& source_;
  const std::string& prefix_;
  SdfReading& reading_;
  std::vector<Link>& links_;
  bool is_held_ = false;
};

}  // namespace

bool readJoints(const ModelSource& source, const std::string& prefix, SdfReading& reading,
                Model& model) {
  return JointReader(source, prefix, reading, model).read();
}

}  // namespace synthetic_dataset::world
