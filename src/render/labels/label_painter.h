#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "render/geometry/geometry_images.h"
#include "render/gl/framebuffer.h"
#include "render/labels/label_images.h"
#include "render/lens/lens_eye.h"
#include "render/parts/draw_list.h"
#include "render/parts/shader_family.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// What a label pass shows.
struct LabelPass {
  LinkSelection drawn;   ///< the links that are seen
  bool links = false;    ///< whether LabelImages::links is made
  bool normals = false;  ///< whether LabelImages::normals is made
  bool range = false;    ///< whether LabelImages::range is made
};

/// Derives labels from geometry images.
/// @param images  of the whole picture
/// @param pass  without normals
[[nodiscard]] LabelImages labelsOf(const GeometryImages& images, const DrawList& draw_list,
                                   const Intrinsics& intrinsics, const LabelPass& pass);

/// Draws what each pixel's centre sees, for labels that cannot be derived from geometry images.
class LabelPainter {
 public:
  /// @param draw_list, eye  have to outlive this painter
  LabelPainter(const GlFunctions& gl, const DrawList& draw_list, LensEye& eye);

  [[nodiscard]] LabelImages paint(const View& view, const std::vector<Pose>& X_WL,
                                  const LabelPass& pass);

  /// The labels of a picture whose rows are taken one after the other.
  [[nodiscard]] LabelImages paint(const RollingView& rows, const LabelPass& pass);

 private:
  /// Without LabelImages::range.
  [[nodiscard]] LabelImages paintPinhole(const View& view, const std::vector<Pose>& X_WL,
                                         const LabelPass& pass);
  [[nodiscard]] const Framebuffer& targetFor(const cv::Size& size, const LabelPass& pass);

  const GlFunctions& gl_;
  const DrawList& draw_list_;
  LensEye& eye_;
  ShaderFamily programs_;

  /// Keyed by whether they have links and normals; as large as the largest picture so far.
  std::map<std::pair<bool, bool>, std::optional<Framebuffer>> targets_;
};

}  // namespace synthetic_dataset::render
