#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/random/distribution.h"
#include "base/random/weighted_index.h"
#include "randomize/appearance/room_options.h"
#include "randomize/placement/placement_options.h"

namespace synthetic_dataset::randomize {

/// How a picture lies behind the world.
enum class BackgroundProjection {
  kBackdrop,  ///< it fills every image, whatever the camera looks at
  kPanorama,  ///< it lies around the world: equirectangular, all of the sky and the ground
};

/// Pictures of which one is seen where nothing is.
struct BackgroundPictures {
  std::string folder;             ///< absolute
  std::optional<double> present;  ///< how likely there is one, 0 .. 1; nothing: always
  BackgroundProjection projection = BackgroundProjection::kBackdrop;
  std::optional<base::Distribution> yaw;  ///< of a panorama: where its middle lies, from x to y
                                          ///< of the global frame [rad]; nothing: along x
  std::optional<base::Distribution> brightness;  ///< times the picture's light, >= 0
};

/// What is drawn anew of what is seen where nothing is; nothing: as the world has it.
struct BackgroundRandomization {
  /// sRGB-encoded red, green, blue, 0 .. 1; beside pictures, of the scenes without one.
  std::optional<base::Distribution> colour;
  std::string colour_name = "background";  ///< of its entry, below `randomize`
  std::optional<BackgroundPictures> pictures;
};

/// What is drawn anew of a light; nothing: as the world has it.
struct LightRandomization {
  std::optional<double> present;                ///< how likely it is on, 0 .. 1
  std::optional<base::Distribution> intensity;  ///< times that of the world, >= 0
  std::optional<base::Distribution> colour;     ///< linear red, green, blue, >= 0, instead
  std::optional<base::Distribution> elevation;  ///< sunlight comes from there, above the horizon
                                                ///< [rad]
  std::optional<base::Distribution> azimuth;    ///< sunlight comes from there, from x to y [rad]
  std::optional<base::Distribution> shift;      ///< of a light, in the global frame [m]
};

/// What is drawn anew of materials; nothing: as the models have it.
struct MaterialRandomization {
  bool for_each_visual = true;                  ///< else one draw serves the whole model
  std::optional<base::Distribution> colour;     ///< sRGB-encoded red, green, blue, 0 .. 1
  std::optional<base::Distribution> tint;       ///< times the colour that it has; 0 .. 1
  std::optional<base::Distribution> roughness;  ///< 0 .. 1
  std::optional<base::Distribution> metalness;  ///< 0 .. 1
  std::optional<std::string> textures;          ///< `procedural`, or an absolute folder of pictures
};

/// What is made of an object's model, so that a network does not learn that one by heart.
enum class Variety {
  kNone,
  kSameObject,  ///< the same thing, worn: its shape and its pattern stay
  kSameClass,   ///< other things of its kind: in other proportions, colours and patterns
};

struct VarietyOptions {
  Variety variety = Variety::kNone;
  int variants = 12;  ///< how many are made, the model as it is among them
};

/// What is drawn anew of an object; nothing: as `robot_list` and its group have it.
struct ObjectRandomization {
  std::optional<double> present;            ///< how likely it is there, 0 .. 1
  std::optional<base::TextChoice> model;    ///< absolute paths or URIs, instead of its own; of a
                                            ///< folder that holds models, one of them
  std::optional<base::Distribution> scale;  ///< times the model's size, > 0
  int sizes = 8;  ///< how many sizes are made of what `scale` draws, unless that is a few values
  std::optional<VarietyOptions> variety;  ///< nothing: as Randomization has it
};

/// What is drawn anew of a camera's sensor and lens; nothing: as `effects` and the calibration have
/// it.
struct SensorRandomization {
  std::optional<base::Distribution> exposure;       ///< [stops]
  std::optional<base::Distribution> blur;           ///< [px], >= 0
  std::optional<base::Distribution> noise_stddev;   ///< of the full scale, 0 .. 1
  std::optional<base::Distribution> white_balance;  ///< of the light that it is set for [K]
  std::optional<base::Distribution> jpeg_quality;   ///< that it compresses with, 1 .. 100; rounded

  /// Horizontal, of the lens without its distortion's coefficients [rad]; instead of that of the
  /// calibration.
  std::optional<base::Distribution> field_of_view;
};

/// What is drawn anew of the air, and of dust; nothing: none of it.
struct WeatherRandomization {
  std::optional<double> present;  ///< how likely there is any, 0 .. 1; nothing: always
  std::optional<base::Distribution> visibility;  ///< in fog [m], > 0
  std::optional<base::Distribution> rain;        ///< [mm/h], >= 0
  std::optional<base::Distribution> snow;        ///< of the water that it melts to [mm/h], >= 0
  std::optional<base::Distribution> wind;        ///< in the global frame [m/s]
  std::optional<base::Distribution> colour;      ///< of fog, drops and flakes; sRGB-encoded red,
                                                 ///< green, blue, 0 .. 1

  /// On each camera's glass: the share of it that is covered, 0 .. 0.2; there whether there is
  /// anything else or not.
  std::optional<base::Distribution> dust;

  [[nodiscard]] bool changesAir() const { return visibility || rain || snow; }
};

/// In the groups of lights and objects: those that have no group of their own.
inline const char* const kOthers = "every";

/// Everything that differs from scene to scene so that a network does not learn it. Each entry's
/// draws follow from the seed, the scene and the entry's name alone.
struct Randomization {
  std::map<std::string, LightRandomization> lights;  ///< by the world's names; `every`: others
  std::optional<base::Distribution> light_count;     ///< how many of the lights are on, rounded;
                                                     ///< nothing: as each one's `present` says
  std::optional<base::Distribution> ambient;         ///< sRGB-encoded red, green, blue
  BackgroundRandomization background;
  std::map<std::string, MaterialRandomization> materials;  ///< by model, model::link or
                                                           ///< model::link::visual; `objects`,
                                                           ///< `world`: all of these
  std::map<std::string, ObjectRandomization> objects;      ///< by their names; `every`: others
  std::optional<base::Distribution> object_count;          ///< how many of them are there, rounded;
                                                           ///< nothing: as each one's `present`
                                                           ///< says
  VarietyOptions variety;                                  ///< of objects that say nothing of it
  std::optional<RoomOptions> room;                         ///< beside what the world has
  std::optional<randomize::DistractorOptions> distractors;
  SensorRandomization sensor;  ///< of each camera
  WeatherRandomization weather;

  /// How much later than the regular timeline has it a scene of a recording is [s]; below 0
  /// earlier.
  std::optional<base::Distribution> time_jitter;

  /// What is drawn of an object; its variety is there.
  [[nodiscard]] ObjectRandomization ofObject(const std::string& name) const {
    auto entry = objects.find(name);
    if (entry == objects.end()) entry = objects.find(kOthers);
    ObjectRandomization object = entry == objects.end() ? ObjectRandomization{} : entry->second;
    if (!object.variety) object.variety = variety;
    return object;
  }

  [[nodiscard]] bool changesLook() const {
    return !lights.empty() || light_count || !materials.empty() || ambient || background.colour ||
           background.pictures;
  }
};

}  // namespace synthetic_dataset::randomize
