#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "label/row_labels.h"
#include "render/renderer.h"
#include "render/view.h"
#include "world/world.h"

namespace synthetic_dataset::label {

/// What a picture shows: the world as it stands now, or, if its rows are taken one after the other,
/// the world as it stood at each row's time.
class CapturedView {
 public:
  /// All references have to outlive this.
  CapturedView(const render::View& view, const world::World& world) : view_(&view), world_(world) {}
  CapturedView(const CapturedRows& rows, const world::World& world) : rows_(&rows), world_(world) {}

  [[nodiscard]] const CameraModel& camera() const {
    return rows_ != nullptr ? rows_->view.camera : view_->camera;
  }
  [[nodiscard]] cv::Size size() const { return {camera().width(), camera().height()}; }

  /// Null if all rows are of one time.
  [[nodiscard]] const CapturedRows* rows() const { return rows_; }

  /// Null if each row is of its own time.
  [[nodiscard]] const render::View* atOnce() const { return view_; }

  /// The links that are present all the time.
  [[nodiscard]] const render::LinkSelection& present() const {
    return rows_ != nullptr ? rows_->present : world_.presentLinks();
  }

  [[nodiscard]] render::LabelImages labels(const render::LabelPass& pass,
                                           render::Renderer& renderer) const {
    return rows_ != nullptr ? renderer.labels(rows_->view, pass)
                            : renderer.labels(*view_, world_.linkPoses(), pass);
  }
  [[nodiscard]] render::Silhouette silhouette(const render::LinkSelection& links,
                                              render::Renderer& renderer) const {
    return rows_ != nullptr ? renderer.silhouette(rows_->view, links)
                            : renderer.silhouette(*view_, world_.linkPoses(), links);
  }
  [[nodiscard]] cv::Rect reach(const render::LinkSelection& links,
                               render::Renderer& renderer) const {
    return rows_ != nullptr ? renderer.reach(rows_->view, links)
                            : renderer.reach(*view_, world_.linkPoses(), links);
  }
  [[nodiscard]] render::PendingPicture draw(const render::ColourPass& pass,
                                            render::Renderer& renderer) const {
    return rows_ != nullptr ? renderer.draw(rows_->view, pass)
                            : renderer.draw(*view_, world_.linkPoses(), pass);
  }

 private:
  const render::View* view_ = nullptr;
  const CapturedRows* rows_ = nullptr;
  const world::World& world_;
};

}  // namespace synthetic_dataset::label
