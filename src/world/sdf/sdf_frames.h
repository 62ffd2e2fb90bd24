#pragma once

#include <map>
#include <optional>
#include <string>

#include "synthetic_dataset/pose.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {

/// The names in one model or world to which poses may be relative: links, joints, frames, models
/// within it, and theirs as "model::name" (SDF specification, "Pose frame semantics"). F is the
/// frame of the model or world itself.
class SdfFrames {
 public:
  /// Adds a name, unless it is empty, or known: then the first one counts.
  /// @param fallback  the frame of a pose that names none, or an unknown one; empty for F
  void add(const std::string& name, const RelativePose& pose, const std::string& fallback,
           const SourceLocation& location);

  /// Adds the names of a model within this one.
  /// @param name  of that model, which has been added
  /// @param prefix  of its names: "name::", or empty where it is merged
  void addInner(const std::string& name, const std::string& prefix, SdfFrames& inner,
                SdfReading& reading);

  [[nodiscard]] bool knows(const std::string& name) const { return frames_.count(name) > 0; }

  /// The pose of a name in F; of the empty one, F itself. A circle is cut where it closes, with a
  /// note.
  [[nodiscard]] Pose poseOf(const std::string& name, SdfReading& reading);

  /// A pose in F. A frame that is not known is noted, and the fallback taken.
  [[nodiscard]] Pose resolve(const RelativePose& pose, const std::string& fallback,
                             const SourceLocation& location, SdfReading& reading);

 private:
  struct Frame {
    RelativePose pose;
    std::string fallback;
    SourceLocation location;
    std::optional<Pose> X_FN;  ///< once known
    bool is_open = false;      ///< being resolved
  };

  [[nodiscard]] static bool isOwn(const std::string& name);

  std::map<std::string, Frame> frames_;
};

}  // namespace synthetic_dataset::world
