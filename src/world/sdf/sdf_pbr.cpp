#include "world/sdf/sdf_pbr.h"

#include <string>

#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

class PbrReader {
 public:
  PbrReader(const Element& material, const Element& workflow, const SourceLocation& location,
            SdfReading& reading, MaterialSource& to)
      : material_(material), pbr_(workflow), location_(location), reading_(reading), to_(to) {}

  void read() {
    readColours();
    if (pbr_.name() == "metal") {
      readMetal();
    } else {
      readSpecular();
    }
    readNormalMap();
    noteTheRest();
  }

 private:
  /// Maps are named relative to the file that names them.
  std::optional<TextureReference> picture(const char* name, PictureContent content) const {
    const std::string uri = readText(pbr_, name);
    if (uri.empty()) return std::nullopt;
    TextureReference reference;
    reference.uri = uri;
    reference.folder = pbr_.folder();
    reference.content = content;
    return reference;
  }

  float fraction(const char* name, double fallback) const {
    const double value = readNumber(pbr_, name, fallback, location_, reading_);
    if (value >= 0.0 && value <= 1.0) return static_cast<float>(value);
    reading_.findings.addNote(location_, std::string(name) + ": found " + shortText(value) +
                                             "; it should be 0 to 1; " + takenInstead(fallback));
    return static_cast<float>(fallback);
  }

  void readColours() {
    to_.texture = picture("albedo_map", PictureContent::kColour);
    if (to_.texture) {
      to_.texture->alpha = AlphaMeaning::kOpacity;  // as gz-sim draws it
      if (!material_.has("diffuse")) to_.material.diffuse.setOnes();
    }
    to_.emissive_map = picture("emissive_map", PictureContent::kColour);
    if (to_.emissive_map && !material_.has("emissive")) to_.material.emissive.setOnes();
  }

  /// A map stands for the number, and differs from place to place.
  void readMetal() {
    to_.roughness_map = picture("roughness_map", PictureContent::kRed);
    to_.metalness_map = picture("metalness_map", PictureContent::kRed);
    to_.material.roughness = to_.roughness_map ? 1.0F : fraction("roughness", 0.5);
    to_.material.metalness = to_.metalness_map ? 1.0F : fraction("metalness", 0.5);
  }

  void readSpecular() {
    to_.roughness_map = picture("glossiness_map", PictureContent::kInvertedRed);
    to_.material.roughness = to_.roughness_map ? 1.0F : 1.0F - fraction("glossiness", 0.0);
    to_.material.metalness = 0.0F;
  }

  void readNormalMap() {
    const std::string space = pbr_.child("normal_map").attribute("type");
    if (space == "object") {
      reading_.findings.addNote(
          "normal maps in object space are not drawn; those in tangent space are");
      return;
    }
    to_.normal_map = picture("normal_map", PictureContent::kColour);
  }

  void noteTheRest() const {
    std::string left_out;
    for (const char* name :
         {"ambient_occlusion_map", "environment_map", "specular_map", "light_map"}) {
      if (!readText(pbr_, name).empty())
        left_out += (left_out.empty() ? "" : ", ") + std::string(name);
    }
    if (left_out.empty()) return;
    reading_.findings.addNote("of materials' maps these kinds are not drawn: " + left_out);
  }

  const Element& material_;
  const Element& pbr_;
  const SourceLocation& location_;
  SdfReading& reading_;
  MaterialSource& to_;
};

}  // namespace

bool readPbr(const Element& material, const SourceLocation& location, SdfReading& reading,
             MaterialSource& to) {
  const Element pbr = material.child("pbr");
  const Element metal = pbr.child("metal");
  const Element workflow = metal ? metal : pbr.child("specular");
  if (!workflow) return false;
  PbrReader(material, workflow, location, reading, to).read();
  return true;
}

}  // namespace synthetic_dataset::world
