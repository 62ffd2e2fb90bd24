#include "world/material/ogre_material.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>

#include "synthetic_dataset/errors.h"
#include "world/material/material_conversions.h"
#include "world/material/ogre_properties.h"

namespace synthetic_dataset::world {
namespace {

using Names = std::map<std::string, std::string>;  // alias to picture

enum class Blending { kNothing, kAlpha, kOther };

Blending blendingOf(const OgreObject& pass) {
  const std::string first = wordOf(pass, "scene_blend");
  const std::string second = wordOf(pass, "scene_blend", 1);
  if (first.empty() || first == "replace" || (first == "one" && second == "zero")) {
    return Blending::kNothing;
  }
  const bool alpha = first == "alpha_blend" || first == "src_alpha" || first == "colour_blend";
  return alpha ? Blending::kAlpha : Blending::kOther;
}

const OgreObject* techniqueOf(const OgreObject& material) {
  const std::vector<const OgreObject*> techniques = sectionsOf(material, "technique");
  for (const OgreObject* technique : techniques) {
    const std::string scheme = wordOf(*technique, "scheme");
    if (scheme.empty() || scheme == "Default") return technique;
  }
  return techniques.empty() ? nullptr : techniques.front();
}

/// The last pass that determines what the surface looks like: wireframes, and passes that are
/// blended with what is behind them, do not.
const OgreObject& basePassOf(const std::vector<const OgreObject*>& passes) {
  for (auto pass = passes.rbegin(); pass != passes.rend(); ++pass) {
    if (blendingOf(**pass) == Blending::kNothing && wordOf(**pass, "polygon_mode") != "wireframe") {
      return **pass;
    }
  }
  return *passes.front();
}

/// The first frame of a list; for `base.png 4 2.5`, the file base_0.png.
std::string firstFrame(const OgreProperty& animation) {
  if (animation.values.empty()) return "";
  const std::string& name = animation.values.front();
  const bool counted = animation.values.size() == 3 &&
                       std::all_of(animation.values[1].begin(), animation.values[1].end(),
                                   [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!counted) return name;
  const std::size_t dot = std::min(name.rfind('.'), name.size());
  return name.substr(0, dot) + "_0" + name.substr(dot);
}

std::string pictureOf(const OgreObject& unit, const Names& aliases) {
  const std::string alias = wordOf(unit, "texture_alias");
  const auto replaced = aliases.find(alias.empty() ? unit.name : alias);
  if (replaced != aliases.end() && !replaced->first.empty()) return replaced->second;
  if (const OgreProperty* animation = propertyOf(unit, "anim_texture")) {
    return firstFrame(*animation);
  }
  return wordOf(unit, "texture");
}

bool contains(std::string text, std::initializer_list<const char*> words) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return text.find(word) != std::string::npos; });
}

std::string unitName(const OgreObject& unit) {
  return unit.name + " " + wordOf(unit, "texture_alias");
}

bool isNormalMap(const std::string& use) { return contains(use, {"normal", "bump"}); }

/// @param use  the unit's names
bool isForAnotherUse(const OgreObject& unit, const std::string& use) {
  const std::string reflection = wordOf(unit, "env_map");
  if ((!reflection.empty() && reflection != "off") ||
      propertyOf(unit, "cubic_texture") != nullptr) {
    return true;
  }
  return contains(
      use, {"spec", "gloss", "light", "shadow", "env", "cube", "reflect", "noise", "ambient"});
}

/// The named parameters of a pass's fragment programs: `param_named bumpMap int 0`.
std::vector<const OgreProperty*> programParameters(const OgreObject& pass) {
  std::vector<const OgreProperty*> parameters;
  for (const OgreObject* program : sectionsOf(pass, "fragment_program_ref")) {
    for (const OgreProperty& property : program->properties) {
      if (property.name == "param_named" && property.values.size() > 2) {
        parameters.push_back(&property);
      }
    }
  }
  return parameters;
}

/// Whether a unit's picture multiplies the colour so far, which is the default, without a transform
/// of its own.
bool modulates(const OgreObject& unit) {
  const std::string operation = wordOf(unit, "colour_op");
  const bool same_place = propertyOf(unit, "scale") == nullptr &&
                          propertyOf(unit, "scroll") == nullptr &&
                          propertyOf(unit, "rotate") == nullptr;
  return (operation.empty() || operation == "modulate") && same_place &&
         propertyOf(unit, "colour_op_ex") == nullptr;
}

class Reader {
 public:
  explicit Reader(const OgreObject& object) {
    for (const OgreProperty& property : object.properties) {
      if (property.name == "set_texture_alias" && property.values.size() > 1) {
        aliases_[property.values[0]] = property.values[1];
      }
    }
    const OgreObject* const technique = techniqueOf(object);
    if (technique != nullptr) passes_ = sectionsOf(*technique, "pass");
  }

  OgreMaterial read() {
    material().specular.setZero();  // OGRE's default, as is white for diffuse and ambient
    if (passes_.empty()) return std::move(result_);
    base_ = &basePassOf(passes_);
    readColours();
    readSides();
    readUnits();
    readOpacity();
    readOverlays();
    return std::move(result_);
  }

 private:
  /// Reads one pass by itself.
  Reader(const OgreObject& pass, const Names& aliases) : passes_{&pass}, aliases_(aliases) {}

  void readOverlays() {
    for (auto pass = passes_.rbegin(); pass != passes_.rend() && *pass != base_; ++pass) {
      if (blendingOf(**pass) != Blending::kAlpha) continue;
      OgreMaterial overlay = Reader(**pass, aliases_).read();
      if (!overlay.source.texture) continue;
      overlay.source.overlay = std::move(result_.source.overlay);
      result_.source.overlay = std::make_shared<MaterialSource>(std::move(overlay.source));
    }
  }

  Material& material() { return result_.source.material; }

  /// The property of the base pass, else of another pass.
  const OgreProperty* find(const std::string& name) const {
    if (const OgreProperty* property = propertyOf(*base_, name)) return property;
    for (const OgreObject* pass : passes_) {
      if (const OgreProperty* property = propertyOf(*pass, name)) return property;
    }
    return nullptr;
  }

  /// @return nothing if the vertex colours replace it, or if no pass has it
  std::optional<std::vector<float>> colour(const std::string& name) const {
    const OgreProperty* const property = find(name);
    if (property == nullptr) return std::nullopt;
    const bool of_vertices =
        !property->values.empty() && property->values.front() == "vertexcolour";
    if (of_vertices) return std::nullopt;
    std::vector<float> numbers = numbersOf(*property, 0, 3);
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = std::clamp(numbers[i], 0.0F, 1.0F);
    return numbers;
  }

  void readColours() {
    if (const auto ambient = colour("ambient")) {
      material().ambient = Eigen::Vector3f(ambient->data());
    }
    if (const auto diffuse = colour("diffuse")) {
      material().diffuse.head<3>() = Eigen::Vector3f(diffuse->data());
      if (diffuse->size() > 3) alpha_ = std::clamp((*diffuse)[3], 0.0F, 1.0F);
    }
    if (const auto emissive = colour("emissive")) {
      material().emissive = Eigen::Vector3f(emissive->data());
    }
    // Three components of colour, alpha if there are five numbers, and the exponent.
    if (const auto specular = colour("specular")) {
      material().specular = Eigen::Vector3f(specular->data());
      if (specular->size() > 3) setShininess(specular->back());
    }
    material().lit = wordOf(*base_, "lighting") != "off";
    if (material().lit) return;
    material().diffuse.head<3>().setOnes();  // OGRE shows only the picture of an unlit surface
    material().emissive.setZero();
    alpha_ = 1.0F;
  }

  void setShininess(float exponent) {
    material().shininess = std::isfinite(exponent) ? std::max(exponent, 0.0F) : 0.0F;
    material().roughness = roughnessOfShininess(exponent);
  }

  void readSides() { material().double_sided = wordOf(*base_, "cull_hardware") == "none"; }

  /// The base pass's units, else those of the first pass that has a picture.
  std::vector<const OgreObject*> units() const {
    std::vector<const OgreObject*> passes{base_};
    passes.insert(passes.end(), passes_.begin(), passes_.end());
    for (const OgreObject* pass : passes) {
      std::vector<const OgreObject*> found = sectionsOf(*pass, "texture_unit");
      const bool has_picture = std::any_of(found.begin(), found.end(), [&](const OgreObject* unit) {
        return !pictureOf(*unit, aliases_).empty();
      });
      if (has_picture) return found;
    }
    return sectionsOf(*base_, "texture_unit");
  }

  /// A unit's names, including that of the sampler that reads it.
  std::string useOf(const OgreObject& unit, std::size_t index) const {
    std::string use = unitName(unit);
    for (const OgreProperty* parameter : programParameters(*base_)) {
      if (parameter->values[1] == "int" && parameter->values[2] == std::to_string(index)) {
        use += " " + parameter->values[0];
      }
    }
    return use;
  }

  void readUnits() {
    const OgreObject* diffuse = nullptr;
    const OgreObject* normals = nullptr;
    const std::vector<const OgreObject*> all = units();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const OgreObject* unit = all[i];
      readConstants(*unit);
      const std::string picture = pictureOf(*unit, aliases_);
      if (picture.empty()) continue;
      const std::string use = useOf(*unit, i);
      const bool is_shaded = !sectionsOf(*base_, "fragment_program_ref").empty();
      if (isNormalMap(use) || (is_shaded && isNormalMap(picture))) {
        setNormalMap(picture);
        if (normals == nullptr) normals = unit;
      } else if (!isForAnotherUse(*unit, use)) {
        if (diffuse != nullptr) setFactor(*diffuse, *unit);
        if (diffuse == nullptr) diffuse = unit;
      }
    }
    for (const OgreObject* system : sectionsOf(*base_, "rtshader_system")) {
      if (wordOf(*system, "lighting_stage") == "normal_map") {
        setNormalMap(wordOf(*system, "lighting_stage", 1));
      }
    }
    if (diffuse == nullptr) readProgramColour();
    if (diffuse == nullptr && normals != nullptr) readPlacement(*normals);
    if (diffuse == nullptr) return;
    result_.source.texture.emplace();
    result_.source.texture->uri = pictureOf(*diffuse, aliases_);
    readPlacement(*diffuse);
  }

  /// Reads the colour that is passed to a shader program; for water, this is the colour of deep
  /// water.
  void readProgramColour() {
    if (find("diffuse") != nullptr) return;
    for (const OgreProperty* parameter : programParameters(*base_)) {
      const std::string& type = parameter->values[1];
      const bool is_colour = contains(parameter->values[0], {"color", "colour", "diffuse"}) &&
                             (type == "float3" || type == "float4");
      if (!is_colour) continue;
      const std::vector<float> numbers = numbersOf(*parameter, 2, 3);
      material().diffuse.head<3>() = Eigen::Vector3f(numbers.data()).cwiseMax(0.0F).cwiseMin(1.0F);
      return;
    }
  }

  /// Shader programs get no factor: it is unknown what they do with a second picture.
  void setFactor(const OgreObject& diffuse, const OgreObject& unit) {
    const bool same_coordinates =
        wordOf(diffuse, "tex_coord_set") == wordOf(unit, "tex_coord_set") && modulates(diffuse);
    if (result_.source.factor || !same_coordinates || !modulates(unit) ||
        !sectionsOf(*base_, "fragment_program_ref").empty()) {
      return;
    }
    result_.source.factor.emplace();
    result_.source.factor->uri = pictureOf(unit, aliases_);
  }

  void setNormalMap(const std::string& picture) {
    if (picture.empty() || result_.source.normal_map) return;
    result_.source.normal_map.emplace();
    result_.source.normal_map->uri = picture;
    result_.source.normal_map->content = PictureContent::kNormalsOrHeights;
  }

  /// `colour_op_ex source1 src_manual src_current 1 0 0` gives the unit a colour of its own.
  void readConstants(const OgreObject& unit) {
    if (wordOf(unit, "alpha_op_ex") == "source1" &&
        wordOf(unit, "alpha_op_ex", 1) == "src_manual") {
      alpha_ = std::clamp(numbersOf(*propertyOf(unit, "alpha_op_ex"), 3, 1)[0], 0.0F, 1.0F);
    }
    const std::string operation = wordOf(unit, "colour_op_ex");
    const bool first = wordOf(unit, "colour_op_ex", 1) == "src_manual";
    const bool second = wordOf(unit, "colour_op_ex", 2) == "src_manual";
    const bool replaces = (operation == "source1" && first) || (operation == "source2" && second);
    const bool tints = operation == "modulate" && (first || second);
    if (!replaces && !tints) return;
    const Eigen::Vector3f colour(numbersOf(*propertyOf(unit, "colour_op_ex"), 3, 3).data());
    auto diffuse = material().diffuse.head<3>();
    diffuse = replaces ? colour : Eigen::Vector3f(diffuse.cwiseProduct(colour));
  }

  /// OGRE scales about the picture's centre, larger numbers making it larger, then scrolls
  /// (TextureUnitState::recalcTextureMatrix of OGRE 1.x).
  void readPlacement(const OgreObject& unit) {
    Eigen::Vector2f size(1.0F, 1.0F);
    Eigen::Vector2f scroll(0.0F, 0.0F);
    if (const OgreProperty* property = propertyOf(unit, "scale")) {
      size = Eigen::Vector2f(numbersOf(*property, 0, 2).data());
      if (size.prod() == 0.0F) {
        throw Error("line " + std::to_string(property->line) + ": scale: neither may be 0");
      }
    }
    if (const OgreProperty* property = propertyOf(unit, "scroll")) {
      scroll = Eigen::Vector2f(numbersOf(*property, 0, 2).data());
    }
    material().texture_scale = size.cwiseInverse();
    material().texture_offset =
        Eigen::Vector2f(0.5F, 0.5F) - 0.5F * material().texture_scale + scroll;
    if (const OgreProperty* property = propertyOf(unit, "rotate")) {
      if (numbersOf(*property, 0, 1)[0] != 0.0F) {
        result_.notes.push_back("its picture is drawn without its rotation");
      }
    }
  }

  void readOpacity() {
    const Blending blending = blendingOf(*base_);
    if (blending == Blending::kOther) {
      result_.notes.push_back("its scene_blend '" + wordOf(*base_, "scene_blend") +
                              "' is drawn as if it covered what is behind");
    }
    if (blending == Blending::kAlpha) material().diffuse.w() = alpha_;
    const std::string function = wordOf(*base_, "alpha_rejection");
    const bool rejects = function == "greater" || function == "greater_equal";
    if (rejects) {
      const OgreProperty& rejection = *propertyOf(*base_, "alpha_rejection");
      material().alpha_threshold = numbersOf(rejection, 1, 1)[0] / 255.0F;
    }
    material().texture_is_glass = blending == Blending::kAlpha && !rejects;
    if (result_.source.texture && (rejects || blending == Blending::kAlpha)) {
      result_.source.texture->alpha = AlphaMeaning::kOpacity;
    }
  }

  std::vector<const OgreObject*> passes_;
  const OgreObject* base_ = nullptr;
  Names aliases_;
  float alpha_ = 1.0F;
  OgreMaterial result_;
};

}  // namespace

OgreMaterial readOgreMaterial(const OgreObject& material) { return Reader(material).read(); }

}  // namespace synthetic_dataset::world
