#pragma once

/// A description of the world that is independent of file formats: what SDF, URDF and mesh files
/// become before anything is rendered or simulated. Frames: W world (= global_frame), M model, L
/// link, V visual, C collision. SI units.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"
#include "world/world_options.h"

namespace synthetic_dataset::world {

/// Triangles with a normal and a texture coordinate at each vertex.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;  ///< [m], in the visual's frame, scale applied
  std::vector<Eigen::Vector3f> normals;    ///< unit length, one per position
  std::vector<Eigen::Vector2f>
      texture_coordinates;  ///< v = 0 is the texture's first row; one per position, or empty
  std::vector<Eigen::Vector4f> colours;  ///< sRGB-encoded red, green, blue, and alpha, by which the
                                         ///< material is multiplied; one per position, or empty
  std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise seen from outside
};

/// A decoded picture, shared by all materials that name its file.
struct Texture {
  std::string file;  ///< where it came from, for messages
  cv::Mat pixels;    ///< CV_8UC4, blue green red alpha, sRGB, first row on top
                     ///< A background may be CV_32FC4: linear light, 0 .. 65504, 1 for white
};

/// Colours as the files give them: sRGB-encoded red, green, blue (0..1); alpha 1 is opaque. The
/// defaults apply to properties that a file's material does not specify.
struct Material {
  Eigen::Vector4f diffuse{1.0F, 1.0F, 1.0F, 1.0F};  ///< times the texture's colour
  Eigen::Vector3f ambient{1.0F, 1.0F, 1.0F};  ///< Classic: factor on the scene's ambient light.
                                              ///< gz-sim uses the diffuse colour instead
  Eigen::Vector3f specular{0.1F, 0.1F, 0.1F};
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};
  float shininess = 0.0F;  ///< Classic: Blinn-Phong exponent; 0: no highlight
  float roughness = 0.6F;  ///< gz-sim: 0 mirror .. 1 chalk
  float metalness = 0.0F;  ///< gz-sim: 0 to 1

  std::shared_ptr<const Texture> texture;        ///< null: only the diffuse colour
  std::shared_ptr<const Texture> normal_map;     ///< linear; x right, y up (the OpenGL convention)
  std::shared_ptr<const Texture> roughness_map;  ///< linear; its green channel, times `roughness`
  std::shared_ptr<const Texture> metalness_map;  ///< linear; its blue channel, times `metalness`
  std::shared_ptr<const Texture> emissive_map;   ///< sRGB-encoded, times `emissive`
  Eigen::Vector2f texture_scale{1.0F, 1.0F};     ///< texture coordinates are multiplied by this,
  Eigen::Vector2f texture_offset{0.0F, 0.0F};    ///< then this is added

  float alpha_threshold = 0.5F;   ///< a texture alpha below this makes a hole
  bool texture_is_glass = false;  ///< the texture's alpha blends (no holes), like that of `diffuse`
  bool double_sided = false;
  bool lit = true;  ///< false: shown in its own colour, whatever the lights

  bool is_default = false;  ///< no file gives it; see defaultMaterial()

  /// A see-through material drawn over this one on the same triangles, such as the lines on a
  /// playing field.
  std::shared_ptr<const Material> overlay;
};

/// The material of a surface to which no file gives one. World paints it like the simulator that
/// the world was written for: white for Gazebo Classic, grey for gz-sim.
[[nodiscard]] inline Material defaultMaterial() {
  Material material;
  material.is_default = true;
  return material;
}

/// A mesh with a single material.
struct Surface {
  std::shared_ptr<const Mesh> mesh;
  Material material;
};

struct Visual {
  std::string name;
  Pose X_LV = Pose::Identity();
  std::vector<Surface> surfaces;
  bool casts_shadow = true;
};

struct BoxShape {
  Eigen::Vector3d size;  ///< full lengths along x, y, z
};
struct SphereShape {
  double radius;
};
struct CylinderShape {  ///< axis along z, centred at the origin
  double radius;
  double length;
};
struct PlaneShape {  ///< infinite, through the origin; solid on the side away from the normal
  Eigen::Vector3d normal;
};
struct MeshShape {
  std::shared_ptr<const Mesh> mesh;
};
using Shape = std::variant<BoxShape, SphereShape, CylinderShape, PlaneShape, MeshShape>;

struct Collision {
  std::string name;
  Pose X_LC = Pose::Identity();
  Shape shape;
  double friction = 1.0;     ///< Coulomb friction coefficient mu
  double restitution = 0.0;  ///< 0 .. 1
};

struct Inertia {
  double mass = 1.0;  ///< [kg], > 0
  Eigen::Vector3d centre_of_mass_L{0, 0, 0};
  Eigen::Matrix3d moments_L = Eigen::Matrix3d::Identity();  ///< about the centre of mass [kg m^2]
};

/// How a joint moves a link relative to its parent.
struct JointMotion {
  struct Mimic {
    std::string joint;
    double multiplier = 1.0;
    double offset = 0.0;
  };

  bool slides = false;  ///< true: translates along the axis [m]; false: rotates about it [rad]
  Eigen::Vector3d axis_L{1, 0, 0};  ///< unit length
  double rest = 0.0;                ///< its position in the model's initial pose [m] or [rad]
  std::optional<Mimic> mimic = std::nullopt;  ///< the joint that this one follows
};

struct Link {
  std::string name;  ///< scoped within the model: "arm::wrist"
  Pose X_ML = Pose::Identity();

  /// Index in Model::links of the link to which a joint attaches this one; none for a root.
  std::optional<std::size_t> parent;

  std::string moving_joint;  ///< name of the joint to the parent if it can move, else empty
  std::optional<JointMotion> joint_motion;  ///< of that joint, if it has one axis; only for URDF
  bool has_gravity = true;  ///< false: it floats, as with Gazebo's <gravity>false</gravity>

  std::vector<Visual> visuals;
  std::vector<Collision> collisions;
  std::optional<Inertia> inertia;
  std::optional<int> label;  ///< given by gz-sim's label plugin
};

struct Model {
  std::string name;
  Pose X_WM = Pose::Identity();
  bool is_static = false;
  std::vector<Link> links;  ///< including those of nested models
};

enum class LightType { kDirectional, kPoint, kSpot };

struct Light {
  std::string name;
  LightType type = LightType::kDirectional;
  Pose X_WL = Pose::Identity();
  Eigen::Vector3d direction_L{0, 0, -1};      ///< in which directional and spot lights shine
  Eigen::Vector3f diffuse{1.0F, 1.0F, 1.0F};  ///< linear intensity, may exceed 1
  Eigen::Vector3f specular{0.1F, 0.1F, 0.1F};
  double range = 20.0;                 ///< [m]
  double attenuation_constant = 1.0;   ///< 1 / (constant + linear d + quadratic d^2)
  double attenuation_linear = 0.0;     ///< [1/m]
  double attenuation_quadratic = 0.0;  ///< [1/m^2]
  double spot_inner_angle = 0.0;       ///< full brightness within [rad]
  double spot_outer_angle = 0.0;       ///< dark beyond [rad]
  double spot_falloff = 1.0;
  bool casts_shadow = false;
};

/// Gaussian noise that is added to each channel of each pixel, as a fraction of full scale (1 is
/// from black to white).
struct PixelNoise {
  double mean = 0.0;
  double stddev = 0.0;
};

/// A camera that the world describes (`<sensor type="camera">` and related types).
struct CameraSensor {
  std::string name;              ///< "model::link::sensor", as Gazebo scopes it
  Pose X_WC = Pose::Identity();  ///< the *optical* frame: x right, y down, z forward
  CameraModel camera;            ///< near and far from <clip>, by default 0.05 and 1000 m
  PixelNoise noise;              ///< SDF's <noise>
  std::string link;              ///< the link that carries it, scoped like Link::name
  Pose X_LC = Pose::Identity();  ///< the optical frame in its link, which may move

  /// The name of its model.
  [[nodiscard]] std::string model() const { return name.substr(0, name.find("::")); }
};

/// Rays at equal angular steps from the first angle to the last, both included.
struct RayScan {
  int count = 1;
  double first = 0.0;  ///< [rad]
  double last = 0.0;   ///< [rad]
};

/// A lidar that the world describes (`<sensor type="ray">` and related types), with the values of
/// its file.
struct LidarSensor {
  std::string name;              ///< "model::link::sensor", as Gazebo scopes it
  Pose X_WS = Pose::Identity();  ///< x forward, y left, z up
  std::string link;              ///< the link that carries it, scoped like Link::name
  Pose X_LS = Pose::Identity();  ///< in its link, which may move
  RayScan azimuth;               ///< positive from x towards y
  RayScan elevation;             ///< above the x-y plane
  double min_range = 0.0;        ///< [m]
  double max_range = 0.0;        ///< [m], may be infinite
  double resolution = 0.0;       ///< measured ranges are multiples of it [m]; 0: exact
  double noise = 0.0;            ///< standard deviation of measured ranges [m]
  double update_rate = 0.0;      ///< sweeps per second [Hz]; 0: the file gives none

  /// The name of its model.
  [[nodiscard]] std::string model() const { return name.substr(0, name.find("::")); }
};

enum class FogType { kLinear, kExponential, kSquaredExponential };

/// Fog by distance from the camera: linear between start and end, or 1 - exp(-density d), or
/// 1 - exp(-(density d)^2).
struct Fog {
  FogType type = FogType::kLinear;
  Eigen::Vector3f colour{1.0F, 1.0F, 1.0F};  ///< sRGB-encoded
  double start = 1.0;                        ///< [m]
  double end = 100.0;                        ///< [m]
  double density = 1.0;                      ///< [1/m]
};

/// The sky of SDF's <scene>, seen where nothing else is.
struct Sky {
  double time = 10.0;                               ///< of the day [h]
  double sunrise = 6.0;                             ///< [h]
  double sunset = 20.0;                             ///< [h]
  double cloud_humidity = 0.0;                      ///< 0 clear .. 1 overcast
  double cloud_mean_size = 0.5;                     ///< 0 .. 1
  Eigen::Vector3f cloud_ambient{0.8F, 0.8F, 0.8F};  ///< sRGB-encoded
};

/// A whole world as its files describe it.
struct Description {
  std::vector<Model> models;
  std::vector<Light> lights;
  std::vector<CameraSensor> cameras;
  std::vector<LidarSensor> lidars;
  Simulator simulator = Simulator::kClassic;     ///< the simulator that the world was written for
  Eigen::Vector3f ambient{0.4F, 0.4F, 0.4F};     ///< sRGB-encoded
  Eigen::Vector3f background{0.7F, 0.7F, 0.7F};  ///< sRGB-encoded
  std::optional<Fog> fog;
  std::optional<Sky> sky;                ///< none: the background colour is shown
  Eigen::Vector3d gravity{0, 0, -9.81};  ///< [m/s^2]
  std::vector<std::string> notes;        ///< what was left out or replaced, to tell the user
};

}  // namespace synthetic_dataset::world
