#include "world/sdf/sdf_models.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>

#include "world/sdf/gz_plugins.h"
#include "world/sdf/sdf_cameras.h"
#include "world/sdf/sdf_collisions.h"
#include "world/sdf/sdf_joints.h"
#include "world/sdf/sdf_lidars.h"
#include "world/sdf/sdf_lights.h"
#include "world/sdf/sdf_reading.h"
#include "world/sdf/sdf_values.h"
#include "world/sdf/sdf_visuals.h"

namespace synthetic_dataset::world {
namespace {

/// Whether the principal moments are those of a solid: each above 0, and none larger than the other
/// two together (except for rounding).
bool isSolid(const Eigen::Matrix3d& moments) {
  if (!moments.allFinite()) return false;
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double kRounding = 1e-6;
  return principal(0) > 0.0 && principal(2) <= (principal(0) + principal(1)) * (1.0 + kRounding);
}

/// SDF 1.0 uses attributes. The diagonal defaults to 1, the rest to 0.
Eigen::Matrix3d readMoments(const Element& inertia, const SourceLocation& location,
                            SdfReading& reading) {
  const auto at = [&](const char* name, double fallback) {
    return readNumber(inertia, name, fallback, location, reading);
  };
  const double xy = at("ixy", 0.0);
  const double xz = at("ixz", 0.0);
  const double yz = at("iyz", 0.0);
  Eigen::Matrix3d moments;
  moments << at("ixx", 1.0), xy, xz, xy, at("iyy", 1.0), yz, xz, yz, at("izz", 1.0);
  return moments;
}

/// The file's inertia, if a solid body can have it; otherwise nothing, with a note.
/// @param location  the link's
std::optional<Inertia> readInertia(const Element& link, const SourceLocation& location,
                                   SdfReading& reading) {
  const Element element = link.child("inertial");
  // Newer files may have it computed from the collision shapes, which is also done if there is
  // none.
  if (!element || element.attribute("auto") == "true") return std::nullopt;
  const Pose X_LI = readPose(element, location, reading).pose;
  const Eigen::Matrix3d moments_I = readMoments(element.child("inertia"), location, reading);
  Inertia inertia;
  inertia.mass = readNumber(element, "mass", 1.0, location, reading);
  inertia.centre_of_mass_L = X_LI.translation();
  inertia.moments_L = X_LI.linear() * moments_I * X_LI.linear().transpose();
  if (inertia.mass > 0.0 && isSolid(inertia.moments_L)) return inertia;
  reading.findings.addNote(
      location, "its <inertial> is not that of a solid body; its collision shapes count");
  return std::nullopt;
}

/// Gathers a model and the models nested in it.
class ModelReader {
 public:
  ModelReader(const SavedModel* saved, SdfReading& reading) : saved_(saved), reading_(reading) {
    if (saved != nullptr) scale_ = saved->scale;
  }

  /// @param prefix  of the names of the links: "" or "child::"
  void read(ModelSource& source, const Pose& X_MN, const std::string& prefix, bool is_static) {
    if (source.kind == ModelSource::Kind::kUrdf) {
      addUrdf(*source.urdf, X_MN, prefix);
      return;
    }
    const std::optional<int> outer_label = label_;
    if (source.label) label_ = source.label;
    for (const Element& link : source.element.children("link")) {
      readLink(link, source, X_MN, prefix, is_static);
    }
    for (ModelSource& inner : source.models) {
      if (inner.kind != ModelSource::Kind::kModel && inner.kind != ModelSource::Kind::kUrdf)
        continue;
      const Pose X_MI =
          X_MN * source.frames.resolve(placed(inner, reading_), "", inner.location, reading_);
      const std::string inner_prefix = inner.merges ? prefix : prefix + inner.name + "::";
      read(inner, X_MI, inner_prefix, is_static || inner.is_static);
      stands_ = stands_ || inner.is_static;
    }
    label_ = outer_label;
    // Joints may refer to links of nested models, so these come first.
    stands_ = readJoints(source, prefix, reading_, contents.model) || stands_;
  }

  /// Whether something in the model cannot move, which fixes all of it: a model moves as one rigid
  /// body.
  [[nodiscard]] bool stands() const { return stands_; }

  ModelContents contents;

 private:
  /// The link whose contents are being read.
  struct LinkContext {
    const Link& link;
    const Pose& X_NL;  ///< in its own model
    SdfFrames& frames;
  };

  void readLink(const Element& from, ModelSource& source, const Pose& X_MN,
                const std::string& prefix, bool is_static) {
    const SourceLocation here = locationOf(from, source.location);
    Link link;
    link.name = uniqueName(prefix + from.attribute("name"), here);
    const Pose X_NL = source.frames.resolve(readPose(from, here, reading_), "", here, reading_);
    link.X_ML = poseOf(link.name, X_MN * X_NL);
    link.label = label_;
    link.has_gravity = readBool(from, "gravity", true, here, reading_);
    stands_ = stands_ || readBool(from, "kinematic", false, here, reading_);
    if (!is_static) link.inertia = readInertia(from, here, reading_);
    const LinkContext context{link, X_NL, source.frames};
    for (const Element& each : from.children("visual")) {
      const SourceLocation location = locationOf(each, here);
      auto visual = readVisual(each, scale_, location, reading_);
      if (!visual) continue;
      if (const auto label = readLabel(each)) link.label = label;
      visual->X_LV = poseIn(context, each, location);
      link.visuals.push_back(std::move(*visual));
    }
    for (const Element& each : from.children("collision")) {
      const SourceLocation location = locationOf(each, here);
      auto collision = readCollision(each, scale_, location, reading_);
      if (!collision) continue;
      collision->X_LC = poseIn(context, each, location);
      link.collisions.push_back(std::move(*collision));
    }
    if (!is_static) noteHulls(from, here, reading_);
    readAttached(from, context, here);
    contents.model.links.push_back(std::move(link));
  }

  void readAttached(const Element& from, const LinkContext& context,
                    const SourceLocation& location) {
    const std::string scope = contents.model.name + "::" + context.link.name + "::";
    const Pose X_WL = contents.model.X_WM * context.link.X_ML;
    for (const Element& light : from.children("light")) {
      const SourceLocation here = locationOf(light, location);
      contents.lights.push_back(readLight(light, scope + light.attribute("name"),
                                          X_WL * poseIn(context, light, here), here, reading_));
    }
    for (const Element& sensor : from.children("sensor")) {
      const SourceLocation here = locationOf(sensor, location);
      const std::string name = scope + sensor.attribute("name");
      const Pose X_LS = poseIn(context, sensor, here);
      for (CameraSensor& camera : readCameras(sensor, name, X_WL, X_LS, here, reading_)) {
        camera.link = context.link.name;
        contents.cameras.push_back(std::move(camera));
      }
      if (auto lidar = readLidar(sensor, name, X_WL, X_LS, here, reading_)) {
        lidar->link = context.link.name;
        contents.lidars.push_back(std::move(*lidar));
      }
    }
  }

  /// The pose, in its link, of something that a link contains; it may be given in any frame of the
  /// model.
  Pose poseIn(const LinkContext& context, const Element& element, const SourceLocation& location) {
    const RelativePose pose = readPose(element, location, reading_);
    if (pose.frame.empty()) return pose.pose;
    if (!context.frames.knows(pose.frame) && pose.frame != "__model__") {
      reading_.findings.addNote(
          location, "its pose is relative to '" + pose.frame +
                        "', which is not known in its model; the link's frame is taken");
      return pose.pose;
    }
    return context.X_NL.inverse() * context.frames.resolve(pose, "", location, reading_);
  }

  /// The pose of a link, which a saved world's state may override.
  [[nodiscard]] Pose poseOf(const std::string& link, const Pose& X_ML) const {
    if (saved_ == nullptr) return X_ML;
    const auto saved = saved_->X_WL.find(link);
    return saved == saved_->X_WL.end() ? X_ML : contents.model.X_WM.inverse() * saved->second;
  }

  void addUrdf(const UrdfModel& urdf, const Pose& X_MN, const std::string& prefix) {
    const std::size_t first = contents.model.links.size();
    for (Link link : urdf.model.links) {
      link.name = prefix + link.name;
      link.X_ML = poseOf(link.name, X_MN * link.X_ML);
      if (link.parent) *link.parent += first;
      if (!link.moving_joint.empty()) link.moving_joint = prefix + link.moving_joint;
      contents.model.links.push_back(std::move(link));
    }
    const auto isAdded = [&](const std::string& name) {
      return [name](const Link& link) { return link.name == name; };
    };
    // Renames a sensor, and returns X_WL of the link that carries it.
    const auto carrierOf = [&](auto& sensor) -> Pose {
      sensor.link = prefix + sensor.link;
      sensor.name =
          contents.model.name + "::" + prefix + sensor.name.substr(sensor.name.find("::") + 2);
      const std::vector<Link>& links = contents.model.links;
      const auto carrier = std::find_if(links.begin() + static_cast<std::ptrdiff_t>(first),
                                        links.end(), isAdded(sensor.link));
      return contents.model.X_WM * carrier->X_ML;
    };
    for (CameraSensor camera : urdf.cameras) {
      camera.X_WC = carrierOf(camera) * camera.X_LC;
      contents.cameras.push_back(std::move(camera));
    }
    for (LidarSensor lidar : urdf.lidars) {
      lidar.X_WS = carrierOf(lidar) * lidar.X_LS;
      contents.lidars.push_back(std::move(lidar));
    }
  }

  std::string uniqueName(const std::string& name, const SourceLocation& location) {
    std::string unique = name;
    for (int i = 1; !names_.insert(unique).second; ++i) unique = name + "_" + std::to_string(i);
    if (unique != name) {
      reading_.findings.addNote(location,
                                "an earlier link has its name; it is called '" + unique + "' here");
    }
    return unique;
  }

  const SavedModel* saved_;
  SdfReading& reading_;
  Eigen::Vector3d scale_{1, 1, 1};
  std::optional<int> label_;     ///< of the model that is being read
  std::set<std::string> names_;  ///< of links
  bool stands_ = false;
};

}  // namespace

ModelContents readModel(ModelSource& source, const Pose& X_WM, const SavedModel* saved,
                        SdfReading& reading) {
  ModelReader reader(saved, reading);
  reader.contents.model.name = source.name;
  reader.contents.model.X_WM = X_WM;
  reader.read(source, Pose::Identity(), "", source.is_static);
  reader.contents.model.is_static = source.is_static || reader.stands();
  return std::move(reader.contents);
}

}  // namespace synthetic_dataset::world
