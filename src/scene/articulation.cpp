#include "scene/articulation.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "scene/link_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::scene {
namespace {

/// The frame of each link; nothing for links without one of their own.
using Frames = std::vector<std::optional<motion::FrameId>>;

Frames framesByPattern(const world::Model& model, const ObjectOptions& object,
                       const motion::FrameSource& source) {
  Frames frames;
  for (const world::Link& link : model.links) {
    std::optional<motion::FrameId> frame;
    for (const std::string& name : frameNames(model, link)) {
      if (frame) break;
      frame = source.find(frameByPattern(object.link_frames.pattern, object.name, name));
    }
    frames.push_back(frame);
  }
  return frames;
}

Frames framesByLink(const world::Model& model, const ObjectOptions& object,
                    const motion::FrameSource& source) {
  Frames frames(model.links.size());
  std::vector<std::string> names;
  for (const world::Link& link : model.links) names.push_back(link.name);
  std::vector<std::string> errors;
  for (const auto& [link, frame] : object.link_frames.by_link) {
    const std::string setting = object.name + "/link_frames/" + link + ": ";
    const auto found = std::find(names.begin(), names.end(), link);
    const auto id = source.find(frame);
    if (found == names.end()) {
      errors.push_back(setting + "the model has no link '" + link + "'" + didYouMean(link, names));
    } else if (!id) {
      errors.push_back(setting + source.lacks(frame));
    } else {
      frames[static_cast<std::size_t>(found - names.begin())] = id;
    }
  }
  if (!errors.empty()) throw ErrorList(std::move(errors));
  return frames;
}

/// The link at the object's own frame: the one that follows it, or else the one that it is named
/// after. A frame that is not named after a link carries the model's origin.
std::optional<std::size_t> ownLink(const world::Model& model, const ObjectOptions& object,
                                   const motion::FrameSource& source, const Frames& frames) {
  const std::optional<motion::FrameId> object_frame = source.find(object.frame);
  std::vector<std::size_t> without_frame;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i] && frames[i] == object_frame) return i;
    if (!frames[i]) without_frame.push_back(i);
  }
  return linkNamedBy(object.frame, model, without_frame);
}

/// Notes it if the link of the object's frame was not at the model's origin before it was moved
/// there.
void noteMovedOrigin(const ObjectOptions& object, const std::string& link, const Pose& X_ML,
                     base::Diagnostics& diagnostics) {
  constexpr double kSame = 1e-6;  // [m], [1]
  if (X_ML.isApprox(Pose::Identity(), kSame)) return;
  diagnostics.note(object.name, "its link '" + link + "' stands at the frame '" + object.frame +
                                    "'; the model's origin is " +
                                    fixed(X_ML.translation().norm(), 3) + " m from it");
}

bool hangsOnDriven(const world::Model& model, const Frames& frames, std::size_t link) {
  for (auto at = model.links[link].parent; at; at = model.links[*at].parent) {
    if (frames[*at]) return true;
  }
  return false;
}

/// Moves the model in its own frame so that a link lies at the origin.
void moveToOrigin(world::Model& model, std::size_t link) {
  const Pose X_LM = model.links[link].X_ML.inverse();
  for (world::Link& each : model.links) each.X_ML = X_LM * each.X_ML;
  model.links[link].X_ML = Pose::Identity();
}

std::string heldJoints(const world::Model& model, const Frames& frames) {
  std::string joints;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (frames[i] || model.links[i].moving_joint.empty()) continue;
    joints += (joints.empty() ? "'" : ", '") + model.links[i].moving_joint + "'";
  }
  return joints;
}

}  // namespace

Articulation articulate(world::Model model, const ObjectOptions& object,
                        const motion::FrameSource& source) {
  const Frames frames = object.link_frames.by_link.empty() ? framesByPattern(model, object, source)
                                                           : framesByLink(model, object, source);
  const std::optional<std::size_t> base = ownLink(model, object, source, frames);
  std::size_t others = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) others += frames[i] && i != base ? 1 : 0;
  Articulation result;
  const std::string joints = heldJoints(model, frames);
  if (base) {
    noteMovedOrigin(object, model.links[*base].name, model.links[*base].X_ML, result.diagnostics);
    moveToOrigin(model, *base);
  }
  if (others > 0) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      // The link of the object's own frame is part of its body, unless another driven link would
      // carry it.
      const auto frame = i == base ? source.find(object.frame) : frames[i];
      if (!frame || (i == base && !hangsOnDriven(model, frames, i))) continue;
      result.driven.push_back({i, *frame});
    }
    result.diagnostics.note(object.name, std::to_string(others + (base ? 1 : 0)) + " of " +
                                             std::to_string(model.links.size()) +
                                             " links follow TF");
  }
  if (!joints.empty()) {
    result.diagnostics.note(object.name, "no TF moves its joints " + joints +
                                             "; they stay where the model places them");
  }
  result.model = std::move(model);
  return result;
}

}  // namespace synthetic_dataset::scene
