#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "label/captured_view.h"
#include "label/instance_map.h"
#include "label/label_options.h"
#include "label/mask_finder.h"
#include "label/occlusion.h"
#include "render/renderer.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"
#include "world/world.h"

namespace synthetic_dataset::label {

/// How labels are derived from pixels.
struct PixelLabelOptions {
  MaskOptions masks;
  LabelOptions labels;
  std::vector<std::uint16_t> class_numbers;  ///< of the objects: their values in Scene::class_map
  std::vector<std::uint16_t> world_classes;  ///< of the links: their values in Scene::world_map
  std::vector<std::uint16_t> parts;          ///< of the links: their values in Scene::part_map

  /// How far in front of an object something has to be measured to hide it; nothing if nothing is
  /// measured.
  std::optional<OcclusionMargin> occlusion = std::nullopt;
};

/// What is kept of a scene's pixels until it is known where the points that they show move to.
struct SeenSurface {
  cv::Mat depth;
  cv::Mat range;
  cv::Mat links;
};

/// Whether labels need to know what each pixel shows. If not, it is unknown what hides an object.
[[nodiscard]] bool looksAtPixels(const Requirements& requirements, const MaskOptions& masks,
                                 const LabelOptions& labels);

/// How well each object's visible mask from background subtraction agrees with the exact one:
/// intersection over union; nothing for an object that the exact masks do not show. Empty if
/// nothing was subtracted.
using MaskAgreement = std::vector<std::optional<double>>;

/// What is known about a scene's labels besides the labels themselves.
struct LabelFindings {
  MaskAgreement agreement;
  std::vector<ObjectCover> covers;  ///< of each object; empty if nothing was measured
};

/// Adds the labels that follow from what was seen. May be called in any thread, as long as the
/// labeller and the renderer live.
/// @param measured  CV_32FC1: the distance from the camera's centre at which something was measured
///     along each pixel's ray [m], 0 where nothing was; surfaces of the world behind it are not
///     seen. Empty if nothing was measured
using PendingLabels = std::function<LabelFindings(Scene&, const cv::Mat& measured)>;

/// The keypoints of each object in the optical frame [m]; empty for an object that is not in the
/// scene.
using PlacedKeypoints = std::vector<std::vector<Eigen::Vector3d>>;

/// What was seen in a scene.
struct SeenPixels {
  SeenSurface surface;  ///< what the optical flow needs; empty unless that is required
  PendingLabels labels;
};

/// Labels that follow from one camera's pixels: masks, measures, occlusion, maps. Computes only
/// what the requirements ask for.
class PixelLabeller {
 public:
  /// All references have to outlive this.
  PixelLabeller(const world::World& world, render::Renderer& renderer, std::size_t object_count,
                const Requirements& requirements, const PixelLabelOptions& options);

  /// Draws the images that labels are derived from, and adds the first labels.
  /// @param scene  whose objects have all labels that follow from their poses; if rows are taken
  ///     one after the other, these are replaced by those of the rows' times
  [[nodiscard]] SeenPixels look(const CapturedView& view, Scene& scene);

 private:
  void addImages(const render::LabelImages& images, Scene& scene) const;
  void measureSilhouettes(const CapturedView& view, Scene& scene);
  [[nodiscard]] LabelFindings labelPixels(render::LabelImages images, const PendingMasks& masks,
                                          const PlacedKeypoints& keypoints, const cv::Mat& measured,
                                          Scene& scene) const;
  void cut(const cv::Mat& covered, const cv::Mat& measured, render::LabelImages& images,
           Scene& scene) const;
  [[nodiscard]] MaskAgreement addMasks(const cv::Mat& ids, const cv::Mat& covered,
                                       const PendingMasks& subtracted, Scene& scene) const;
  void addVisibleParts(const cv::Mat& instance_map, const std::vector<label::InstancePixels>& parts,
                       Scene& scene) const;
  void addKeypointStates(const render::LabelImages& images, bool has_ranges,
                         const PlacedKeypoints& keypoints, Scene& scene) const;
  void drop(Scene& scene) const;
  [[nodiscard]] bool usesSubtraction() const;

  const world::World& world_;
  render::Renderer& renderer_;
  Requirements requirements_;
  PixelLabelOptions options_;
  bool needs_labels_ = false;       ///< the renderer's identifiers and depths
  bool needs_silhouettes_ = false;  ///< drawn object by object
  render::LabelPass pass_;
  std::vector<render::LinkSelection> links_of_;  ///< of each object
  MaskFinder finder_;
};

}  // namespace synthetic_dataset::label
