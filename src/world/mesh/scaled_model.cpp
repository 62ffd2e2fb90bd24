#include "world/mesh/scaled_model.h"

#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace synthetic_dataset::world {
namespace {

/// Scales the parts of one model; a mesh that several parts share is scaled once, and stays shared.
class Scaling {
 public:
  explicit Scaling(double factor) : factor_(factor) {}

  void apply(Link& link) {
    move(link.X_ML);
    for (Visual& visual : link.visuals) {
      move(visual.X_LV);
      for (Surface& surface : visual.surfaces) surface.mesh = meshOf(surface.mesh);
    }
    for (Collision& collision : link.collisions) {
      move(collision.X_LC);
      std::visit([&](auto& shape) { resize(shape); }, collision.shape);
    }
    if (!link.inertia) return;
    // The density is unchanged: mass scales as volume, and a moment as mass times a squared length.
    link.inertia->mass *= std::pow(factor_, 3);
    link.inertia->centre_of_mass_L *= factor_;
    link.inertia->moments_L *= std::pow(factor_, 5);
  }

 private:
  void move(Pose& pose) const { pose.translation() *= factor_; }

  void resize(BoxShape& box) const { box.size *= factor_; }
  void resize(SphereShape& sphere) const { sphere.radius *= factor_; }
  void resize(CylinderShape& cylinder) const {
    cylinder.radius *= factor_;
    cylinder.length *= factor_;
  }
  static void resize(PlaneShape& /*infinite*/) {}
  void resize(MeshShape& mesh) { mesh.mesh = meshOf(mesh.mesh); }

  std::shared_ptr<const Mesh> meshOf(const std::shared_ptr<const Mesh>& mesh) {
    std::shared_ptr<const Mesh>& made = meshes_[mesh];
    if (made || !mesh) return made;
    auto larger = std::make_shared<Mesh>(*mesh);
    for (Eigen::Vector3f& position : larger->positions) position *= static_cast<float>(factor_);
    made = std::move(larger);
    return made;
  }

  double factor_;
  std::map<std::shared_ptr<const Mesh>, std::shared_ptr<const Mesh>> meshes_;
};

}  // namespace

Model scaled(Model model, double factor) {
  Scaling scaling(factor);
  for (Link& link : model.links) scaling.apply(link);
  return model;
}

}  // namespace synthetic_dataset::world
