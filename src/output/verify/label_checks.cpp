#include "output/verify/label_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <locale>
#include <optional>
#include <sstream>

#include <opencv2/core.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::output {
namespace {

using formats::DrawnLabel;

/// A label together with measurements that are made only once.
struct MeasuredLabel {
  const DrawnLabel* label = nullptr;
  std::optional<Box> mask_bounds;
  std::int64_t mask_pixels = 0;
  std::optional<Box> polygon_bounds;
  double polygon_area = 0.0;  ///< [px^2]
  bool is_taken = false;      ///< already matched to a right label
};

/// Twice the signed area of a closed polygon; negative for the other direction of rotation
/// (shoelace formula).
double turnedArea(const std::vector<cv::Point2d>& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += polygon[i].cross(polygon[(i + 1) % polygon.size()]);
  }
  return sum;
}

void measurePolygons(MeasuredLabel& found) {
  for (const auto& polygon : found.label->polygons) {
    found.polygon_area += 0.5 * std::abs(turnedArea(polygon));
    for (const cv::Point2d& point : polygon) {
      if (!found.polygon_bounds) found.polygon_bounds = Box{point.x, point.y, point.x, point.y};
      Box& bounds = *found.polygon_bounds;
      bounds = {std::min(bounds.left, point.x), std::min(bounds.top, point.y),
                std::max(bounds.right, point.x), std::max(bounds.bottom, point.y)};
    }
  }
}

MeasuredLabel measured(const DrawnLabel& label) {
  MeasuredLabel found;
  found.label = &label;
  if (!label.mask.empty()) {
    found.mask_pixels = cv::countNonZero(label.mask);
    const cv::Rect bounds = maskBounds(label.mask);
    if (!bounds.empty()) found.mask_bounds = boxAround(bounds);
  }
  measurePolygons(found);
  return found;
}

std::string text(const std::optional<Box>& box) {
  if (!box) return "none";
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(9);
  stream << '[' << box->left << ", " << box->top << ", " << box->right << ", " << box->bottom
         << ']';
  return stream.str();
}

std::string text(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(9);
  stream << '[' << pose.translation().x() << ", " << pose.translation().y() << ", "
         << pose.translation().z() << "; " << q.x() << ", " << q.y() << ", " << q.z() << ", "
         << q.w() << ']';
  return stream.str();
}

std::string text(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "'" : " or '") + name + "'";
  return list;
}

bool areNear(const std::optional<Box>& a, const std::optional<Box>& b) {
  constexpr double kTolerance = 1e-3;  // smaller than the last decimal of any format [px]
  if (!a || !b) return a.has_value() == b.has_value();
  return std::abs(a->left - b->left) <= kTolerance && std::abs(a->top - b->top) <= kTolerance &&
         std::abs(a->right - b->right) <= kTolerance &&
         std::abs(a->bottom - b->bottom) <= kTolerance;
}

bool areNear(const Pose& a, const Pose& b) {
  constexpr double kTolerance = 1e-6;  // rounding of matrices, quaternions, decimals; [m], and for
                                       // rotation
  return (a.translation() - b.translation()).norm() <=
             kTolerance * (1.0 + b.translation().norm()) &&
         (a.linear() - b.linear()).cwiseAbs().maxCoeff() <= kTolerance;
}

std::string difference(const std::string& what, const std::string& found,
                       const std::string& right) {
  return "found the " + what + " " + found + "; it should be " + right;
}

/// Whether a label states that it belongs to another object or another class.
bool isOfAnother(const MeasuredLabel& found, const MeasuredLabel& right) {
  return found.label->class_names != right.label->class_names ||
         found.label->object_name != right.label->object_name;
}

/// How a label differs from the right one; empty if it does not.
std::string differenceBetween(const MeasuredLabel& found, const MeasuredLabel& right) {
  constexpr double kTolerance = 1e-3;  // [px^2]
  if (!areNear(found.label->box, right.label->box)) {
    return difference("box", text(found.label->box), text(right.label->box));
  }
  if (!areNear(found.mask_bounds, right.mask_bounds)) {
    return difference("mask within", text(found.mask_bounds), text(right.mask_bounds));
  }
  if (found.mask_pixels != right.mask_pixels) {
    return difference("mask of", std::to_string(found.mask_pixels) + " pixels",
                      std::to_string(right.mask_pixels));
  }
  if (!areNear(found.polygon_bounds, right.polygon_bounds)) {
    return difference("polygon within", text(found.polygon_bounds), text(right.polygon_bounds));
  }
  if (std::abs(found.polygon_area - right.polygon_area) > kTolerance) {
    return difference("polygon around", std::to_string(found.polygon_area) + " pixels",
                      std::to_string(right.polygon_area));
  }
  const std::optional<Pose>& X_CO = found.label->X_CO;
  const std::optional<Pose>& right_X_CO = right.label->X_CO;
  if (X_CO && right_X_CO && !areNear(*X_CO, *right_X_CO)) {
    return difference("pose", text(*X_CO), text(*right_X_CO));
  }
  return "";
}

/// Intersection over union.
double overlapOf(const Box& a, const Box& b) {
  const std::optional<Box> both = intersection(a, b);
  if (!both) return 0.0;
  const auto areaOf = [](const Box& box) { return box.width() * box.height(); };
  return areaOf(*both) / std::max(areaOf(a) + areaOf(b) - areaOf(*both), 1e-9);
}

/// The region of the image that a label covers.
std::optional<Box> extentOf(const MeasuredLabel& label) {
  return label.label->box    ? label.label->box
         : label.mask_bounds ? label.mask_bounds
                             : label.polygon_bounds;
}

/// How well a label fits an object, 0 .. 1.
double fitOf(const MeasuredLabel& label, const ObjectFacts& object, const SceneFacts& facts) {
  const std::optional<Pose>& X_CO = label.label->X_CO;
  if (X_CO && object.X_GO) return areNear(*X_CO, facts.X_GC.inverse() * *object.X_GO) ? 1.0 : 0.0;
  const std::optional<Box> extent = extentOf(label);
  double fit = 0.0;
  for (const auto& box : {object.visible_box, object.silhouette_box, object.loose_box}) {
    const std::optional<Box> seen = box ? intersection(*box, facts.imageBounds()) : std::nullopt;
    if (extent && seen) fit = std::max(fit, overlapOf(*extent, *seen));
  }
  return fit;
}

/// The object that a right label belongs to, found by position; otherwise as the label states.
std::string nameOf(const MeasuredLabel& right, const SceneFacts& facts, const RunDescription& run) {
  constexpr double kLeast = 0.5;
  const RunDescription::Object* object = nullptr;
  double best = kLeast;
  for (std::size_t i = 0; i < std::min(facts.objects.size(), run.objects.size()); ++i) {
    const bool is_named = run.objects[i].name == right.label->object_name;
    const double fit = is_named ? 2.0 : fitOf(right, facts.objects[i], facts);
    if (fit <= best) continue;
    best = fit;
    object = &run.objects[i];
  }
  const std::string name = object != nullptr ? object->name : right.label->object_name;
  std::string class_name;
  for (const auto& each : run.classes) {
    if (object != nullptr && each.id == object->class_id) class_name = each.name;
  }
  const auto& said = right.label->class_names;
  if (!said.empty()) class_name = said.front();
  return (name.empty() ? "a label" : "object '" + name + "'") +
         (class_name.empty() ? "" : " (" + class_name + ")");
}

std::string nameOf(const MeasuredLabel& found) {
  const DrawnLabel& label = *found.label;
  std::string name = "a label";
  if (!label.class_names.empty()) name += " of class " + text(label.class_names);
  if (!label.object_name.empty()) name += " of object '" + label.object_name + "'";
  if (const auto extent = extentOf(found)) name += " at " + text(extent);
  return name;
}

/// Matches each right label to one that was found. First those that agree completely; any left over
/// are problems, reported in pairs of the same object or class, and then one by one.
void match(std::vector<MeasuredLabel>& found, const std::vector<MeasuredLabel>& right,
           const std::function<std::string(const MeasuredLabel&)>& nameOfRight,
           std::vector<std::string>& problems) {
  std::vector<const MeasuredLabel*> open;
  for (const MeasuredLabel& each : right) {
    const auto same = std::find_if(found.begin(), found.end(), [&](const MeasuredLabel& label) {
      return !label.is_taken && !isOfAnother(label, each) && differenceBetween(label, each).empty();
    });
    if (same == found.end()) {
      open.push_back(&each);
    } else {
      same->is_taken = true;
    }
  }
  for (const MeasuredLabel* each : open) {
    const auto similar = std::find_if(found.begin(), found.end(), [&](const MeasuredLabel& label) {
      return !label.is_taken && !isOfAnother(label, *each);
    });
    if (similar != found.end()) {
      similar->is_taken = true;
      problems.push_back(nameOfRight(*each) + ": " + differenceBetween(*similar, *each));
    } else {
      problems.push_back(nameOfRight(*each) + ": has no label; it should have one");
    }
  }
  for (const MeasuredLabel& label : found) {
    if (!label.is_taken)
      problems.push_back("found " + nameOf(label) + " that no object should have");
  }
}

}  // namespace

std::vector<std::string> labelProblems(const formats::LabelledPicture& found,
                                       const formats::LabelledPicture& right,
                                       const SceneFacts& facts, const RunDescription& run) {
  std::vector<MeasuredLabel> found_labels;
  std::vector<MeasuredLabel> right_labels;
  for (const DrawnLabel& each : found.labels) found_labels.push_back(measured(each));
  for (const DrawnLabel& each : right.labels) right_labels.push_back(measured(each));
  std::vector<std::string> problems;
  match(
      found_labels, right_labels,
      [&](const MeasuredLabel& label) { return nameOf(label, facts, run); }, problems);
  return problems;
}

std::vector<std::string> poseProblems(const SceneFacts& found, const SceneFacts& drawn,
                                      const RunDescription& run) {
  std::vector<std::string> problems;
  const auto compare = [&](const std::string& of, const std::optional<Pose>& one,
                           const std::optional<Pose>& other) {
    if (one && other ? areNear(*one, *other) : one.has_value() == other.has_value()) return;
    problems.push_back(
        of + difference("pose", one ? text(*one) : "none", other ? text(*other) : "none"));
  };
  if (found.stamp != drawn.stamp) {
    problems.push_back(difference("time", std::to_string(found.stamp.count()) + " ns",
                                  std::to_string(drawn.stamp.count())));
  }
  compare("camera '" + drawn.camera + "': ", found.X_GC, drawn.X_GC);
  for (std::size_t i = 0; i < std::min(found.objects.size(), drawn.objects.size()); ++i) {
    const std::string of = "object '" + run.objects.at(i).name + "': ";
    compare(of, found.objects[i].X_GO, drawn.objects[i].X_GO);
    const auto seen = found.objects[i].visible_pixels;
    const auto drawn_seen = drawn.objects[i].visible_pixels;
    if (seen == drawn_seen) continue;
    problems.push_back(of + difference("number of visible pixels", std::to_string(seen.value_or(0)),
                                       std::to_string(drawn_seen.value_or(0))));
  }
  return problems;
}

}  // namespace synthetic_dataset::output
