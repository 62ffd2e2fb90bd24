#include "world/sdf_materials.h"

#include <string>

#include <sdf/Pbr.hh>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

bool hasColour(const sdf::ElementPtr& element) {
  return has(element, "ambient") || has(element, "diffuse") || has(element, "specular") ||
         has(element, "emissive");
}

void noteScript(const sdf::ElementPtr& element, MaterialFallback fallback, SdfReading& reading) {
  const sdf::ElementPtr name = descendant(element, {"script", "name"});
  if (!name) return;
  const bool mesh = fallback == MaterialFallback::kMeshMaterial && !hasColour(element);
  reading.findings.addNote("material script '" + name->Get<std::string>() +
                           "' is not read; shown in " +
                           (mesh ? "the mesh's own material" : "its diffuse colour"));
}

/// Colours beyond 0 .. 1 mean nothing on a surface.
Eigen::Vector4f unit(const Eigen::Vector4f& colour, const char* name, const Place& place,
                     SdfReading& reading) {
  if (colour.allFinite()) return colour.cwiseMax(0.0F).cwiseMin(1.0F);
  reading.findings.addError(
      place.message(std::string(name) + ": found a number that is not finite; colours are 0 to 1"));
  return Eigen::Vector4f::Ones();
}

void readColours(const sdf::Material& from, const Place& place, SdfReading& reading, Material& to) {
  const sdf::ElementPtr element = from.Element();
  if (has(element, "diffuse")) {
    to.diffuse = unit(toColour(from.Diffuse()), "diffuse", place, reading);
  } else if (has(element, "ambient")) {
    to.diffuse = unit(toColour(from.Ambient()), "ambient", place, reading);
  }
  if (has(element, "specular")) {
    to.specular = unit(toColour(from.Specular()), "specular", place, reading).head<3>();
  }
  if (has(element, "emissive")) {
    to.emissive = unit(toColour(from.Emissive()), "emissive", place, reading).head<3>();
  }
}

float fraction(double value, const char* name, const Place& place, SdfReading& reading) {
  if (value >= 0.0 && value <= 1.0) return static_cast<float>(value);
  reading.findings.addError(place.message(std::string(name) + ": found " + std::to_string(value) +
                                          "; it should be 0 to 1"));
  return 0.5F;
}

void readAlbedo(const sdf::PbrWorkflow& pbr, const sdf::ElementPtr& element, const Place& place,
                SdfReading& reading, Material& to) {
  if (pbr.AlbedoMap().empty()) return;
  if (!has(element, "diffuse")) to.diffuse.setOnes();
  TextureReference reference;
  reference.uri = pbr.AlbedoMap();
  reference.folder = reading.folderOf(element);
  reference.alpha = AlphaMeaning::kOpacity;  // as gz-sim draws it
  try {
    to.texture = reading.meshes.textures().load(reference);
  } catch (const Error& error) {
    reading.findings.addError(place.message(error.what()));
  }
}

/// A map stands for a number that differs from place to place; without it the number of the
/// specification holds (0.5).
void readPbr(const sdf::PbrWorkflow& pbr, const sdf::ElementPtr& element, const Place& place,
             SdfReading& reading, Material& to) {
  readAlbedo(pbr, element, place, reading, to);
  if (pbr.Type() == sdf::PbrWorkflowType::METAL) {
    if (pbr.RoughnessMap().empty()) {
      to.roughness = fraction(pbr.Roughness(), "roughness", place, reading);
    }
    if (pbr.MetalnessMap().empty()) {
      to.metalness = fraction(pbr.Metalness(), "metalness", place, reading);
    }
  } else if (pbr.GlossinessMap().empty()) {
    to.roughness = 1.0F - fraction(pbr.Glossiness(), "glossiness", place, reading);
  }
  if (!pbr.NormalMap().empty() || !pbr.RoughnessMap().empty() || !pbr.MetalnessMap().empty() ||
      !pbr.EmissiveMap().empty()) {
    reading.findings.addNote(
        "normal, roughness, metalness and emissive maps are not drawn; albedo maps are");
  }
}

const sdf::PbrWorkflow* workflowOf(const sdf::Material& material) {
  const sdf::Pbr* pbr = material.PbrMaterial();
  if (pbr == nullptr) return nullptr;
  const sdf::PbrWorkflow* metal = pbr->Workflow(sdf::PbrWorkflowType::METAL);
  return metal != nullptr ? metal : pbr->Workflow(sdf::PbrWorkflowType::SPECULAR);
}

}  // namespace

std::optional<Material> readSdfMaterial(const sdf::Material& material, MaterialFallback fallback,
                                        const Place& place, SdfReading& reading) {
  const sdf::ElementPtr element = material.Element();
  noteScript(element, fallback, reading);
  const sdf::PbrWorkflow* pbr = workflowOf(material);
  if (!hasColour(element) && pbr == nullptr) return std::nullopt;
  Material result;
  readColours(material, place, reading, result);
  if (pbr != nullptr) readPbr(*pbr, element, place, reading, result);
  const sdf::ElementPtr double_sided = descendant(element, {"double_sided"});
  if (double_sided) result.double_sided = double_sided->Get<bool>();
  return result;
}

}  // namespace synthetic_dataset::world
