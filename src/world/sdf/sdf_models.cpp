#include "world/sdf/sdf_models.h"

#include <optional>
#include <string>
#include <utility>

#include <sdf/Joint.hh>
#include <sdf/Link.hh>

#include "world/sdf/include_graph.h"
#include "world/sdf/sdf_cameras.h"
#include "world/sdf/sdf_collisions.h"
#include "world/sdf/sdf_document.h"
#include "world/sdf/sdf_lights.h"
#include "world/sdf/sdf_visuals.h"

namespace synthetic_dataset::world {
namespace {

/// The file's inertia if it is one that a body can have.
std::optional<Inertia> readInertia(const sdf::Link& link, const Place& place, SdfReading& reading) {
  if (!has(link.Element(), "inertial")) return std::nullopt;
  const auto& from = link.Inertial();
  if (!from.MassMatrix().IsValid()) {
    reading.findings.addNote(
        place.message("its <inertial> is not that of a solid body; its collision shapes count"));
    return std::nullopt;
  }
  Inertia inertia;
  inertia.mass = from.MassMatrix().Mass();
  inertia.centre_of_mass_L = toEigen(from.Pose().Pos());
  const auto moments = from.Moi();
  for (unsigned row = 0; row < 3; ++row) {
    for (unsigned column = 0; column < 3; ++column) {
      inertia.moments_L(row, column) = moments(row, column);
    }
  }
  return inertia;
}

/// The links that a joint connects; each may be named by way of a frame.
std::string parentLinkOf(const sdf::Joint& joint) {
#if SDF_MAJOR_VERSION >= 12
  std::string name;
  return joint.ResolveParentLink(name).empty() ? name : joint.ParentLinkName();
#else
  return joint.ParentLinkName();
#endif
}

std::string childLinkOf(const sdf::Joint& joint) {
#if SDF_MAJOR_VERSION >= 12
  std::string name;
  return joint.ResolveChildLink(name).empty() ? name : joint.ChildLinkName();
#else
  return joint.ChildLinkName();
#endif
}

/// Gathers a model and the models nested in it.
class ModelReader {
 public:
  explicit ModelReader(SdfReading& reading) : reading_(reading) {}

  /// @param prefix  of the names of the links: "" or "child::"
  void read(const sdf::Model& model, const Pose& X_MN, const std::string& prefix,
            const Place& place) {
    for (std::size_t i = 0; i < model.LinkCount(); ++i) {
      readLink(*model.LinkByIndex(i), X_MN, prefix, place);
    }
    for (std::size_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& nested = *model.ModelByIndex(i);
      if (isStandIn(nested)) continue;
      const Place there = place.inFile(fileOf(nested.Element())).in("model", nested.Name());
      read(nested, X_MN * resolve(nested.SemanticPose(), there, reading_),
           prefix + nested.Name() + "::", there);
    }
    // Joints may hold links of nested models, so these come first.
    for (std::size_t i = 0; i < model.JointCount(); ++i) readJoint(*model.JointByIndex(i), prefix);
  }

  ModelContents contents;

 private:
  void readLink(const sdf::Link& from, const Pose& X_MN, const std::string& prefix,
                const Place& place) {
    const Place here = place.in("link", from.Name());
    Link link;
    link.name = prefix + from.Name();
    link.X_ML = X_MN * resolve(from.SemanticPose(), here, reading_);
    link.inertia = readInertia(from, here, reading_);
    for (std::size_t i = 0; i < from.VisualCount(); ++i) {
      if (auto visual = readVisual(*from.VisualByIndex(i), here, reading_)) {
        link.visuals.push_back(std::move(*visual));
      }
    }
    for (std::size_t i = 0; i < from.CollisionCount(); ++i) {
      if (auto collision = readCollision(*from.CollisionByIndex(i), here, reading_)) {
        link.collisions.push_back(std::move(*collision));
      }
    }
    readAttached(from, link, here);
    contents.model.links.push_back(std::move(link));
  }

  void readAttached(const sdf::Link& from, const Link& link, const Place& place) {
    const std::string scope = contents.model.name + "::" + link.name + "::";
    const Pose X_WL = contents.model.X_WM * link.X_ML;
    for (std::size_t i = 0; i < from.LightCount(); ++i) {
      const sdf::Light& light = *from.LightByIndex(i);
      const Pose X_LQ = resolve(light.SemanticPose(), place.in("light", light.Name()), reading_);
      contents.lights.push_back(
          readLight(light, scope + light.Name(), X_WL * X_LQ, place, reading_));
    }
    for (std::size_t i = 0; i < from.SensorCount(); ++i) {
      const sdf::Sensor& sensor = *from.SensorByIndex(i);
      auto camera = readCamera(sensor, scope + sensor.Name(), X_WL, place, reading_);
      if (!camera) continue;
      camera->link = link.name;
      contents.cameras.push_back(std::move(*camera));
    }
  }

  /// A link has one parent; where joints close a loop, the first of them counts.
  void readJoint(const sdf::Joint& joint, const std::string& prefix) {
    const auto child = findLink(prefix + childLinkOf(joint));
    const auto parent = findLink(prefix + parentLinkOf(joint));
    if (!child || !parent || links()[*child].parent || hangsOn(*parent, *child)) return;
    links()[*child].parent = parent;
    if (joint.Type() != sdf::JointType::FIXED) {
      links()[*child].moving_joint = prefix + joint.Name();
    }
  }

  /// Nothing for the world, to which a joint may hold a link too.
  [[nodiscard]] std::optional<std::size_t> findLink(const std::string& name) {
    for (std::size_t i = 0; i < links().size(); ++i) {
      if (links()[i].name == name) return i;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool hangsOn(std::size_t link, std::size_t ancestor) {
    for (std::optional<std::size_t> at = link; at; at = links()[*at].parent) {
      if (*at == ancestor) return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<Link>& links() { return contents.model.links; }

  SdfReading& reading_;
};

}  // namespace

bool isStandIn(const sdf::Model& model) {
  return model.LinkCount() == 1 && model.LinkByIndex(0)->Name() == kStandInLink;
}

ModelContents readModel(const sdf::Model& model, const Pose& X_WM, const Place& place,
                        SdfReading& reading) {
  const Place here = place.inFile(fileOf(model.Element())).in("model", model.Name());
  ModelReader reader(reading);
  reader.contents.model.name = model.Name();
  reader.contents.model.X_WM = X_WM;
  reader.contents.model.is_static = model.Static();
  reader.read(model, Pose::Identity(), "", here);
  for (std::size_t i = 0; !model.Static() && i < model.LinkCount(); ++i) {
    const sdf::Link& link = *model.LinkByIndex(i);
    noteHulls(link, here.in("link", link.Name()), reading);
  }
  return std::move(reader.contents);
}

}  // namespace synthetic_dataset::world
