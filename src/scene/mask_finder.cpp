#include "scene/mask_finder.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "annotate/mask.h"
#include "scene/object_links.h"

namespace synthetic_dataset {
namespace {

/// Of one camera, whose focal lengths may have changed.
bool isSame(const render::View& a, const render::View& b) {
  return a.X_WC.matrix() == b.X_WC.matrix() && a.camera.intrinsics() == b.camera.intrinsics();
}

}  // namespace

MaskFinder::MaskFinder(const world::World& world, render::Renderer& renderer,
                       std::size_t object_count, const annotate::Mog2Options& options, bool clean)
    : world_(world),
      renderer_(renderer),
      segmenter_(options),
      clean_(clean),
      nothing_(world.links().size(), false),
      without_objects_(linksOf(kNoObject, world.links())) {
  for (std::size_t i = 0; i < object_count; ++i) {
    all_object_links_.push_back(linksOf(static_cast<int>(i), world.links()));
  }
}

std::vector<cv::Mat> MaskFinder::find(const render::View& view,
                                      const std::vector<SceneObject>& objects) {
  const cv::Size size(view.camera.width(), view.camera.height());
  without_objects_ = presentOf(linksOf(kNoObject, world_.links()), world_);
  object_links_.clear();
  std::vector<cv::Rect> boxes;
  cv::Rect all;  // OpenCV's union with an empty rectangle is the other one
  for (std::size_t i = 0; i < objects.size(); ++i) {
    object_links_.push_back(presentOf(all_object_links_[i], world_));
    boxes.emplace_back();
    if (!objects[i].in_view) continue;
    // Not its own box: the shape that the user gives may be smaller than what is seen.
    const cv::Rect reach = renderer_.reach(view, world_.linkPoses(), object_links_[i]);
    boxes.back() = reach & cv::Rect(cv::Point(), size);
    all |= boxes.back();
  }
  takeBackground(view, all);
  std::vector<cv::Mat> masks(objects.size());
  for (cv::Mat& mask : masks) mask = cv::Mat::zeros(size, CV_8UC1);
  for (const std::vector<std::size_t>& group : apart(boxes)) {
    render::LinkSelection drawn = without_objects_;
    std::vector<cv::Rect> regions;
    for (const std::size_t i : group) {
      std::transform(drawn.begin(), drawn.end(), object_links_[i].begin(), drawn.begin(),
                     std::logical_or<>());
      regions.push_back(boxes[i]);
    }
    const cv::Mat picture = draw(view, drawn, regions);
    for (const std::size_t i : group) segment(picture, boxes[i]).copyTo(masks[i](boxes[i]));
  }
  return masks;
}

/// The objects that have a box, in groups of which none can be seen in the box of another.
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

/// The mask in a box, beside which there is nothing.
cv::Mat MaskFinder::segment(const cv::Mat& alone, const cv::Rect& box) {
  const cv::Mat raw = segmenter_.segment(alone, box);
  if (!clean_) return raw;
  // What is round the box tells holes from bays.
  constexpr int kRound = annotate::kLargestHole + 1;
  const cv::Rect round =
      cv::Rect(box.x - kRound, box.y - kRound, box.width + 2 * kRound, box.height + 2 * kRound) &
      cv::Rect(cv::Point(), alone.size());
  cv::Mat framed = cv::Mat::zeros(round.size(), CV_8UC1);
  raw.copyTo(framed(box - round.tl()));
  return annotate::cleanMask(framed)(box - round.tl());
}

void MaskFinder::takeBackground(const render::View& view, const cv::Rect& region) {
  // Compared exactly: a scene's masks must not depend on which scene was made before it.
  const bool stands_still = background_ && isSame(background_->view, view) &&
                            background_->prop_revision == world_.propRevision() &&
                            background_->look_revision == renderer_.lookRevision();
  if (stands_still && (background_->region & region) == region) return;
  // MOG2 judges each pixel by itself, so pixels outside of all boxes need not be drawn. Where
  // nothing but the objects moves, the whole picture is good for all scenes to come.
  const cv::Rect whole(0, 0, view.camera.width(), view.camera.height());
  const cv::Rect drawn = stands_still ? whole : region;
  background_ = Background{view, world_.propRevision(), renderer_.lookRevision(), drawn,
                           draw(view, without_objects_, {drawn})};
  segmenter_.train(background_->image);
}

cv::Mat MaskFinder::draw(const render::View& view, const render::LinkSelection& drawn,
                         const std::vector<cv::Rect>& regions) {
  // Without shadows, and with pixels sampled at their centres alone, what differs from the
  // background is the object and nothing around it.
  return renderer_.colour(view, world_.linkPoses(),
                          {drawn, nothing_, render::Sampling::kCentre, regions});
}

}  // namespace synthetic_dataset
