#include "world/urdf/urdf_models.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "world/material/gazebo_materials.h"
#include "world/sdf/sdf_cameras.h"
#include "world/sdf/sdf_lidars.h"
#include "world/sdf/sdf_materials.h"
#include "world/sdf/sdf_values.h"
#include "world/urdf/urdf_text.h"
#include "world/urdf/urdf_tree.h"
#include "world/urdf/urdf_visuals.h"

namespace synthetic_dataset::world {
namespace {

/// A number given as an attribute of an element.
double numberOf(const Element& element, const char* name, double fallback,
                const SourceLocation& location, SdfReading& reading) {
  return readNumber(element, name, fallback, location, reading);
}

/// The motion of a joint with one axis; nothing for all others.
std::optional<JointMotion> motionOf(const Element& joint, const SourceLocation& location,
                                    SdfReading& reading) {
  const std::string type = joint.attribute("type");
  const bool slides = type == "prismatic";
  if (!slides && type != "revolute" && type != "continuous") return std::nullopt;
  const Eigen::Vector3d axis = readVector(joint.child("axis"), "xyz", {1, 0, 0}, location, reading);
  if (axis.norm() == 0.0) return std::nullopt;
  JointMotion motion;
  motion.slides = slides;
  motion.axis_L = axis.normalized();
  if (const Element mimic = joint.child("mimic")) {
    motion.mimic = JointMotion::Mimic{mimic.attribute("joint"),
                                      numberOf(mimic, "multiplier", 1.0, location, reading),
                                      numberOf(mimic, "offset", 0.0, location, reading)};
    motion.rest = motion.mimic->offset;
  }
  return motion;
}

/// The displacement of a joint that mimics another when that one is at 0; identity for all others.
Pose restDisplacement(const std::optional<JointMotion>& motion) {
  if (!motion || !motion->mimic) return Pose::Identity();
  if (motion->slides) {
    return makePose(motion->rest * motion->axis_L, Eigen::Quaterniond::Identity());
  }
  return makePose({0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(motion->rest, motion->axis_L)));
}

/// Whether a joint is of type fixed. An unknown type is noted, and counts as not fixed.
bool isFixed(const Element& joint, const SourceLocation& location, SdfReading& reading) {
  const std::string type = joint.attribute("type");
  for (const char* known : {"revolute", "continuous", "prismatic", "floating", "planar"}) {
    if (type == known) return false;
  }
  if (type == "fixed") return true;
  reading.findings.addNote(
      location,
      "its type '" + type + "' is not a URDF joint type; the link stays where the model places it");
  return false;
}

/// The file's inertia, if it has a mass above 0 and moments; moments that the file omits are 0.
std::optional<Inertia> readInertia(const Element& link, const SourceLocation& location,
                                   SdfReading& reading) {
  const Element inertial = link.child("inertial");
  if (!inertial) return std::nullopt;
  const SourceLocation here = location.in("inertial");
  const Pose X_LI = readUrdfOrigin(inertial, here, reading);
  const double mass = numberOf(inertial.child("mass"), "value", 0.0, here, reading);
  const Element moments = inertial.child("inertia");
  const auto moment = [&](const char* name) { return numberOf(moments, name, 0.0, here, reading); };
  Eigen::Matrix3d moments_I;
  moments_I << moment("ixx"), moment("ixy"), moment("ixz"), moment("ixy"), moment("iyy"),
      moment("iyz"), moment("ixz"), moment("iyz"), moment("izz");
  if (!(mass > 0.0) || !moments) return std::nullopt;
  Inertia inertia;
  inertia.mass = mass;
  inertia.centre_of_mass_L = X_LI.translation();
  inertia.moments_L = X_LI.linear() * moments_I * X_LI.linear().transpose();
  return inertia;
}

/// What the `<gazebo>` elements say about each link.
class GazeboExtensions {
 public:
  GazeboExtensions(const Element& robot, SdfReading& reading) : reading_(reading) {
    for (const Element& gazebo : robot.children("gazebo")) {
      const std::string link = gazebo.attribute("reference");
      if (!link.empty()) by_link_[link].push_back(gazebo);
    }
  }

  /// As in Gazebo, the material in a `<visual>` takes precedence over the one that a `<material>`
  /// names.
  [[nodiscard]] GazeboLook lookOf(const std::string& link, const SourceLocation& location) const {
    GazeboLook look;
    std::string named;
    for (const Element& gazebo : of(link)) {
      const std::string name = gazebo.child("material").text();
      if (!name.empty()) named = name;
      for (const Element& visual : gazebo.children("visual")) readVisual(visual, location, look);
    }
    if (!look.material && !named.empty()) look.material = materialNamed(named, location);
    return look;
  }

  [[nodiscard]] bool hasGravity(const std::string& link, const SourceLocation& location) const {
    bool has_gravity = true;
    for (const Element& gazebo : of(link)) {
      has_gravity = !readBool(gazebo, "turnGravityOff", !has_gravity, location, reading_);
      if (!readBool(gazebo, "selfCollide", false, location, reading_)) continue;
      reading_.findings.addNote(location,
                                "<selfCollide> has no effect: the links of one robot do not "
                                "collide with each other here");
    }
    return has_gravity;
  }

  /// Adds the sensors of a link to its model.
  void addSensors(const Link& link, const SourceLocation& location, UrdfModel& model) const {
    const std::string scope = model.model.name + "::" + link.name + "::";
    for (const Element& gazebo : of(link.name)) {
      for (const Element& sensor : gazebo.children("sensor")) {
        const SourceLocation here = locationOf(sensor, location);
        const Pose X_LS = readPose(sensor, here, reading_).pose;
        const std::string name = scope + sensor.attribute("name");
        for (CameraSensor& camera : readCameras(sensor, name, link.X_ML, X_LS, here, reading_)) {
          camera.link = link.name;
          model.cameras.push_back(std::move(camera));
        }
        if (auto lidar = readLidar(sensor, name, link.X_ML, X_LS, here, reading_)) {
          lidar->link = link.name;
          model.lidars.push_back(std::move(*lidar));
        }
      }
    }
  }

 private:
  [[nodiscard]] const std::vector<Element>& of(const std::string& link) const {
    static const std::vector<Element> kNone;
    const auto found = by_link_.find(link);
    return found == by_link_.end() ? kNone : found->second;
  }

  void readVisual(const Element& visual, const SourceLocation& location, GazeboLook& look) const {
    const SourceLocation here = locationOf(visual, location, "");
    if (auto material = readSdfMaterial(visual, here, reading_)) {
      look.material = std::move(material);
    }
    const double transparency = readNumber(visual, "transparency", 0.0, here, reading_);
    look.transparency = static_cast<float>(std::min(1.0, std::max(0.0, transparency)));
    look.casts_shadow = readBool(visual, "cast_shadows", look.casts_shadow, here, reading_);
  }

  /// Nothing for names that only a robot's own scripts define: the URDF's materials are used then.
  [[nodiscard]] std::optional<Material> materialNamed(const std::string& name,
                                                      const SourceLocation& location) const {
    std::optional<Material> material = gazeboMaterial(name, reading_.meshes.textures());
    if (!material) {
      reading_.findings.addNote(location, "Gazebo ships no material '" + name +
                                              "', which <gazebo> names for it; shown without it" +
                                              nearGazeboMaterial(name));
    }
    return material;
  }

  SdfReading& reading_;
  std::map<std::string, std::vector<Element>> by_link_;
};

/// Gathers the links of a tree, parents before children.
class LinkReader {
 public:
  LinkReader(const UrdfTree& tree, const Element& robot, const SourceLocation& location,
             SdfReading& reading)
      : tree_(tree),
        location_(location),
        reading_(reading),
        gazebo_(robot, reading),
        shapes_(robot, reading) {
    result.model.name = robot.attribute("name");
  }

  /// @param joint  the joint that holds the link; null for the root
  void read(const std::string& name, const UrdfJoint* joint, std::optional<std::size_t> parent,
            const Pose& X_MP) {
    const Element& element = tree_.links.at(name);
    Link link;
    link.name = name;
    link.parent = parent;
    link.X_ML = X_MP;
    if (joint != nullptr) attach(*joint, link);
    const SourceLocation here = location_.in("link", name);
    const SourceLocation there = locationOf(element, location_, name);
    link.inertia = readInertia(element, there, reading_);
    link.has_gravity = gazebo_.hasGravity(name, here);
    link.visuals = shapes_.visuals(element, gazebo_.lookOf(name, here), here);
    link.collisions = shapes_.collisions(element, here);
    gazebo_.addSensors(link, here, result);
    const std::size_t index = result.model.links.size();
    const Pose X_ML = link.X_ML;
    result.model.links.push_back(std::move(link));
    const auto below = tree_.below.find(name);
    if (below == tree_.below.end()) return;
    for (const UrdfJoint& each : below->second) read(each.child, &each, index, X_ML);
  }

  /// Notes meshes that declare y up: a robot whose parts all lie on their sides is hard to explain
  /// otherwise.
  void noteYUp() const {
    const std::set<std::string>& meshes = shapes_.yUpMeshes();
    if (result.model.links.size() < 2 || meshes.empty()) return;
    const std::size_t more = meshes.size() - 1;
    reading_.findings.addNote(
        location_,
        "mesh '" + *meshes.begin() + "'" +
            (more > 0 ? " and " + std::to_string(more) + " more say" : " says") +
            " in COLLADA that y points up; drawn without turning it, as in Gazebo and RViz");
  }

  UrdfModel result;

 private:
  void attach(const UrdfJoint& joint, Link& link) {
    const SourceLocation here = locationOf(joint.element, location_, joint.name);
    const auto motion = motionOf(joint.element, here, reading_);
    const Pose X_PJ = readUrdfOrigin(joint.element, here, reading_);
    link.X_ML = link.X_ML * X_PJ * restDisplacement(motion);
    if (isFixed(joint.element, here, reading_)) return;
    link.moving_joint = joint.name;
    link.joint_motion = motion;
  }

  const UrdfTree& tree_;
  const SourceLocation& location_;
  SdfReading& reading_;
  GazeboExtensions gazebo_;
  UrdfShapeReader shapes_;
};

}  // namespace

UrdfModel readUrdfModel(const SdfFile& file, SdfReading& outer) {
  SdfFile prepared;
  if (!prepareUrdf(file, prepared, outer.findings)) return {};
  SdfReading reading = outer;
  reading.survey = nullptr;  // a URDF is read all at once, without a survey
  const Element robot(&prepared.root(), &prepared);
  const SourceLocation location(file.path.string());
  const auto tree = readUrdfTree(robot, location, reading);
  if (!tree) return {};
  LinkReader reader(*tree, robot, location, reading);
  reader.read(tree->root, nullptr, std::nullopt, Pose::Identity());
  reader.noteYUp();
  return std::move(reader.result);
}

}  // namespace synthetic_dataset::world
