#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/description.h"
#include "world/files/findings.h"
#include "world/sdf/element.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {

/// The names in one model or world to which poses may be relative: links, joints, frames and models
/// in it, and the names in those models as "model::name" (SDF specification, "Pose frame
/// semantics"). F is the frame of the model or world itself.
class SdfFrames {
 public:
  /// Adds a name, unless it is empty or known already: the first one counts then.
  /// @param fallback  the frame for a pose that names none, or an unknown one; empty for F
  void add(const std::string& name, const RelativePose& pose, const std::string& fallback,
           const SourceLocation& location);

  /// Adds the names of a model within this one.
  /// @param name  that model's name, which has been added already
  /// @param prefix  prefix for its names: "name::", or empty if it is merged
  void addInner(const std::string& name, const std::string& prefix, SdfFrames& inner,
                SdfReading& reading);

  [[nodiscard]] bool knows(const std::string& name) const { return frames_.count(name) > 0; }

  /// The pose in F of a named frame; the empty name is F itself. A cycle is broken where it closes,
  /// with a note.
  [[nodiscard]] Pose poseOf(const std::string& name, SdfReading& reading);

  /// Converts a pose to F. An unknown frame is noted, and replaced by the fallback.
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

/// A model as its file describes it, with the overrides of an `<include>`.
struct ModelSource {
  enum class Kind { kModel, kUrdf, kLight, kActor, kNothing };

  Kind kind = Kind::kModel;
  Element element;  ///< `<model>`, `<light>`, `<actor>`, or the root of a URDF
  std::string name;
  RelativePose pose;
  std::string placement_frame;  ///< the frame that `pose` places; empty: the model's own frame
  bool is_static = false;
  std::optional<int> label;         ///< given by gz-sim's label plugin
  bool merges = false;              ///< its contents become part of the model around it
  bool has_gaps = false;            ///< a model in it is missing, which has been reported
  std::vector<ModelSource> models;  ///< the models in it, in the order of the file
  SourceLocation location{""};
  SdfFrames frames;                       ///< the names in it; filled by fillFrames
  std::shared_ptr<const UrdfModel> urdf;  ///< what a URDF holds; filled by fillFrames
};

/// The pose of a model's own frame, whichever frame its placement_frame names.
[[nodiscard]] RelativePose placed(ModelSource& source, SdfReading& reading);

/// Fills the frames of a model and of the models in it.
void fillFrames(ModelSource& source, SdfReading& reading);

}  // namespace synthetic_dataset::world
