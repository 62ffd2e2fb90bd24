#include "label/pixel_labeller.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "label/keypoint_states.h"
#include "label/object_links.h"
#include "render/lens/lens_map.h"

namespace synthetic_dataset::label {
namespace {

/// Maps each pixel to the number of the link that it shows; 0 where there is nothing. CV_16UC1.
/// @param links  CV_32SC1: a link's index + 1, 0 for nothing
/// @param numbers  of the links, in the links' order
cv::Mat mapOfLinks(const cv::Mat& links, const std::vector<std::uint16_t>& numbers) {
  cv::Mat map(links.size(), CV_16UC1);
  for (int row = 0; row < links.rows; ++row) {
    const auto* from = links.ptr<std::int32_t>(row);
    std::transform(from, from + links.cols, map.ptr<std::uint16_t>(row), [&](std::int32_t link) {
      return link == 0 ? std::uint16_t{0} : numbers[static_cast<std::size_t>(link) - 1];
    });
  }
  return map;
}

/// Distances of the drawn surfaces from the camera's centre [m], 0 where there is nothing.
cv::Mat rangesOf(const render::LabelImages& images, const CameraModel& camera) {
  if (render::hasDistortion(camera)) return images.range.clone();
  const Intrinsics& k = camera.intrinsics();
  cv::Mat_<float> ranges(images.depth.size());
  for (int row = 0; row < ranges.rows; ++row) {
    for (int column = 0; column < ranges.cols; ++column) {
      const Eigen::Vector3d ray((column - k.cx) / k.fx, (row - k.cy) / k.fy, 1.0);
      ranges(row, column) =
          static_cast<float>(double{images.depth.at<float>(row, column)} * ray.norm());
    }
  }
  return std::move(ranges);
}

PlacedKeypoints placedKeypoints(const CapturedView& view, Scene& scene) {
  if (view.rows() != nullptr) return labelInRows(*view.rows(), scene);
  PlacedKeypoints placed;
  for (const SceneObject& object : scene.objects) {
    std::vector<Eigen::Vector3d>& here = placed.emplace_back();
    if (!object.X_CO) continue;
    for (const Eigen::Vector3d& p_O : object.keypoints_O) here.push_back(*object.X_CO * p_O);
  }
  return placed;
}

/// The map with 0 at covered pixels.
cv::Mat without(const cv::Mat& covered, const cv::Mat& map) {
  cv::Mat rest = map.clone();
  rest.setTo(0, covered);
  return rest;
}

}  // namespace

bool looksAtPixels(const Requirements& requirements, const MaskOptions& masks,
                   const LabelOptions& labels) {
  return requirements.visible_masks || requirements.class_map || requirements.visibility ||
         requirements.keypoint_states || requirements.depth || requirements.normals ||
         requirements.optical_flow || requirements.world_map || requirements.part_map ||
         labels.hasThresholds() || (requirements.silhouettes && masks.method == MaskMethod::kMog2);
}

PixelLabeller::PixelLabeller(const world::World& world, render::Renderer& renderer,
                             std::size_t object_count, const Requirements& requirements,
                             const PixelLabelOptions& options)
    : world_(world),
      renderer_(renderer),
      requirements_(requirements),
      options_(options),
      pass_{render::LinkSelection(world.links().size(), true)},
      finder_(world, renderer, object_count, options.masks.mog2, options.masks.clean) {
  Requirements& needed = requirements_;
  needed.visible_masks = needed.visible_masks || needed.class_map;
  needed.visibility = needed.visibility || options_.labels.min_visibility > 0.0;
  needs_labels_ = looksAtPixels(requirements, options.masks, options.labels);
  needs_silhouettes_ = needed.visibility || (needed.silhouettes && !usesSubtraction());
  pass_.links = needed.optical_flow || needed.world_map || needed.part_map;
  pass_.normals = needed.normals;
  for (std::size_t i = 0; i < object_count; ++i) {
    links_of_.push_back(linksOf(static_cast<int>(i), world.links()));
  }
}

bool PixelLabeller::usesSubtraction() const { return options_.masks.method == MaskMethod::kMog2; }

SeenPixels PixelLabeller::look(const CapturedView& view, Scene& scene) {
  pass_.drawn = view.present();
  // Without distortion, the distances that keypoint states need follow from the depths.
  pass_.range =
      requirements_.optical_flow || ((requirements_.keypoint_states || options_.occlusion) &&
                                     render::hasDistortion(view.camera()));
  PlacedKeypoints keypoints = placedKeypoints(view, scene);
  const render::LabelImages images =
      needs_labels_ ? view.labels(pass_, renderer_) : render::LabelImages();
  // Only after drawing the labels, when the renderer already knows most silhouettes.
  if (needs_silhouettes_) measureSilhouettes(view, scene);
  if (!needs_labels_) {
    return {{}, [](Scene&, const cv::Mat& /*measured*/) { return LabelFindings(); }};
  }
  addImages(images, scene);
  const bool has_masks = requirements_.silhouettes || requirements_.visible_masks;
  PendingMasks masks =
      has_masks && usesSubtraction() ? finder_.find(view, scene.objects) : PendingMasks();
  SeenPixels seen;
  if (requirements_.optical_flow) seen.surface = {images.depth, images.range, images.links};
  seen.labels = [this, images, masks = std::move(masks), keypoints = std::move(keypoints)](
                    Scene& labelled, const cv::Mat& measured) {
    return labelPixels(images, masks, keypoints, measured, labelled);
  };
  return seen;
}

LabelFindings PixelLabeller::labelPixels(render::LabelImages images, const PendingMasks& masks,
                                         const PlacedKeypoints& keypoints, const cv::Mat& measured,
                                         Scene& scene) const {
  LabelFindings findings;
  cv::Mat covered;
  if (options_.occlusion && !measured.empty()) {
    images.range = rangesOf(images, scene.camera);
    covered = coveredPixels(images.range, measured, *options_.occlusion);
  }
  if (options_.occlusion) {
    findings.covers = objectCovers(images.ids, measured, covered, scene.objects.size());
  }
  if (!covered.empty()) cut(covered, measured, images, scene);
  findings.agreement = addMasks(images.ids, covered, masks, scene);
  if (requirements_.keypoint_states) {
    const bool has_ranges = !covered.empty() || render::hasDistortion(scene.camera);
    addKeypointStates(images, has_ranges, keypoints, scene);
  }
  drop(scene);
  return findings;
}

/// Removes hidden pixels from the drawn images, and replaces their ranges by the measured ones.
void PixelLabeller::cut(const cv::Mat& covered, const cv::Mat& measured,
                        render::LabelImages& images, Scene& scene) const {
  images.ids = without(covered, images.ids);
  measured.copyTo(images.range, covered);
  if (requirements_.world_map) scene.world_map = without(covered, scene.world_map());
  if (requirements_.part_map) scene.part_map = without(covered, scene.part_map());
}

void PixelLabeller::addImages(const render::LabelImages& images, Scene& scene) const {
  if (requirements_.depth) scene.depth = images.depth;
  if (requirements_.normals) scene.normals = images.normals;
  if (requirements_.world_map) {
    scene.world_map = label::mapOfLinks(images.links, options_.world_classes);
  }
  if (requirements_.part_map) scene.part_map = label::mapOfLinks(images.links, options_.parts);
}

void PixelLabeller::measureSilhouettes(const CapturedView& view, Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    SceneObject& object = scene.objects[i];
    render::Silhouette silhouette;
    silhouette.mask = Mask(view.size());
    if (object.X_CO) {
      silhouette = view.silhouette(presentOf(links_of_[i], view.present()), renderer_);
    }
    object.silhouette_box = silhouette.box;
    object.pixels.silhouette = silhouette.pixels;
    object.pixels.silhouette_in_image = silhouette.pixels_in_image;
    if (requirements_.silhouettes) object.silhouette = std::move(silhouette.mask);
  }
}

/// @param covered  pixels that do not belong to any object; empty if there are none
/// @param subtracted  none for exact masks
MaskAgreement PixelLabeller::addMasks(const cv::Mat& ids, const cv::Mat& covered,
                                      const PendingMasks& subtracted, Scene& scene) const {
  const std::size_t count = scene.objects.size();
  cv::Mat map = label::instanceMap(ids);
  std::vector<label::InstancePixels> parts = label::instancePixels(map, count);
  std::vector<double> distances;
  MaskAgreement agreement;
  for (std::size_t i = 0; i < count; ++i) {
    SceneObject& object = scene.objects[i];
    object.pixels.visible = parts[i].count;
    distances.push_back(object.X_CO ? object.distance() : 0.0);  // unused: it has no pixels
  }
  if (subtracted) {
    std::vector<Mask> masks = subtracted();
    for (std::size_t i = 0; i < count; ++i) {
      if (requirements_.silhouettes) scene.objects[i].silhouette = masks[i];
      // A surface that no pixel's centre sees may still colour the edges of some pixels.
      if (parts[i].count == 0) masks[i] = Mask();
    }
    cv::Mat layered = label::layeredInstanceMap(masks, ids, distances);
    if (!covered.empty()) layered.setTo(0, covered);
    agreement = label::intersectionOverUnion(layered, map, count);
    map = layered;
    parts = label::instancePixels(map, count);
  }
  if (requirements_.visible_masks) addVisibleParts(map, parts, scene);
  return agreement;
}

void PixelLabeller::addVisibleParts(const cv::Mat& instance_map,
                                    const std::vector<label::InstancePixels>& parts,
                                    Scene& scene) const {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    SceneObject& object = scene.objects[i];
    object.visible_mask = label::instanceMask(instance_map, object.instance, parts[i].bounds);
  }
  scene.instance_map = instance_map;
  if (requirements_.class_map) {
    scene.class_map = label::renumbered(instance_map, options_.class_numbers);
  }
}

void PixelLabeller::addKeypointStates(const render::LabelImages& images, bool has_ranges,
                                      const PlacedKeypoints& keypoints, Scene& scene) const {
  const Intrinsics& k = scene.camera.intrinsics();
  const label::RangeAt range = [&](const cv::Point& pixel) {
    if (has_ranges) return double{images.range.at<float>(pixel)};
    const Eigen::Vector3d ray((pixel.x - k.cx) / k.fx, (pixel.y - k.cy) / k.fy, 1.0);
    return images.depth.at<float>(pixel) * ray.norm();
  };
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    SceneObject& object = scene.objects[i];
    if (!object.X_CO) {
      for (Keypoint& each : object.keypoints) each.state = KeypointState::kOutside;
      continue;
    }
    label::findKeypointStates(object.keypoints, keypoints[i], object.instance, images.ids, range,
                              scene.camera, options_.labels.keypoint_tolerance);
  }
}

void PixelLabeller::drop(Scene& scene) const {
  const LabelOptions& labels = options_.labels;
  if (!labels.hasThresholds()) return;
  for (SceneObject& object : scene.objects) {
    const std::int64_t visible = object.pixels.visible();
    object.dropped = visible == 0 || visible < labels.min_pixels ||
                     (labels.min_visibility > 0.0 && object.visibility() < labels.min_visibility);
  }
}

}  // namespace synthetic_dataset::label
