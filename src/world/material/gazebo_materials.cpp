#include "world/material/gazebo_materials.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"
#include "world/material/material_conversions.h"

namespace synthetic_dataset::world {
namespace {

enum class Finish {
  kPlain,
  kGlow,      ///< emits its diffuse colour
  kUnlit,     ///< `lighting off`
  kTwoSided,  ///< `cull_hardware none`
};

/// The properties of a material; `picture` is a file in Gazebo's media/materials/textures.
struct Row {
  const char* name;  ///< without "Gazebo/"
  std::array<float, 4> diffuse;
  std::array<float, 3> specular;
  float shininess;
  Finish finish = Finish::kPlain;
  const char* picture = nullptr;
  float scale = 1.0F;  ///< of the picture's coordinates
};

constexpr std::array<float, 4> kWhite{1, 1, 1, 1};
constexpr std::array<float, 4> kRoadGrey{0.8F, 0.8F, 0.8F, 1};
constexpr std::array<float, 3> kNoHighlight{0, 0, 0};
constexpr std::array<float, 3> kFaint{0.01F, 0.01F, 0.01F};
constexpr std::array<float, 3> kWeak{0.1F, 0.1F, 0.1F};
constexpr std::array<float, 3> kPolished{0.2F, 0.2F, 0.2F};

/// gazebo.material of Gazebo Classic 11 (media/materials/scripts), without the materials that are
/// shaders of its sensors. What a script omits has OGRE's default: white diffuse, no specular.
/// Transparent materials have the alpha of their `alpha_op_ex`.
const Row kRows[] = {
    {"Grey", {0.7F, 0.7F, 0.7F, 1}, kFaint, 1.5F},
    {"DarkGrey", {0.175F, 0.175F, 0.175F, 1}, {0.175F, 0.175F, 0.175F}, 1.5F},
    {"White", kWhite, kWeak, 128},
    {"FlatBlack", {0.1F, 0.1F, 0.1F, 1}, kFaint, 1},
    {"Black", {0, 0, 0, 1}, kWeak, 5},
    {"Red", {1, 0, 0, 1}, kWeak, 1},
    {"RedBright", {0.87F, 0.26F, 0.07F, 1}, {0.87F, 0.26F, 0.07F}, 1},
    {"Green", {0, 1, 0, 1}, kWeak, 1},
    {"Blue", {0, 0, 1, 1}, kWeak, 1},
    {"SkyBlue", {0, 0, 1, 1}, kWeak, 1},
    {"Yellow", {1, 1, 0, 1}, kNoHighlight, 0},
    {"ZincYellow", {0.9725F, 0.9529F, 0.2078F, 1}, {0.9725F, 0.9529F, 0.2078F}, 1},
    {"DarkYellow", {0.7F, 0.7F, 0, 1}, kNoHighlight, 0},
    {"Purple", {1, 0, 1, 1}, kWeak, 1},
    {"Turquoise", {0, 1, 1, 1}, kWeak, 1},
    {"Orange", {1, 0.5088F, 0.0468F, 1}, {0.5F, 0.5F, 0.5F}, 128},
    {"Indigo", {0.33F, 0, 0.5F, 1}, kWeak, 1},
    {"Gold", {0.8F, 0.64869F, 0.120759F, 1}, {0.4F, 0.4F, 0.4F}, 12.5F},
    {"Pioneer2Body", {0.681193F, 0.000923F, 0.000923F, 1}, {0.5F, 0.5F, 0.5F}, 12.5F},
    {"JointAnchor", kWhite, kNoHighlight, 0, Finish::kUnlit},

    {"WhiteGlow", kWhite, kWeak, 128, Finish::kGlow},
    {"RedGlow", {1, 0, 0, 1}, {1, 0, 0}, 128, Finish::kGlow},
    {"GreenGlow", {0, 1, 0, 1}, kWeak, 1, Finish::kGlow},
    {"BlueGlow", {0, 0, 1, 1}, kWeak, 1, Finish::kGlow},
    {"YellowGlow", {1, 1, 0, 1}, kNoHighlight, 0, Finish::kGlow},
    {"PurpleGlow", {1, 0, 1, 1}, kWeak, 1, Finish::kGlow},
    {"TurquoiseGlow", {0, 1, 1, 1}, kWeak, 1, Finish::kGlow},
    {"TurquoiseGlowOutline", {0, 1, 1, 1}, kWeak, 128, Finish::kGlow},
    {"LightOn", {0, 1, 0, 1}, kNoHighlight, 0, Finish::kGlow},
    {"LightOff", {1, 0, 0, 1}, kNoHighlight, 0, Finish::kGlow},

    {"RedTransparentOverlay", {1, 0, 0, 0.5F}, kNoHighlight, 0, Finish::kUnlit},
    {"GreenTransparentOverlay", {0, 1, 0, 0.5F}, kNoHighlight, 0, Finish::kUnlit},
    {"BlueTransparentOverlay", {0, 0, 1, 0.5F}, kNoHighlight, 0, Finish::kUnlit},
    {"OrangeTransparentOverlay", {1, 0.5088F, 0.0468F, 0.8F}, kNoHighlight, 0, Finish::kUnlit},
    {"DarkOrangeTransparentOverlay", {0.6F, 0.305F, 0.028F, 0.8F}, kNoHighlight, 0, Finish::kUnlit},
    {"RedTransparent", {1, 0, 0, 0.5F}, kNoHighlight, 0, Finish::kUnlit},
    {"GreenTransparent", {0, 1, 0, 0.5F}, kNoHighlight, 0},
    {"BlueTransparent", {0, 0, 1, 0.5F}, kNoHighlight, 0},
    {"DarkMagentaTransparent", {0.6F, 0, 0.6F, 0.5F}, kNoHighlight, 0},
    {"GreyTransparent", {0.5F, 0.5F, 0.5F, 0.5F}, kNoHighlight, 0},
    {"BlackTransparent", {0, 0, 0, 0.5F}, kNoHighlight, 0},
    {"YellowTransparent", {1, 1, 0, 0.5F}, kNoHighlight, 0},
    {"OrangeTransparent", {1, 0.44F, 0, 0.4F}, kNoHighlight, 0},
    {"BlueLaser", {0, 0, 1, 0.4F}, kNoHighlight, 0, Finish::kTwoSided},
    {"LightBlueLaser", {0.5F, 0.5F, 1, 0.4F}, kNoHighlight, 0, Finish::kTwoSided},

    {"Wood", kWhite, kPolished, 12.5F, Finish::kPlain, "wood.jpg"},
    {"WoodFloor", kWhite, kNoHighlight, 0, Finish::kPlain, "hardwood_floor.jpg"},
    {"WoodPallet", kWhite, kNoHighlight, 0.5F, Finish::kPlain, "WoodPallet.png"},
    {"CeilingTiled", kWhite, kNoHighlight, 0, Finish::kPlain, "ceiling_tiled.jpg"},
    {"PaintedWall", kWhite, kNoHighlight, 0, Finish::kPlain, "paintedWall.jpg"},
    {"Bricks", kWhite, kPolished, 12.5F, Finish::kPlain, "bricks.png"},
    {"BuildingFrame", kWhite, kPolished, 12.5F, Finish::kPlain, "building_frame.png"},
    {"WindowFrame", kWhite, kPolished, 12.5F, Finish::kPlain, "window_frame.png"},
    {"PioneerBody", {1, 0, 0, 1}, {0.5F, 0, 0}, 10, Finish::kPlain, "pioneerBody.jpg"},
    {"CoM", kWhite, kNoHighlight, 0, Finish::kPlain, "com.png"},
    {"GreyGradientSky", kWhite, kNoHighlight, 0, Finish::kUnlit, "grey_gradient.jpg"},
    {"CloudySky", kWhite, kNoHighlight, 0, Finish::kUnlit, "clouds.jpg"},
    {"Grass", kWhite, kNoHighlight, 0, Finish::kPlain, "grass.jpg", 50},
    {"Runway", kWhite, kNoHighlight, 0, Finish::kPlain, "runway.png"},
    {"Road", kRoadGrey, kFaint, 2, Finish::kPlain, "road1.jpg"},
    {"Residential", kRoadGrey, kFaint, 2, Finish::kPlain, "residential.jpg"},
    {"Tertiary", kRoadGrey, kFaint, 2, Finish::kPlain, "residential.jpg"},
    {"Pedestrian", kRoadGrey, kFaint, 2, Finish::kPlain, "sidewalk.jpg"},
    {"Footway", kRoadGrey, kFaint, 2, Finish::kPlain, "sidewalk.jpg"},
    {"Motorway", kRoadGrey, kFaint, 2, Finish::kPlain, "motorway.jpg"},
    {"Lanes_6", kRoadGrey, kFaint, 2, Finish::kPlain, "motorway.jpg"},
    {"Trunk", kRoadGrey, kFaint, 2, Finish::kPlain, "trunk.jpg"},
    {"Lanes_4", kRoadGrey, kFaint, 2, Finish::kPlain, "trunk.jpg"},
    {"Primary", kRoadGrey, kFaint, 2, Finish::kPlain, "primary.jpg"},
    {"Lanes_2", kRoadGrey, kFaint, 2, Finish::kPlain, "primary.jpg"},
    {"Secondary", kRoadGrey, kFaint, 2, Finish::kPlain, "secondary.jpg"},
    {"Lane_1", kRoadGrey, kFaint, 2, Finish::kPlain, "secondary.jpg"},
    {"Steps", kRoadGrey, kFaint, 2, Finish::kPlain, "steps.jpeg"},
};

/// Ambient colours that differ from the diffuse one.
const struct {
  const char* name;
  std::array<float, 3> ambient;
} kAmbients[] = {
    {"Grey", {0.3F, 0.3F, 0.3F}},
    {"SkyBlue", {0.13F, 0.44F, 0.7F}},
    {"Gold", {0.4F, 0.24869F, 0.020759F}},
    {"Pioneer2Body", {0.481193F, 0.000123F, 0.000123F}},
    {"PioneerBody", {0, 0, 0}},
    {"WoodFloor", {0.5F, 0.5F, 0.5F}},
    {"WoodPallet", {0.5F, 0.5F, 0.5F}},
    {"CeilingTiled", {0.5F, 0.5F, 0.5F}},
    {"CoM", {0.5F, 0.5F, 0.5F}},
    {"Grass", {0.5F, 0.5F, 0.5F}},
    {"Runway", {0.5F, 0.5F, 0.5F}},
};

Eigen::Vector3f ambientOf(const Row& row) {
  for (const auto& [name, ambient] : kAmbients) {
    if (std::string(row.name) == name) return Eigen::Vector3f(ambient.data());
  }
  if (row.diffuse == kRoadGrey) return Eigen::Vector3f::Constant(0.1F);
  return Eigen::Vector4f(row.diffuse.data()).head<3>();
}

const std::string kPrefix = "Gazebo/";

const Row* find(const std::string& name) {
  if (name.rfind(kPrefix, 0) != 0) return nullptr;
  const auto found = std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& row) {
    return name.compare(kPrefix.size(), std::string::npos, row.name) == 0;
  });
  return found == std::end(kRows) ? nullptr : found;
}

/// A stand-in is also used if Gazebo's own picture cannot be read.
std::shared_ptr<const Texture> pictureOf(const Row& row, TextureLoader& textures) {
  TextureReference reference;
  reference.uri = std::string("file://media/materials/textures/") + row.picture;
  reference.folder = "/";
  try {
    return textures.load(reference);
  } catch (const Error&) {
    return textures.standIn(row.picture);
  }
}

}  // namespace

std::optional<Material> gazeboMaterial(const std::string& name, TextureLoader& textures) {
  const Row* row = find(name);
  if (row == nullptr) return std::nullopt;
  Material material;
  material.diffuse = Eigen::Vector4f(row->diffuse.data());
  material.ambient = ambientOf(*row);
  material.specular = Eigen::Vector3f(row->specular.data());
  material.shininess = row->shininess;
  material.roughness = roughnessOfShininess(row->shininess);
  if (row->finish == Finish::kGlow) material.emissive = material.diffuse.head<3>();
  material.lit = row->finish != Finish::kUnlit;
  material.double_sided = row->finish == Finish::kTwoSided;
  if (row->picture != nullptr) material.texture = pictureOf(*row, textures);
  material.texture_scale.setConstant(row->scale);
  return material;
}

std::string nearGazeboMaterial(const std::string& name) {
  std::vector<std::string> names;
  for (const Row& row : kRows) names.push_back(kPrefix + row.name);
  return didYouMean(name, names);
}

}  // namespace synthetic_dataset::world
