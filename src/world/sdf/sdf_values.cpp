#include "world/sdf/sdf_values.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <locale>
#include <sstream>

#include <Eigen/Geometry>

namespace synthetic_dataset::world {
namespace {

constexpr double kFarthest = 1e7;  // [m]: points beyond it cannot be told apart
constexpr double kDegree = M_PI / 180.0;

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  return "'" + (text.size() > kLongest ? text.substr(0, kLongest) + "..." : text) + "'";
}

void noteReplaced(const Element& parent, const char* name, const std::string& found,
                  const std::string& needed, const std::string& taken,
                  const SourceLocation& location, SdfReading& reading) {
  reading.findings.addNote(
      location.atLine(parent.lineOf(name)),
      std::string(name) + ": found " + quoted(found) + "; " + needed + "; " + taken);
}

bool allFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Eigen::Quaterniond fromAngles(double roll, double pitch, double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

/// SDF 1.0 has <origin pose="...">.
Element poseElement(const Element& parent) {
  const Element pose = parent.child("pose");
  return pose ? pose : parent.child("origin");
}

bool isTrue(const std::string& text) { return text == "true" || text == "1"; }

/// The numbers as a pose; missing ones are 0.
Pose poseOf(std::vector<double> v, const Element& element) {
  if (element.attribute("rotation_format") == "quat_xyzw" && v.size() == 7) {
    const Eigen::Quaterniond rotation(v[6], v[3], v[4], v[5]);
    if (!(rotation.norm() > 0.0))
      return makePose({v[0], v[1], v[2]}, Eigen::Quaterniond::Identity());
    return makePose({v[0], v[1], v[2]}, rotation.normalized());
  }
  v.resize(6, 0.0);
  const double unit = isTrue(element.attribute("degrees")) ? kDegree : 1.0;
  return makePose({v[0], v[1], v[2]}, fromAngles(v[3] * unit, v[4] * unit, v[5] * unit));
}

bool isWithinReach(const std::vector<double>& values) {
  const auto end =
      values.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(3, values.size()));
  return allFinite(values) &&
         std::all_of(values.begin(), end, [](double v) { return std::abs(v) <= kFarthest; });
}

}  // namespace

std::vector<double> numbersIn(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> result;
  for (double each = 0.0; stream >> each;) result.push_back(each);
  return result;
}

std::string shortText(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

std::string takenInstead(double fallback) { return shortText(fallback) + " is taken"; }

double readNumber(const Element& parent, const char* name, double fallback,
                  const SourceLocation& location, SdfReading& reading) {
  const std::optional<std::string> text = parent.value(name);
  if (!text || text->empty()) return fallback;
  const std::vector<double> values = numbersIn(*text);
  if (!values.empty() && std::isfinite(values.front())) return values.front();
  noteReplaced(parent, name, *text, "a number is needed", takenInstead(fallback), location,
               reading);
  return fallback;
}

bool readBool(const Element& parent, const char* name, bool fallback,
              const SourceLocation& location, SdfReading& reading) {
  const std::optional<std::string> found = parent.value(name);
  if (!found || found->empty()) return fallback;
  std::string text = *found;
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (isTrue(text)) return true;
  if (text == "false" || text == "0") return false;
  noteReplaced(parent, name, *found, "true or false is needed",
               std::string(fallback ? "true" : "false") + " is taken", location, reading);
  return fallback;
}

std::string readText(const Element& parent, const char* name) {
  const std::string text = parent.value(name).value_or("");
  return text == "__default__" ? "" : text;
}

Eigen::Vector3d readVector(const Element& parent, const char* name, const Eigen::Vector3d& fallback,
                           const SourceLocation& location, SdfReading& reading) {
  const std::optional<std::string> text = parent.value(name);
  if (!text || text->empty()) return fallback;
  const std::vector<double> v = numbersIn(*text);
  if (v.size() >= 3 && allFinite(v)) return {v[0], v[1], v[2]};
  noteReplaced(
      parent, name, *text, "three numbers are needed",
      shortText(fallback.x()) + " " + shortText(fallback.y()) + " " + takenInstead(fallback.z()),
      location, reading);
  return fallback;
}

std::optional<Eigen::Vector4f> readColour(const Element& parent, const char* name,
                                          const SourceLocation& location, SdfReading& reading) {
  const std::optional<std::string> text = parent.value(name);
  if (!text || text->empty()) return std::nullopt;
  const std::vector<double> v = numbersIn(*text);
  if (v.size() < 3 || !allFinite(v)) {
    noteReplaced(parent, name, *text, "red, green, blue and alpha from 0 to 1 are needed",
                 "it is left out", location, reading);
    return std::nullopt;
  }
  const Eigen::Vector4d colour(v[0], v[1], v[2], v.size() > 3 ? v[3] : 1.0);
  const Eigen::Vector4d clamped = colour.cwiseMax(0.0).cwiseMin(1.0);
  if (clamped != colour) {
    noteReplaced(parent, name, *text, "colours are 0 to 1", "it is clamped", location, reading);
  }
  return clamped.cast<float>();
}

RelativePose readPose(const Element& parent, const SourceLocation& location, SdfReading& reading) {
  RelativePose result;
  const Element element = poseElement(parent);
  if (!element) return result;
  const bool is_frame_old = element.file().version < SdfVersion{1, 7};
  result.frame = element.attribute("relative_to");
  if (result.frame.empty() && is_frame_old) result.frame = element.attribute("frame");
  const std::string text =
      element.hasAttribute("pose") ? element.attribute("pose") : element.text();
  if (text.empty()) return result;
  const std::vector<double> values = numbersIn(text);
  const char* name = parent.has("pose") ? "pose" : "origin";
  if (!isWithinReach(values)) {
    noteReplaced(parent, name, text, "finite numbers up to 1e7 are needed", "0 0 0 0 0 0 is taken",
                 location, reading);
    return result;
  }
  const std::size_t needed = element.attribute("rotation_format") == "quat_xyzw" ? 7 : 6;
  if (values.size() != needed) {
    noteReplaced(parent, name, text, std::to_string(needed) + " numbers are needed",
                 values.size() > needed ? "the first ones count" : "the others are taken for 0",
                 location, reading);
  }
  result.pose = poseOf(values, element);
  return result;
}

bool hasPose(const Element& parent) { return static_cast<bool>(poseElement(parent)); }

}  // namespace synthetic_dataset::world
