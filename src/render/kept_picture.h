#pragma once

#include <optional>
#include <vector>

#include "render/changed_regions.h"
#include "render/colour_painter.h"
#include "render/render_target.h"
#include "render/shadow_painter.h"

namespace synthetic_dataset::render {

/// Draws pictures of which most stays as it was in the one before: what never moves is drawn once
/// for all pictures from the same place, and again only where the shadow of something that moves
/// may fall. Every pixel is that of a picture drawn anew (ColourPainter::paint).
class KeptPicture {
 public:
  /// The references have to outlive this.
  KeptPicture(const GlFunctions& gl, const DrawList& parts, const std::vector<world::Light>& lights,
              ShadowPainter& shadow_painter, ColourPainter& painter, const ColourTarget& target);

  /// Draws the target, and the shadow maps for it.
  /// @param background  linear, exposed
  void paint(const ColourScene& scene, const LinkSelection& casting, const float background[3]);

 private:
  /// What a picture that is kept depends on.
  struct Key {
    Eigen::Matrix4d clip_from_camera;
    Eigen::Matrix4d X_WC;
    std::vector<Eigen::Matrix4d> shadows;
    LinkSelection drawn;
    LinkSelection casting;
    float exposure;

    [[nodiscard]] bool operator==(const Key& other) const;
  };

  void paintAnew(const ColourScene& scene, const LinkSelection& casting, const float background[3]);
  void keep(const ColourScene& scene, const LinkSelection& casting, const float background[3]);
  void paintChanges(const ColourScene& scene, const LinkSelection& casting,
                    const float background[3]);

  const GlFunctions& gl_;
  const DrawList& parts_;
  const std::vector<world::Light>& lights_;
  ShadowPainter& shadow_painter_;
  ColourPainter& painter_;
  const ColourTarget& target_;
  std::optional<ColourSamples> kept_;
  std::optional<Key> key_;         ///< of the picture before
  bool is_kept_ = false;           ///< with key_
  std::vector<cv::Rect> changed_;  ///< where the target differs from what is kept
};

}  // namespace synthetic_dataset::render
