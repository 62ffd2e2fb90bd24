#include "output/verify/label_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <opencv2/core.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::output {
namespace {

using formats::DrawnLabel;
using formats::ExpectedLabel;

/// A label with what is measured on it once.
struct FoundLabel {
  const DrawnLabel* label = nullptr;
  std::optional<Box> mask_bounds;
  std::int64_t mask_pixels = 0;
  std::optional<Box> polygon_bounds;
  double polygon_area = 0.0;  ///< [px^2]
  bool is_taken = false;      ///< an expected one is found to be this
};

/// Twice the area that a closed polygon goes round, negative for one that turns the other way
/// (the shoelace formula).
double turnedArea(const std::vector<cv::Point2d>& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += polygon[i].cross(polygon[(i + 1) % polygon.size()]);
  }
  return sum;
}

void measurePolygons(FoundLabel& found) {
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

FoundLabel measured(const DrawnLabel& label) {
  FoundLabel found;
  found.label = &label;
  if (!label.mask.empty()) {
    found.mask_pixels = cv::countNonZero(label.mask);
    const cv::Rect bounds = maskBounds(label.mask);
    if (!bounds.empty()) {
      found.mask_bounds =
          Box{bounds.x - 0.5, bounds.y - 0.5, bounds.br().x - 0.5, bounds.br().y - 0.5};
    }
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

bool areNear(const std::optional<Box>& a, const Box& b, double tolerance) {
  return a && std::abs(a->left - b.left) <= tolerance && std::abs(a->top - b.top) <= tolerance &&
         std::abs(a->right - b.right) <= tolerance && std::abs(a->bottom - b.bottom) <= tolerance;
}

bool areNear(const Pose& a, const Pose& b) {
  constexpr double kTolerance = 1e-6;  // a matrix, a quaternion, decimals: [m], and of a rotation
  return (a.translation() - b.translation()).norm() <=
             kTolerance * (1.0 + b.translation().norm()) &&
         (a.linear() - b.linear()).cwiseAbs().maxCoeff() <= kTolerance;
}

std::string difference(const std::string& what, const std::string& found,
                       const std::string& right) {
  return "found the " + what + " " + found + "; it should be " + right;
}

/// Whether a label says itself that it is another object's, or another class's.
bool isOfAnother(const FoundLabel& found, const ExpectedLabel& expected) {
  const auto& classes = found.label->class_names;
  const std::string& name = found.label->object_name;
  return (!classes.empty() && !expected.class_name.empty() &&
          std::find(classes.begin(), classes.end(), expected.class_name) == classes.end()) ||
         (!name.empty() && !expected.object_name.empty() && name != expected.object_name);
}

/// How a label differs from an expected one of the same class; empty: it does not.
std::string differenceBetween(const FoundLabel& found, const ExpectedLabel& expected) {
  const DrawnLabel& label = *found.label;
  if (expected.box && !areNear(label.box, *expected.box, expected.box_tolerance)) {
    return difference("box", text(label.box), text(expected.box));
  }
  if (expected.mask_bounds && !areNear(found.mask_bounds, *expected.mask_bounds, 0.0)) {
    return difference("mask within", text(found.mask_bounds), text(expected.mask_bounds));
  }
  if (expected.mask_pixels && found.mask_pixels != *expected.mask_pixels) {
    return difference("mask of", std::to_string(found.mask_pixels) + " pixels",
                      std::to_string(*expected.mask_pixels));
  }
  if (expected.polygon_bounds &&
      !areNear(found.polygon_bounds, *expected.polygon_bounds, expected.polygon_tolerance)) {
    return difference("polygon within", text(found.polygon_bounds), text(expected.polygon_bounds));
  }
  if (expected.polygon_area && found.polygon_area != *expected.polygon_area) {
    return difference("polygon round", std::to_string(found.polygon_area) + " pixels",
                      std::to_string(*expected.polygon_area));
  }
  if (expected.X_CO && label.X_CO && !areNear(*label.X_CO, *expected.X_CO)) {
    return difference("pose", text(*label.X_CO), text(*expected.X_CO));
  }
  return "";
}

std::string nameOf(const ExpectedLabel& expected) {
  return "object '" + expected.object + "'" +
         (expected.class_name.empty() ? "" : " (" + expected.class_name + ")");
}

std::string nameOf(const FoundLabel& found) {
  const DrawnLabel& label = *found.label;
  std::string name = "a label";
  if (!label.class_names.empty()) name += " of class " + text(label.class_names);
  if (!label.object_name.empty()) name += " of object '" + label.object_name + "'";
  if (label.box) name += " at " + text(label.box);
  if (!label.box && found.mask_bounds) name += " with a mask within " + text(found.mask_bounds);
  return name;
}

/// Gives each expected label one that is found. First those that agree in everything; what is left
/// over then is a problem: by pairs of the same object or class, and one by one.
void match(std::vector<FoundLabel> found, const std::vector<ExpectedLabel>& expected,
           std::vector<std::string>& problems) {
  std::vector<const ExpectedLabel*> open;
  for (const ExpectedLabel& each : expected) {
    const auto same = std::find_if(found.begin(), found.end(), [&](const FoundLabel& label) {
      return !label.is_taken && !isOfAnother(label, each) && differenceBetween(label, each).empty();
    });
    if (same == found.end()) {
      open.push_back(&each);
    } else {
      same->is_taken = true;
    }
  }
  for (const ExpectedLabel* each : open) {
    const auto similar = std::find_if(found.begin(), found.end(), [&](const FoundLabel& label) {
      return !label.is_taken && !isOfAnother(label, *each);
    });
    if (similar != found.end()) {
      similar->is_taken = true;
      problems.push_back(nameOf(*each) + ": " + differenceBetween(*similar, *each));
    } else if (!each->may_lack) {
      problems.push_back(nameOf(*each) + ": has no label; it should have one");
    }
  }
  for (const FoundLabel& label : found) {
    if (!label.is_taken)
      problems.push_back("found " + nameOf(label) + " that no object should have");
  }
}

}  // namespace

std::vector<std::string> labelProblems(const formats::LabelledPicture& picture,
                                       const formats::ExpectedLabels& expected) {
  std::vector<FoundLabel> labels;
  std::vector<FoundLabel> masks;
  for (const DrawnLabel& each : picture.labels) {
    // A mask apart says nothing but where it is.
    const bool is_mask =
        each.class_names.empty() && each.object_name.empty() && !each.box && !each.mask.empty();
    (is_mask ? masks : labels).push_back(measured(each));
  }
  std::vector<std::string> problems;
  match(std::move(labels), expected.labels, problems);
  if (expected.has_masks_apart) match(std::move(masks), expected.masks, problems);
  return problems;
}

}  // namespace synthetic_dataset::output
