#pragma once

/// Reads the values of elements. A value that cannot be understood is replaced by the fallback,
/// with a note.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The numbers that a text begins with, as a C++ stream reads them: "1.6-0.19" holds two.
[[nodiscard]] std::vector<double> numbersIn(const std::string& text);

/// @param location  of `parent`
[[nodiscard]] double readNumber(const Element& parent, const char* name, double fallback,
                                const SourceLocation& location, SdfReading& reading);

/// Accepts true, 1, false and 0, in upper or lower case.
[[nodiscard]] bool readBool(const Element& parent, const char* name, bool fallback,
                            const SourceLocation& location, SdfReading& reading);

/// An empty text if the file gives none, or gives "__default__", as files saved by Gazebo do.
[[nodiscard]] std::string readText(const Element& parent, const char* name);

/// Three finite numbers.
[[nodiscard]] Eigen::Vector3d readVector(const Element& parent, const char* name,
                                         const Eigen::Vector3d& fallback,
                                         const SourceLocation& location, SdfReading& reading);

/// Red, green, blue and alpha, which is 1 if the file omits it. Components outside 0 .. 1 are
/// clamped, as in Gazebo, with a note.
/// @return nothing if the file has no such element, or if it is not a colour
[[nodiscard]] std::optional<Eigen::Vector4f> readColour(const Element& parent, const char* name,
                                                        const SourceLocation& location,
                                                        SdfReading& reading);

/// A pose and the name of the frame that it is given in; empty if the file names none.
struct RelativePose {
  Pose pose = Pose::Identity();
  std::string frame;
};

/// An element's `<pose>`: metres, and roll, pitch, yaw in radians or degrees, or a quaternion (SDF
/// specification, "Pose frame semantics"); identity if it has none.
/// @param location  of `parent`
[[nodiscard]] RelativePose readPose(const Element& parent, const SourceLocation& location,
                                    SdfReading& reading);

/// Whether an element has a pose.
[[nodiscard]] bool hasPose(const Element& parent);

/// The end of a note that says which value was used instead.
[[nodiscard]] std::string takenInstead(double fallback);

/// A number as people write it: "0.5", "1e+300".
[[nodiscard]] std::string shortText(double value);

}  // namespace synthetic_dataset::world
