#include "world/sdf/sdf_pbr.h"

#include <string>

#include <sdf/sdf_config.h>
#include <sdf/Pbr.hh>

namespace synthetic_dataset::world {
namespace {

const sdf::PbrWorkflow* workflowOf(const sdf::Material& material) {
  const sdf::Pbr* pbr = material.PbrMaterial();
  if (pbr == nullptr) return nullptr;
  const sdf::PbrWorkflow* metal = pbr->Workflow(sdf::PbrWorkflowType::METAL);
  return metal != nullptr ? metal : pbr->Workflow(sdf::PbrWorkflowType::SPECULAR);
}

class PbrReader {
 public:
  PbrReader(const sdf::Material& material, const sdf::PbrWorkflow& pbr, const Place& place,
            SdfReading& reading, MaterialSource& to)
      : element_(material.Element()), pbr_(pbr), place_(place), reading_(reading), to_(to) {}

  void read() {
    readColours();
    if (pbr_.Type() == sdf::PbrWorkflowType::METAL) {
      readMetal();
    } else {
      readSpecular();
    }
    readNormalMap();
    noteTheRest();
  }

 private:
  /// Maps are named relative to the file that names them.
  std::optional<TextureReference> picture(const std::string& uri, PictureContent content) const {
    if (uri.empty()) return std::nullopt;
    TextureReference reference;
    reference.uri = uri;
    reference.folder = reading_.folderOf(element_);
    reference.content = content;
    return reference;
  }

  float fraction(double value, const char* name) const {
    if (value >= 0.0 && value <= 1.0) return static_cast<float>(value);
    reading_.findings.addError(place_.message(std::string(name) + ": found " +
                                              std::to_string(value) + "; it should be 0 to 1"));
    return 0.5F;
  }

  void readColours() {
    to_.texture = picture(pbr_.AlbedoMap(), PictureContent::kColour);
    if (to_.texture) {
      to_.texture->alpha = AlphaMeaning::kOpacity;  // as gz-sim draws it
      if (!has(element_, "diffuse")) to_.material.diffuse.setOnes();
    }
    to_.emissive_map = picture(pbr_.EmissiveMap(), PictureContent::kColour);
    if (to_.emissive_map && !has(element_, "emissive")) to_.material.emissive.setOnes();
  }

  /// A map stands for the number, and differs from place to place.
  void readMetal() {
    to_.roughness_map = picture(pbr_.RoughnessMap(), PictureContent::kRed);
    to_.metalness_map = picture(pbr_.MetalnessMap(), PictureContent::kRed);
    to_.material.roughness = to_.roughness_map ? 1.0F : fraction(pbr_.Roughness(), "roughness");
    to_.material.metalness = to_.metalness_map ? 1.0F : fraction(pbr_.Metalness(), "metalness");
  }

  void readSpecular() {
    to_.roughness_map = picture(pbr_.GlossinessMap(), PictureContent::kInvertedRed);
    to_.material.roughness =
        to_.roughness_map ? 1.0F : 1.0F - fraction(pbr_.Glossiness(), "glossiness");
    to_.material.metalness = 0.0F;
  }

  void readNormalMap() {
    if (pbr_.NormalMapType() == sdf::NormalMapSpace::OBJECT) {
      reading_.findings.addNote(
          "normal maps in object space are not drawn; those in tangent space are");
      return;
    }
    to_.normal_map = picture(pbr_.NormalMap(), PictureContent::kColour);
  }

  void noteTheRest() const {
    std::string left_out;
    const auto add = [&](const std::string& uri, const char* name) {
      if (!uri.empty()) left_out += (left_out.empty() ? "" : ", ") + std::string(name);
    };
    add(pbr_.AmbientOcclusionMap(), "ambient occlusion");
    add(pbr_.EnvironmentMap(), "environment");
    add(pbr_.SpecularMap(), "specular");
#if SDF_MAJOR_VERSION >= 11
    add(pbr_.LightMap(), "light");
#endif
    if (left_out.empty()) return;
    reading_.findings.addNote("of materials' maps these kinds are not drawn: " + left_out);
  }

  sdf::ElementPtr element_;
  const sdf::PbrWorkflow& pbr_;
  const Place& place_;
  SdfReading& reading_;
  MaterialSource& to_;
};

}  // namespace

bool readPbr(const sdf::Material& material, const Place& place, SdfReading& reading,
             MaterialSource& to) {
  const sdf::PbrWorkflow* const pbr = workflowOf(material);
  if (pbr == nullptr) return false;
  PbrReader(material, *pbr, place, reading, to).read();
  return true;
}

}  // namespace synthetic_dataset::world
