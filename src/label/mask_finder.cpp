#include "label/mask_finder.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "label/object_links.h"

namespace synthetic_dataset::label {
namespace {

/// Whether views are the same; a camera's focal lengths may have changed.
bool isSame(const render::View& a, const render::View& b) {
  return a.X_WC.matrix() == b.X_WC.matrix() && a.camera.intrinsics() == b.camera.intrinsics();
}

}  // namespace

MaskFinder::MaskFinder(const world::World& world, render::Renderer& renderer,
                       std::size_t object_count, const label::Mog2Options& options, bool clean)
    : world_(world),
      renderer_(renderer),
      options_(options),
      clean_(clean),
      nothing_(world.links().size(), false),
      without_objects_(linksOf(kNoObject, world.links())) {
  for (std::size_t i = 0; i < object_count; ++i) {
    all_object_links_.push_back(linksOf(static_cast<int>(i), world.links()));
  }
}

PendingMasks MaskFinder::find(const CapturedView& view, const std::vector<SceneObject>& objects) {
  const cv::Size size = view.size();
  without_objects_ = presentOf(linksOf(kNoObject, world_.links()), view.present());
  object_links_.clear();
  std::vector<cv::Rect> boxes;
  cv::Rect all;  // OpenCV's union of an empty rectangle and another is the other
  for (std::size_t i = 0; i < objects.size(); ++i) {
    object_links_.push_back(presentOf(all_object_links_[i], view.present()));
    boxes.emplace_back();
    if (!objects[i].inView(view.camera())) continue;
    // Not the object's own box: the shape that the user gives may be smaller than what is seen.
    const cv::Rect reach = view.reach(object_links_[i], renderer_);
    boxes.back() = reach & cv::Rect(cv::Point(), size);
    all |= boxes.back();
  }
  takeBackground(view, all);
  struct Group {
    std::vector<std::size_t> objects;
    render::PendingPicture picture;
  };
  std::vector<Group> groups;
  for (const std::vector<std::size_t>& group : apart(boxes)) {
    render::LinkSelection drawn = without_objects_;
    std::vector<cv::Rect> regions;
    for (const std::size_t i : group) {
      std::transform(drawn.begin(), drawn.end(), object_links_[i].begin(), drawn.begin(),
                     std::logical_or<>());
      regions.push_back(boxes[i]);
    }
    groups.push_back({group, draw(view, drawn, regions)});
  }
  return [size, groups, boxes, model = background_->model] {
    std::vector<Mask> masks(boxes.size(), Mask(size));
    for (const Group& group : groups) {
      const cv::Mat picture = group.picture();
      for (const std::size_t i : group.objects) {
        masks[i] = Mask(model->segment(picture, boxes[i]), boxes[i].tl(), size);
      }
    }
    return masks;
  };
}

/// Groups the objects that have a box so that no object can be seen in the box of another one of
/// its group.
std::vector<std::vector<std::size_t>> MaskFinder::apart(const std::vector<cv::Rect>& boxes) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    const auto disturbs = [&](std::size_t other) { return !(boxes[i] & boxes[other]).empty(); };
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return std::none_of(group.begin(), group.end(), disturbs);
    });
    if (found == groups.end()) {
      groups.push_back({i});
    } else {
      found->push_back(i);
    }
  }
  return groups;
}

void MaskFinder::takeBackground(const CapturedView& view, const cv::Rect& region) {
  // Compared exactly: a scene's masks must not depend on which scene was made before it.
  const render::View* at_once = view.atOnce();
  const bool stands_still = background_ && background_->view && at_once != nullptr &&
                            isSame(*background_->view, *at_once) &&
                            background_->prop_revision == world_.propRevision() &&
                            background_->look_revision == renderer_.lookRevision();
  if (stands_still && (background_->region & region) == region) return;
  // MOG2 judges each pixel by itself, so pixels outside of all boxes need not be drawn. If nothing
  // but the objects moves, the whole picture can be used for all later scenes.
  const cv::Rect drawn = stands_still ? cv::Rect(cv::Point(), view.size()) : region;
  background_ = Background{
      at_once != nullptr ? std::optional(*at_once) : std::nullopt, world_.propRevision(),
      renderer_.lookRevision(), drawn,
      std::make_shared<BackgroundModel>(draw(view, without_objects_, {drawn}), options_, clean_)};
}

render::PendingPicture MaskFinder::draw(const CapturedView& view,
                                        const render::LinkSelection& drawn,
                                        const std::vector<cv::Rect>& regions) {
  // Without shadows, and with pixels sampled only at their centres, what differs from the
  // background is the object and nothing around it.
  return view.draw({drawn, nothing_, render::Sampling::kCentre, regions}, renderer_);
}

}  // namespace synthetic_dataset::label
