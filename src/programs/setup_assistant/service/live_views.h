#pragma once

#include "programs/setup_assistant/live/picture_cache.h"
#include "programs/setup_assistant/web/http_message.h"
#include "run/live/live_run.h"
#include "synthetic_dataset/value.h"

/// What pages are shown of a run: values of LiveRun, with the addresses of their pictures.
namespace synthetic_dataset::programs {

[[nodiscard]] Value sceneView(run::LiveRun& live, const HttpRequest& request,
                              PictureCache& pictures);
[[nodiscard]] Value worldView(run::LiveRun& live, PictureCache& pictures);
[[nodiscard]] Value placementView(run::LiveRun& live, PictureCache& pictures);
[[nodiscard]] Value drawsView(run::LiveRun& live, const HttpRequest& request,
                              PictureCache& pictures);
[[nodiscard]] Value modelView(run::LiveRun& live, const HttpRequest& request,
                              PictureCache& pictures);

/// What a click on a model's picture means.
/// @param body  object, yaw, pitch, width, and x and y [px]
[[nodiscard]] Value pickView(run::LiveRun& live, const Value& body);

}  // namespace synthetic_dataset::programs
