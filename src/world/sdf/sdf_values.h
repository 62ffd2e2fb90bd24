#pragma once

/// The values of elements. What cannot be understood is replaced by the fallback, with a note.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The numbers that a text begins with, as a C++ stream finds them: "1.6-0.19" holds two.
[[nodiscard]] std::vector<double> numbersIn(const std::string& text);

/// @param location  of `parent`
[[nodiscard]] double readNumber(const Element& parent, const char* name, double fallback,
                                const SourceLocation& location, SdfReading& reading);

/// true, 1, false or 0, in any case.
[[nodiscard]] bool readBool(const Element& parent, const char* name, bool fallback,
                            const SourceLocation& location, SdfReading& reading);

/// An empty text where the file does not say, or says "__default__", as files that Gazebo saved do.
[[nodiscard]] std::string readText(const Element& parent, const char* name);

/// Finite numbers.
[[nodiscard]] Eigen::Vector3d readVector(const Element& parent, const char* name,
                                         const Eigen::Vector3d& fallback,
                                         const SourceLocation& location, SdfReading& reading);

/// Red, green, blue and alpha, which is 1 where the file leaves it out. What lies beyond 0 .. 1
/// is brought there, as in Gazebo, with a note.
/// @return nothing where the file has no such element, or it is no colour
[[nodiscard]] std::optional<Eigen::Vector4f> readColour(const Element& parent, const char* name,
                                                        const SourceLocation& location,
                                                        SdfReading& reading);

/// A pose and the name of the frame that it is given in, empty where the file does not say.
struct RelativePose {
  Pose pose = Pose::Identity();
  std::string frame;
};

/// An element's `<pose>`: metres, and roll, pitch, yaw in radians or degrees, or a quaternion (SDF
/// specification, "Pose frame semantics"), identity without one.
/// @param location  of `parent`
[[nodiscard]] RelativePose readPose(const Element& parent, const SourceLocation& location,
                                    SdfReading& reading);

/// Whether an element says where it is.
[[nodiscard]] bool hasPose(const Element& parent);

/// The part that a note adds where a value was replaced.
[[nodiscard]] std::string takenInstead(double fallback);

/// A number as people write it: "0.5", "1e+300".
[[nodiscard]] std::string shortText(double value);

}  // namespace synthetic_dataset::world
