#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "label/instance_map.h"
#include "label/label_options.h"
#include "label/mask_finder.h"
#include "label/occlusion.h"
#include "label/taken_view.h"
#include "render/renderer.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"
#include "world/world.h"

namespace synthetic_dataset::label {

/// How labels are taken from pixels.
struct PixelLabelOptions {
  MaskOptions masks;
  LabelOptions labels;
  std::vector<std::uint16_t> class_numbers;  ///< of the objects: their values in Scene::class_map
  std::vector<std::uint16_t> world_classes;  ///< of the links: their values in Scene::world_map
  std::vector<std::uint16_t> parts;          ///< of the links: their values in Scene::part_map

  /// Where something was measured in front of an object, this says from which distance on it hides
  /// that; nothing where nothing is measured.
  std::optional<OcclusionMargin> occlusion = std::nullopt;
};

/// What is kept of a scene's pixels until it is known where they go.
struct SeenSurface {
  cv::Mat depth;
  cv::Mat range;
  cv::Mat links;
};

/// Whether labels need to know what each pixel shows. Else nobody knows what hides an object.
[[nodiscard]] bool looksAtPixels(const Requirements& requirements, const MaskOptions& masks,
                                 const LabelOptions& labels);

/// How well each object's visible mask of background subtraction agrees with the exact one:
/// intersection over union, nothing where there is neither. Empty where nothing was subtracted.
using MaskAgreement = std::vector<std::optional<double>>;

/// What is known of a scene's labels beside them.
struct LabelFindings {
  MaskAgreement agreement;
  std::vector<ObjectCover> covers;  ///< of each object; empty where nothing was measured
};

/// Adds the labels that follow from what has been seen; in any thread, as long as the labeller and
/// the renderer live.
/// @param measured  CV_32FC1: at what distance from the camera's centre something was measured
/// along
///     each pixel's ray [m], 0 where nothing was; what the world has behind it is not seen. Empty:
///     nothing was measured
using PendingLabels = std::function<LabelFindings(Scene&, const cv::Mat& measured)>;

/// Of each object, its keypoints in the optical frame [m]; empty for one that is not in the scene.
using PlacedKeypoints = std::vector<std::vector<Eigen::Vector3d>>;

/// What was seen for a scene.
struct SeenPixels {
  SeenSurface surface;  ///< what its optical flow needs; empty unless that is required
  PendingLabels labels;
};

/// Labels that follow from one camera's pixels: masks, measures, what hides what, maps. Computes
/// what the requirements ask for, and nothing else.
class PixelLabeller {
 public:
  /// All references have to outlive this.
  PixelLabeller(const world::World& world, render::Renderer& renderer, std::size_t object_count,
                const Requirements& requirements, const PixelLabelOptions& options);

  /// Draws what labels are taken from, and adds the first of them.
  /// @param scene  whose objects have all labels that follow from their poses; where rows are taken
  ///     one after the other, they get those of the rows' times
  [[nodiscard]] SeenPixels look(const TakenView& view, Scene& scene);

 private:
  void addImages(const render::LabelImages& images, Scene& scene) const;
  void measureSilhouettes(const TakenView& view, Scene& scene);
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
