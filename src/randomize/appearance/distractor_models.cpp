#include "randomize/appearance/distractor_models.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/random/random_source.h"
#include "randomize/appearance/texture_source.h"
#include "synthetic_dataset/errors.h"
#include "world/files/model_folders.h"
#include "world/material/material_conversions.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::randomize {
namespace {

struct Form {
  std::shared_ptr<const world::Mesh> mesh;
  world::Shape shape;
};

Form drawForm(const randomize::DistractorOptions& config, base::RandomSource& random) {
  const std::size_t kind = random.index(3);
  const double a = config.size.drawNumber(random);
  if (kind == 0) return {world::sphereMesh(0.5 * a), world::SphereShape{0.5 * a}};
  const double b = config.size.drawNumber(random);
  if (kind == 1) return {world::cylinderMesh(0.5 * a, b), world::CylinderShape{0.5 * a, b}};
  const Eigen::Vector3d size(a, b, config.size.drawNumber(random));
  return {world::boxMesh(size), world::BoxShape{size}};
}

/// One of the given colours, a little lighter or darker.
Eigen::Vector3f drawColour(const std::vector<Eigen::Vector3d>& colours,
                           base::RandomSource& random) {
  const Eigen::Vector3d& colour = colours[random.index(colours.size())];
  return (colour * random.uniform(0.7, 1.15)).cwiseMin(1.0).cast<float>();
}

world::Material drawMaterial(const DistractorOptions& config,
                             std::optional<TextureSource>& textures, base::RandomSource& random) {
  constexpr double kPlain = 0.3;  // share of those with one of the given colours
  world::Material material;
  material.diffuse.setOnes();
  if (!config.colours.empty() && random.unit() < kPlain) {
    material.diffuse.head<3>() = drawColour(config.colours, random);
  } else if (textures) {
    material.texture = textures->draw(random).second;
  } else {
    for (int i = 0; i < 3; ++i) material.diffuse[i] = static_cast<float>(random.unit());
  }
  material.ambient = material.diffuse.head<3>();
  material.roughness = static_cast<float>(random.uniform(0.2, 1.0));
  material.shininess = world::shininessOfRoughness(material.roughness);
  return material;
}

world::Model shapeModel(const std::string& name, const Form& form,
                        const world::Material& material) {
  world::Visual visual;
  visual.name = "visual";
  visual.surfaces.push_back({form.mesh, material});
  world::Collision collision;
  collision.name = "collision";
  collision.shape = form.shape;
  world::Link link;
  link.name = "link";
  link.visuals.push_back(std::move(visual));
  link.collisions.push_back(std::move(collision));
  world::Model model;
  model.name = name;
  model.links.push_back(std::move(link));
  return model;
}

bool canBeSeen(const world::Model& model) {
  return std::any_of(model.links.begin(), model.links.end(), [](const world::Link& link) {
    return std::any_of(link.visuals.begin(), link.visuals.end(),
                       [](const world::Visual& visual) { return !visual.surfaces.empty(); });
  });
}

}  // namespace

std::vector<world::Model> makeDistractors(
    const randomize::DistractorOptions& config, std::uint64_t seed,
    const std::function<world::Model(const std::string& uri, const std::string& name)>& load) {
  std::optional<TextureSource> textures;
  if (config.models.empty() && config.textures != "none") textures.emplace(config.textures);
  std::vector<std::string> files;
  for (const std::string& each : config.models) {
    for (const std::string& file : world::modelsAt(each)) files.push_back(file);
  }
  std::vector<world::Model> models;
  for (int i = 0; i < config.pool; ++i) {
    const std::string name = randomize::distractorName(i + 1);
    if (!files.empty()) {
      const std::string& file = files[static_cast<std::size_t>(i) % files.size()];
      models.push_back(load(file, name));
      models.back().X_WM = Pose::Identity();
      if (!canBeSeen(models.back())) {
        throw Error("found '" + file + "', a model without visible parts");
      }
      continue;
    }
    base::RandomSource random(seed, i, "randomize/distractors/pool");
    const Form form = drawForm(config, random);
    models.push_back(shapeModel(name, form, drawMaterial(config, textures, random)));
  }
  return models;
}

}  // namespace synthetic_dataset::randomize
