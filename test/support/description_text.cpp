#include "support/description_text.h"

#include <sstream>

namespace synthetic_dataset::test {
namespace {

using namespace world;

class Teller {
 public:
  [[nodiscard]] std::string text() const { return text_.str(); }

  void tell(const Model& model) {
    line("model ", model.name, " static ", model.is_static, pose(model.X_WM));
    for (const Link& link : model.links) {
      line(" link ", link.name, pose(link.X_ML), " held by ", link.parent ? *link.parent + 1 : 0,
           " moved by ", link.moving_joint);
      for (const Visual& visual : link.visuals) tell(visual);
      for (const Collision& collision : link.collisions) {
        line("  collision ", collision.name, pose(collision.X_LC), " shape ",
             collision.shape.index(), " friction ", collision.friction, ' ', collision.restitution);
      }
      if (!link.inertia) continue;
      line("  inertia ", link.inertia->mass, ' ', link.inertia->centre_of_mass_L.transpose(), ' ',
           numbers(link.inertia->moments_L));
    }
  }

  void tell(const Light& light) {
    line("light ", light.name, ' ', static_cast<int>(light.type), pose(light.X_WL), ' ',
         light.direction_L.transpose(), ' ', light.diffuse.transpose(), ' ', light.range);
  }

  void tell(const CameraSensor& camera) {
    line("camera ", camera.name, pose(camera.X_WC), ' ', camera.camera.intrinsics().fx);
  }

 private:
  template <class... Parts>
  void line(const Parts&... parts) {
    (text_ << ... << parts) << '\n';
  }

  static std::string pose(const Pose& pose) { return " at " + numbers(pose.matrix()); }

  /// Column by column.
  template <class Matrix>
  static std::string numbers(const Matrix& matrix) {
    std::ostringstream text;
    for (Eigen::Index i = 0; i < matrix.size(); ++i) text << matrix.data()[i] << ' ';
    return text.str();
  }

  void tell(const Visual& visual) {
    line("  visual ", visual.name, pose(visual.X_LV), " shadow ", visual.casts_shadow);
    for (const Surface& surface : visual.surfaces) {
      Eigen::Vector3d sum(0, 0, 0);
      for (const auto& position : surface.mesh->positions) sum += position.cast<double>();
      const Material& material = surface.material;
      line("   surface ", surface.mesh->positions.size(), ' ', surface.mesh->indices.size(), ' ',
           sum.transpose(), ' ', material.diffuse.transpose(), ' ', material.specular.transpose(),
           ' ', material.emissive.transpose(), ' ', material.roughness, ' ', material.metalness);
      for (const auto& texture : {material.texture, material.normal_map, material.roughness_map,
                                  material.metalness_map, material.emissive_map}) {
        line("    ", texture ? texture->file : "-");
      }
    }
  }

  std::ostringstream text_;
};

}  // namespace

std::string textOf(const Description& description) {
  Teller teller;
  for (const Model& model : description.models) teller.tell(model);
  for (const Light& light : description.lights) teller.tell(light);
  for (const CameraSensor& camera : description.cameras) teller.tell(camera);
  return teller.text();
}

}  // namespace synthetic_dataset::test
