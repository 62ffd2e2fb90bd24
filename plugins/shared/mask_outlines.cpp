#include "plugins/shared/mask_outlines.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <tuple>

#include <opencv2/imgproc.hpp>

#include "plugins/shared/border_rings.h"

namespace synthetic_dataset::masks {
namespace {

/// Removes repeated points and points on straight lines.
Ring corners(Ring ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const cv::Point in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const cv::Point out = ring[(i + 1) % ring.size()] - ring[i];
    if (in.cross(out) != 0.0 || in.dot(out) <= 0) result.push_back(ring[i]);
  }
  return result;
}

/// A line from a pixel of one part to a pixel of another.
struct Bridge {
  std::array<cv::Point, 2> pixels;
  std::array<std::size_t, 2> parts{};

  [[nodiscard]] auto order() const {
    const cv::Point span = pixels[1] - pixels[0];
    return std::make_tuple(span.dot(span), pixels[0].y, pixels[0].x, pixels[1].y, pixels[1].x);
  }
};

/// The index in `parts` of the part to which each pixel of the mask belongs; 0 elsewhere.
/// @param offset  the mask's position in the picture in which the parts were found
cv::Mat1i partMap(const cv::Mat& mask, const std::vector<BorderRing>& parts,
                  const cv::Point& offset) {
  cv::Mat1i map;
  const int count = cv::connectedComponents(mask, map, 8, CV_32S);
  std::vector<int> part_of_component(static_cast<std::size_t>(count), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const cv::Point pixel = parts[i].front().pixel - offset;
    part_of_component[static_cast<std::size_t>(map(pixel))] = static_cast<int>(i);
  }
  for (int& component : map) component = part_of_component[static_cast<std::size_t>(component)];
  return map;
}

/// The pixel of the mask that is nearest to each pixel of the image.
cv::Mat_<cv::Point> nearestPixels(const cv::Mat& mask) {
  cv::Mat distances;
  cv::Mat1i labels;
  cv::distanceTransform(mask == 0, distances, labels, cv::DIST_L2, cv::DIST_MASK_5,
                        cv::DIST_LABEL_PIXEL);
  std::vector<cv::Point> pixel_of_label(mask.total() + 1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      pixel_of_label[static_cast<std::size_t>(labels(y, x))] = {x, y};
    }
  }
  cv::Mat_<cv::Point> nearest(mask.size());
  std::transform(labels.begin(), labels.end(), nearest.begin(),
                 [&](int label) { return pixel_of_label[static_cast<std::size_t>(label)]; });
  return nearest;
}

/// Bridges where the regions nearest to two parts meet; the shortest come first.
std::vector<Bridge> possibleBridges(const cv::Mat& mask, const std::vector<BorderRing>& parts,
                                    const cv::Point& offset) {
  const cv::Mat1i part_map = partMap(mask, parts, offset);
  const cv::Mat_<cv::Point> nearest = nearestPixels(mask);
  std::vector<Bridge> bridges;
  const auto meet = [&](const cv::Point& a, const cv::Point& b) {
    const auto part_a = static_cast<std::size_t>(part_map(a));
    const auto part_b = static_cast<std::size_t>(part_map(b));
    if (part_a != part_b) bridges.push_back({{a + offset, b + offset}, {part_a, part_b}});
  };
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (x > 0) meet(nearest(y, x - 1), nearest(y, x));
      if (y > 0) meet(nearest(y - 1, x), nearest(y, x));
    }
  }
  std::sort(bridges.begin(), bridges.end(),
            [](const Bridge& a, const Bridge& b) { return a.order() < b.order(); });
  return bridges;
}

/// The shortest bridges that join all parts (Kruskal's algorithm).
std::vector<Bridge> shortestBridges(const std::vector<Bridge>& possible, std::size_t part_count) {
  std::vector<std::size_t> group(part_count);
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto groupOf = [&](std::size_t part) {
    while (group[part] != part) part = group[part] = group[group[part]];
    return part;
  };
  std::vector<Bridge> chosen;
  for (const Bridge& bridge : possible) {
    const std::size_t a = groupOf(bridge.parts[0]);
    const std::size_t b = groupOf(bridge.parts[1]);
    if (a == b) continue;
    group[a] = b;
    chosen.push_back(bridge);
  }
  return chosen;
}

/// The bridges as branches of a walk from part 0.
Branches branchesOf(const std::vector<Bridge>& bridges, const std::vector<BorderRing>& parts) {
  std::vector<std::vector<std::size_t>> bridges_of_part(parts.size());
  for (std::size_t i = 0; i < bridges.size(); ++i) {
    for (const std::size_t part : bridges[i].parts) bridges_of_part[part].push_back(i);
  }
  // The mask's nearest pixel to a pixel off the mask is always on a border.
  const auto placeOf = [&](const Bridge& bridge, std::size_t end) {
    const BorderRing& ring = parts[bridge.parts[end]];
    const auto found = std::find_if(ring.begin(), ring.end(), [&](const BorderStep& step) {
      return step.pixel == bridge.pixels[end];
    });
    return static_cast<std::size_t>(std::distance(ring.begin(), found));
  };
  Branches branches;
  std::vector<bool> is_crossed(bridges.size(), false);
  std::vector<std::size_t> reached = {0};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const std::size_t each : bridges_of_part[reached[i]]) {
      if (is_crossed[each]) continue;
      is_crossed[each] = true;
      const Bridge& bridge = bridges[each];
      const std::size_t from = bridge.parts[0] == reached[i] ? 0 : 1;
      const std::size_t to = 1 - from;
      branches[{reached[i], placeOf(bridge, from)}].push_back(
          {bridge.parts[to], placeOf(bridge, to)});
      reached.push_back(bridge.parts[to]);
    }
  }
  return branches;
}

}  // namespace

std::vector<Ring> edgeRings(const Mask& mask) {
  std::vector<Ring> rings;
  for (const BorderRing& part : partBorders(mask)) {
    Ring ring;
    for (const BorderStep& step : part) ring.push_back(step.corner);
    rings.push_back(corners(std::move(ring)));
  }
  return rings;
}

Ring centreRing(const Mask& mask) {
  const std::vector<BorderRing> parts = partBorders(mask);
  if (parts.empty()) return {};
  Branches branches;
  if (parts.size() > 1) {
    const std::vector<Bridge> possible = possibleBridges(mask.pixels(), parts, mask.offset());
    branches = branchesOf(shortestBridges(possible, parts.size()), parts);
  }
  Ring ring;
  for (const BorderStep& step : walk(parts, branches, {0, 0})) ring.push_back(step.pixel);
  ring = corners(std::move(ring));
  while (ring.size() < 3) ring.push_back(ring.back());
  return ring;
}

}  // namespace synthetic_dataset::masks
