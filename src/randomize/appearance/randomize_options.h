#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/random/distribution.h"
#include "base/random/weighted_index.h"
#include "randomize/appearance/room_options.h"
#include "randomize/placement/placement_options.h"

namespace synthetic_dataset::randomize {

/// How a picture is placed behind the world.
enum class BackgroundProjection {
  kBackdrop,  ///< fills every image, whatever the camera looks at
  kPanorama,  ///< surrounds the world: equirectangular, covering all of the sky and the ground
};

/// Pictures for the background, one of which is shown at a time.
struct BackgroundPictures {
  std::string folder;             ///< absolute, or `natural`
  std::optional<double> present;  ///< probability that there is one, 0 .. 1; always if not set
  BackgroundProjection projection = BackgroundProjection::kBackdrop;
  std::optional<base::Distribution> yaw;  ///< for a panorama: direction of its middle, from x to y
                                          ///< of the global frame [rad]; along x if not set
  std::optional<base::Distribution> brightness;  ///< factor on the picture's light, >= 0
};

/// What is randomized about the background; whatever is not set stays as in the world.
struct BackgroundRandomization {
  /// sRGB-encoded red, green, blue, 0 .. 1; if there are pictures, for the scenes without one.
  std::optional<base::Distribution> colour;
  std::string colour_name = "background";  ///< of its entry in `randomize`
  std::optional<BackgroundPictures> pictures;
};

/// What is randomized about a light; whatever is not set stays as in the world.
struct LightRandomization {
  std::optional<double> present;                ///< probability that it is on, 0 .. 1
  std::optional<base::Distribution> intensity;  ///< factor on that of the world, >= 0
  std::optional<base::Distribution> colour;     ///< linear red, green, blue, >= 0; replaces its own
  std::optional<base::Distribution> elevation;  ///< of the sun above the horizon [rad]
  std::optional<base::Distribution> azimuth;    ///< of the sun, from x to y [rad]
  std::optional<base::Distribution> shift;      ///< of a light's position, in the global frame [m]
};

/// What is randomized about materials; whatever is not set stays as in the models.
struct MaterialRandomization {
  bool for_each_visual = true;                  ///< otherwise one draw is used for the whole model
  std::optional<base::Distribution> colour;     ///< sRGB-encoded red, green, blue, 0 .. 1
  std::optional<base::Distribution> tint;       ///< factor on its own colour; 0 .. 1
  std::optional<base::Distribution> roughness;  ///< 0 .. 1
  std::optional<base::Distribution> metalness;  ///< 0 .. 1
  std::optional<std::string> textures;          ///< `procedural`, `natural` or an absolute folder
};

/// How an object's model is varied, so that a network does not learn that one by heart.
enum class Variety {
  kNone,
  kSameObject,  ///< the same thing, worn: shape and pattern stay
  kSameClass,   ///< other things of its kind, with other proportions, colours and patterns
};

struct VarietyOptions {
  Variety variety = Variety::kNone;
  int variants = 12;  ///< number of variants, including the unchanged model
};

/// What is randomized about an object; whatever is not set stays as in `robot_list` and its group.
struct ObjectRandomization {
  std::optional<double> present;            ///< probability that it is present, 0 .. 1
  std::optional<base::TextChoice> model;    ///< absolute paths or URIs that replace its own; for a
                                            ///< folder of models, one of them is drawn
  std::optional<base::Distribution> scale;  ///< factor on the model's size, > 0
  int sizes = 8;  ///< how many sizes are made of what `scale` draws, unless it has few values
  std::optional<VarietyOptions> variety;  ///< as in Randomization if not set
};

/// What is randomized about a camera's sensor and lens; whatever is not set stays as in `effects`
/// and the calibration.
struct SensorRandomization {
  std::optional<base::Distribution> exposure;       ///< [stops]
  std::optional<base::Distribution> blur;           ///< [px], >= 0
  std::optional<base::Distribution> noise_stddev;   ///< as a fraction of full scale, 0 .. 1
  std::optional<base::Distribution> white_balance;  ///< colour temperature that it is set for [K]
  std::optional<base::Distribution> jpeg_quality;   ///< of the compression, 1 .. 100; rounded

  /// Horizontal field of view of the lens, ignoring its distortion coefficients [rad]; replaces
  /// that of the calibration.
  std::optional<base::Distribution> field_of_view;
};

/// What is randomized about the air, and dust; whatever is not set is absent.
struct WeatherRandomization {
  std::optional<double> present;  ///< probability that there is any, 0 .. 1; always if not set
  std::optional<base::Distribution> visibility;  ///< in fog [m], > 0
  std::optional<base::Distribution> rain;        ///< [mm/h], >= 0
  std::optional<base::Distribution> snow;        ///< as liquid water [mm/h], >= 0
  std::optional<base::Distribution> wind;        ///< in the global frame [m/s]
  std::optional<base::Distribution> colour;      ///< of fog, drops and flakes; sRGB-encoded red,
                                                 ///< green, blue, 0 .. 1

  /// Dust on each camera's glass: the share that is covered, 0 .. 0.2; independent of the rest.
  std::optional<base::Distribution> dust;

  [[nodiscard]] bool changesAir() const { return visibility || rain || snow; }
};

/// Group name for the lights and objects that have no group of their own.
inline const char* const kOthers = "every";

/// Everything that is varied between scenes so that a network does not learn it. Each entry's draws
/// depend only on the seed, the scene and the entry's name.
struct Randomization {
  std::map<std::string, LightRandomization> lights;  ///< by the world's names; `every`: the others
  std::optional<base::Distribution> light_count;     ///< number of lights that are on, rounded; if
                                                     ///< not set, as given by each one's `present`
  std::optional<base::Distribution> ambient;         ///< sRGB-encoded red, green, blue
  BackgroundRandomization background;
  std::map<std::string, MaterialRandomization> materials;  ///< by model, model::link or
                                                           ///< model::link::visual; `objects`,
                                                           ///< `world`, `distractors`: all of those
  std::map<std::string, ObjectRandomization> objects;      ///< by their names; `every`: the others
  std::optional<base::Distribution> object_count;          ///< number of them that are present,
                                                           ///< rounded; if not set, as given by
                                                           ///< each one's `present`
  VarietyOptions variety;                                  ///< for objects without their own
  std::optional<RoomOptions> room;                         ///< in addition to what the world has
  std::optional<randomize::DistractorOptions> distractors;
  SensorRandomization sensor;  ///< for each camera
  WeatherRandomization weather;

  /// How much later than in the regular timeline a scene of a recording is [s]; negative for
  /// earlier.
  std::optional<base::Distribution> time_jitter;

  /// What is randomized about an object; its variety is always set.
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
