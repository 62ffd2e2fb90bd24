#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "label/captured_view.h"
#include "label/mog2_segmenter.h"
#include "render/renderer.h"
#include "synthetic_dataset/mask.h"
#include "synthetic_dataset/scene.h"
#include "world/world.h"

namespace synthetic_dataset::label {

/// Finds the mask of each object (see SceneObject::silhouette), in the objects' order. May be
/// called in any thread, as long as the renderer lives.
using PendingMasks = std::function<std::vector<Mask>()>;

/// Finds one camera's masks as the paper does: an object is what differs between a picture of the
/// world with only this object and one without objects. Objects that are apart in the image share a
/// picture: within the box of each, the picture is the same as if it were the only object.
class MaskFinder {
 public:
  /// All references have to outlive the finder.
  /// @param clean  fill holes and remove specks
  MaskFinder(const world::World& world, render::Renderer& renderer, std::size_t object_count,
             const label::Mog2Options& options, bool clean);

  /// Draws the pictures in which masks are found.
  [[nodiscard]] PendingMasks find(const CapturedView& view,
                                  const std::vector<SceneObject>& objects);

 private:
  struct Background {
    std::optional<render::View>
        view;  ///< from which it was taken; nothing if each row has its own time
    std::int64_t prop_revision = -1;
    std::int64_t look_revision = -1;
    cv::Rect region;  ///< the pixels that were drawn
    std::shared_ptr<BackgroundModel> model;
  };

  void takeBackground(const CapturedView& view, const cv::Rect& region);
  [[nodiscard]] static std::vector<std::vector<std::size_t>> apart(
      const std::vector<cv::Rect>& boxes);
  [[nodiscard]] render::PendingPicture draw(const CapturedView& view,
                                            const render::LinkSelection& drawn,
                                            const std::vector<cv::Rect>& regions);

  const world::World& world_;
  render::Renderer& renderer_;
  label::Mog2Options options_;
  bool clean_;
  std::optional<Background> background_;
  render::LinkSelection nothing_;
  render::LinkSelection without_objects_;
  std::vector<render::LinkSelection> all_object_links_;  ///< by object
  std::vector<render::LinkSelection> object_links_;      ///< only those that are present
};

}  // namespace synthetic_dataset::label
