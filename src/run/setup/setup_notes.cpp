#include "run/setup/setup_notes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "label/pixel_labeller.h"
#include "scene/object_shapes.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

void noteEmptySplits(RunSetup& setup) {
  if (setup.instantCount() == 0) return;
  for (const SplitInfo& split : setup.splits->splits(setup.config.cameras.size())) {
    if (split.scene_count > 0) continue;
    setup.diagnostics.warning("split/" + split.name, "no scene falls into it");
  }
}

/// Notes that there are exact masks, as users of nn_data_collection's settings may not know.
void noteSubtraction(RunSetup& setup) {
  const label::MaskOptions& masks = setup.config.masks;
  if (masks.method == label::MaskMethod::kExact || masks.method_is_given) return;
  if (!setup.writers->requirements().visible_masks) return;
  setup.diagnostics.warning(
      "",
      "masks are found by background subtraction since background_subtractor is "
      "set; masks/method: exact gives exact ones");
}

/// Notes that occlusion is not determined, since that is only done if a writer asks for it.
void noteUnseen(RunSetup& setup) {
  const config::Config& config = setup.config;
  const Requirements& requirements = setup.writers->requirements();
  if (requirements.silhouettes) return;  // a mask format, which handles pixels in its own way
  if (label::looksAtPixels(requirements, config.masks, config.labels)) return;
  setup.diagnostics.note("",
                         "no writer of this run asks which pixels show an object: a hidden one is "
                         "labelled as if it were seen (labels/min_pixels: 1 leaves it out)");
}

/// Noise on a picture that no format of this run writes is a mistake.
void noteUnusedDepthNoise(RunSetup& setup) {
  if (setup.writers->requirements().depth) return;
  for (const scene::CameraOptions& camera : setup.config.cameras) {
    if (camera.depth_noise.model == render::DepthModel::kExact) continue;
    setup.diagnostics.warning(camera.group + "/depth_noise",
                              "no format of this run writes depth, so it has no effect");
  }
}

/// Warns of shutters without effect: placed scenes stand still, and only raindrops and snowflakes
/// would move.
void noteIdleShutters(RunSetup& setup) {
  const bool all_are_placed =
      std::all_of(setup.motions.begin(), setup.motions.end(),
                  [](const MotionSetup& motion) { return motion.config.isPlaced(); });
  const auto& weather = setup.config.randomization.weather;
  if (!all_are_placed || weather.rain || weather.snow) return;
  for (const scene::CameraOptions& camera : setup.config.cameras) {
    const scene::Shutter& shutter = camera.shutter;
    if (shutter.exposure_time.count() == 0 && shutter.readout_time.count() == 0) continue;
    setup.diagnostics.warning(
        camera.group + "/effects",
        "exposure_time and readout_time have no effect, as placed scenes stand still");
  }
}

/// A larger factor than this is never intended.
constexpr double kStrange = 4.0;

double diagonal(const Cuboid& box) { return box.size().norm(); }

/// How far a point is from a box [m].
double distanceTo(const Cuboid& box, const Eigen::Vector3d& point) {
  return (point - point.cwiseMax(box.low).cwiseMin(box.high)).norm();
}

std::string metres(double length) { return fixed(length, 3) + " m"; }

}  // namespace

void noteSurprisingSettings(RunSetup& setup) {
  if (setup.splits) noteEmptySplits(setup);
  noteIdleShutters(setup);
  if (!setup.writers) return;
  noteSubtraction(setup);
  noteUnseen(setup);
  noteUnusedDepthNoise(setup);
  for (const std::string& each : setup.writers->warnings()) setup.diagnostics.warning("", each);
}

void checkSizes(const scene::ObjectOptions& object, const Cuboid& box_O,
                base::Diagnostics& diagnostics) {
  const double model = diagonal(box_O);
  if (!object.bounding_shape_O.empty()) {
    const Cuboid given = scene::boxAround(object.bounding_shape_O);
    const double reach = diagonal(given);
    if (reach > kStrange * model || model > kStrange * reach) {
      diagnostics.warning(object.name + "/bounding_shape", "its points span " + metres(reach) +
                                                               ", the model " + metres(model) +
                                                               " (are they in metres?)");
    } else if (distanceTo(box_O, given.centre()) > model) {
      diagnostics.warning(object.name + "/bounding_shape",
                          "its middle is " + metres(distanceTo(box_O, given.centre())) +
                              " away from the model (are its points in the frame of the object?)");
    }
  }
  double farthest = 0.0;
  for (const Eigen::Vector3d& point : object.keypoints_O) {
    farthest = std::max(farthest, distanceTo(box_O, point));
  }
  constexpr double kOutside = 0.25;  // of the model's size; an antenna's tip may be missing from it
  if (farthest > kOutside * model) {
    diagnostics.warning(object.name + "/keypoints",
                        "one is " + metres(farthest) + " away from the model, which spans " +
                            metres(model) +
                            " (are they in metres, and in the frame of the object?)");
  }
}

void noteStrangeLens(const scene::CameraOptions& camera, const CameraModel& model,
                     base::Diagnostics& diagnostics) {
  constexpr double kLittle = 0.25;  // a fisheye's circle in a wide image fills more than this
  if (const double share = scene::seenShare(model); share < kLittle) {
    diagnostics.warning(camera.group,
                        "its lens sees something in only " + fixed(100.0 * share, 0) +
                            " % of the image; the rest is black (are the distortion's numbers "
                            "right?)");
  }
  // Only crops of a sensor's picture may have a principal point far from the centre.
  constexpr double kFar = 0.2;  // of the image's size
  const double across = model.intrinsics().cx + 0.5 - 0.5 * model.width();
  const double down = model.intrinsics().cy + 0.5 - 0.5 * model.height();
  if (std::abs(across) <= kFar * model.width() && std::abs(down) <= kFar * model.height()) return;
  diagnostics.warning(camera.group, "the principal point (" + fixed(model.intrinsics().cx, 1) +
                                        ", " + fixed(model.intrinsics().cy, 1) +
                                        ") is far from the middle of an image of " +
                                        std::to_string(model.width()) + " x " +
                                        std::to_string(model.height()) +
                                        " (is the calibration that of another resolution?)");
}

}  // namespace synthetic_dataset::run
