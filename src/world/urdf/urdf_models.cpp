#include "world/urdf/urdf_models.h"

#include <cmath>
#include <utility>

#include "world/material/gazebo_materials.h"
#include "world/urdf/urdf_document.h"

namespace synthetic_dataset::world {
namespace {

/// Where a joint that mimics another stands when that one is at 0; identity for all others.
Pose restDisplacement(const urdf::Joint& joint, const SourceLocation& location,
                      UrdfReading& reading) {
  if (!joint.mimic) return Pose::Identity();
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  const double offset = joint.mimic->offset;
  if (!std::isfinite(offset) || !axis.allFinite()) {
    reading.findings.addError(
        location.message("its <mimic> or <axis> has a number that is not "
                         "finite"));
    return Pose::Identity();
  }
  if (joint.type == urdf::Joint::PRISMATIC) {
    return makePose(offset * axis.normalized(), Eigen::Quaterniond::Identity());
  }
  if (joint.type != urdf::Joint::REVOLUTE && joint.type != urdf::Joint::CONTINUOUS) {
    return Pose::Identity();
  }
  return makePose({0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(offset, axis.normalized())));
}

/// None where it is not one of an axis.
std::optional<JointMotion> motionOf(const urdf::Joint& joint) {
  const bool slides = joint.type == urdf::Joint::PRISMATIC;
  const bool turns = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  if ((!slides && !turns) || !axis.allFinite() || axis.norm() == 0.0) return std::nullopt;
  JointMotion motion;
  motion.slides = slides;
  motion.axis_L = axis.normalized();
  if (joint.mimic) {
    const urdf::JointMimic& mimic = *joint.mimic;
    motion.mimic = JointMotion::Mimic{mimic.joint_name, mimic.multiplier, mimic.offset};
    motion.rest = mimic.offset;
  }
  return motion;
}

/// The file's inertia if it is one that a body can have.
std::optional<Inertia> readInertia(const urdf::Link& link, const SourceLocation& location,
                                   UrdfReading& reading) {
  if (!link.inertial) return std::nullopt;
  const urdf::Inertial& from = *link.inertial;
  const Pose X_LI = toPose(from.origin, location.in("inertial", ""), reading);
  Eigen::Matrix3d moments_I;
  moments_I << from.ixx, from.ixy, from.ixz, from.ixy, from.iyy, from.iyz, from.ixz, from.iyz,
      from.izz;
  if (!(from.mass > 0.0) || !std::isfinite(from.mass) || !moments_I.allFinite()) {
    return std::nullopt;
  }
  Inertia inertia;
  inertia.mass = from.mass;
  inertia.centre_of_mass_L = X_LI.translation();
  inertia.moments_L = X_LI.linear() * moments_I * X_LI.linear().transpose();
  return inertia;
}

std::string nameOr(const std::string& name, std::size_t index) {
  return name.empty() ? std::to_string(index + 1) : name;
}

/// Gathers the links of a tree, parents before children.
class LinkReader {
 public:
  LinkReader(const UrdfDocument& document, const SourceLocation& location, UrdfReading& reading)
      : document_(document), location_(location), reading_(reading) {}

  void read(const urdf::Link& from, std::optional<std::size_t> parent, const Pose& X_ML) {
    Link link;
    link.name = from.name;
    link.X_ML = X_ML;
    link.parent = parent;
    if (from.parent_joint && from.parent_joint->type != urdf::Joint::FIXED) {
      link.moving_joint = from.parent_joint->name;
      link.joint_motion = motionOf(*from.parent_joint);
    }
    const SourceLocation here = location_.in("link", from.name);
    link.inertia = readInertia(from, here, reading_);
    readShapes(from, here, link);
    const std::size_t index = links.size();
    links.push_back(std::move(link));
    for (const urdf::LinkSharedPtr& child : from.child_links) {
      const urdf::Joint& joint = *child->parent_joint;
      const SourceLocation there = location_.in("joint", joint.name);
      const Pose X_PJ = toPose(joint.parent_to_joint_origin_transform, there, reading_);
      read(*child, index, X_ML * X_PJ * restDisplacement(joint, there, reading_));
    }
  }

  std::vector<Link> links;

 private:
  void readShapes(const urdf::Link& from, const SourceLocation& location, Link& link) {
    const std::optional<Material> gazebo_material = gazeboMaterialOf(from.name, location);
    for (std::size_t i = 0; i < from.visual_array.size(); ++i) {
      const urdf::Visual& visual = *from.visual_array[i];
      auto read =
          readUrdfVisual(visual, nameOr(visual.name, i), gazebo_material, location, reading_);
      if (read && !read->surfaces.empty()) link.visuals.push_back(std::move(*read));
    }
    for (std::size_t i = 0; i < from.collision_array.size(); ++i) {
      const urdf::Collision& collision = *from.collision_array[i];
      auto read = readUrdfCollision(collision, nameOr(collision.name, i), location, reading_);
      if (read) link.collisions.push_back(std::move(*read));
    }
  }

  /// What Gazebo shows a link in; names that only a robot's own scripts know leave the choice to
  /// the URDF.
  [[nodiscard]] std::optional<Material> gazeboMaterialOf(const std::string& link,
                                                         const SourceLocation& location) const {
    const auto name = document_.gazebo_materials.find(link);
    if (name == document_.gazebo_materials.end()) return std::nullopt;
    std::optional<Material> material = gazeboMaterial(name->second, reading_.meshes.textures());
    if (!material) {
      reading_.findings.addNote(location, "Gazebo ships no material '" + name->second +
                                              "', which <gazebo> names for it; shown as without" +
                                              nearGazeboMaterial(name->second));
    }
    return material;
  }

  const UrdfDocument& document_;
  const SourceLocation& location_;
  UrdfReading& reading_;
};

/// A robot whose parts all lie on their sides is hard to explain otherwise.
void noteYUp(const Model& model, const SourceLocation& location, UrdfReading& reading) {
  if (model.links.size() < 2 || reading.y_up_meshes.empty()) return;
  const std::size_t more = reading.y_up_meshes.size() - 1;
  reading.findings.addNote(
      location,
      "mesh '" + *reading.y_up_meshes.begin() + "'" +
          (more > 0 ? " and " + std::to_string(more) + " more say" : " says") +
          " in COLLADA that y points up; drawn as Gazebo and RViz do, which do not turn it");
}

}  // namespace

Model readUrdfModel(UrdfReading& reading) {
  Model model;
  const UrdfDocument document = readUrdf(reading.source, reading.findings);
  if (!document.robot) return model;
  model.name = document.robot->getName();
  const SourceLocation location(reading.source.name);
  LinkReader reader(document, location, reading);
  reader.read(*document.robot->getRoot(), std::nullopt, Pose::Identity());
  model.links = std::move(reader.links);
  noteYUp(model, location, reading);
  return model;
}

}  // namespace synthetic_dataset::world
