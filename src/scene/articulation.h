#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "motion/frame_source.h"
#include "scene/object_options.h"
#include "world/description.h"

namespace synthetic_dataset::scene {

/// A link that follows a frame of its own.
struct DrivenLink {
  std::size_t link = 0;  ///< index in the model's links
  motion::FrameId frame = motion::kNoFrame;
};

using DrivenLinks = std::vector<DrivenLink>;

/// How an object follows frames.
struct Articulation {
  /// The object's model. If one of its links follows the object's frame, or the frame is named
  /// after it, the model is moved in its own frame so that this link lies at the origin.
  world::Model model;
  DrivenLinks driven;             ///< by index; empty: the model moves as one piece
  base::Diagnostics diagnostics;  ///< what the user may want to know
};

/// Decides which links of an object's model follow frames of their own.
/// @throws ErrorList with links and frames of `link_frames` that do not exist
[[nodiscard]] Articulation articulate(world::Model model, const ObjectOptions& object,
                                      const motion::FrameSource& source);

}  // namespace synthetic_dataset::scene
