#include "programs/setup_assistant/service/live_views.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "programs/setup_assistant/service/request_body.h"
#include "run/live/live_scene.h"
#include "run/live/live_world.h"
#include "run/live/object_portrait.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

constexpr std::int64_t kMostDraws = 25;
constexpr std::int64_t kNarrowest = 64;  // of a portrait [px]
constexpr std::int64_t kWidest = 1600;

int portraitWidth(std::int64_t wanted) {
  return static_cast<int>(std::clamp(wanted, kNarrowest, kWidest));
}

/// A picture's address; nothing where there is no picture.
Value addressOf(const cv::Mat& picture, const std::string& extension, PictureCache& pictures) {
  return picture.empty() ? Value() : Value(pictures.add(picture, extension));
}

}  // namespace

Value sceneView(run::LiveRun& live, const HttpRequest& request, PictureCache& pictures) {
  const run::LiveScene made =
      live.scene(wholeParameter(request, "instant", 0), request.parameter("camera").value_or(""));
  Value::Map value = run::sceneValue(made);
  value["picture"] = pictures.add(made.scene.image, ".jpg");
  value["depth"] = pictures.add(run::depthPicture(made.scene.depth()), ".jpg");
  value["instances"] = pictures.add(run::instancePicture(made.scene.instance_map()), ".png");
  return value;
}

Value worldView(run::LiveRun& live, PictureCache& pictures) {
  const run::LiveWorld world = live.world();
  Value::Map value = run::liveWorldValue(world);
  value["map"] = addressOf(world.map.picture, ".png", pictures);
  return value;
}

Value placementView(run::LiveRun& live, PictureCache& pictures) {
  const auto map = live.placementMap();
  if (!map) throw HttpError(404, "the settings name no occupancy map (placement/map)");
  return Value::Map{{"picture", addressOf(map->picture, ".png", pictures)},
                    {"extent", run::extentValue(map->extent)}};
}

Value drawsView(run::LiveRun& live, const HttpRequest& request, PictureCache& pictures) {
  const std::int64_t count =
      std::clamp<std::int64_t>(wholeParameter(request, "count", 9), 1, kMostDraws);
  Value::List list;
  for (const run::LiveDraw& draw :
       live.draws(static_cast<std::size_t>(count), wholeParameter(request, "instant", 0),
                  request.parameter("camera").value_or(""))) {
    list.push_back(Value::Map{{"picture", addressOf(draw.picture, ".jpg", pictures)},
                              {"draws", run::drawsValue(draw)}});
  }
  return Value::Map{{"pictures", Value(list)}};
}

Value modelView(run::LiveRun& live, const HttpRequest& request, PictureCache& pictures) {
  run::Viewpoint viewpoint;
  viewpoint.yaw = numberParameter(request, "yaw", viewpoint.yaw);
  viewpoint.pitch = numberParameter(request, "pitch", viewpoint.pitch);
  viewpoint.width = portraitWidth(wholeParameter(request, "width", viewpoint.width));
  const run::ObjectPortrait portrait =
      live.portrait(request.parameter("object").value_or(""), viewpoint);
  Value::Map value = run::portraitValue(portrait);
  value["picture"] = addressOf(portrait.picture, ".jpg", pictures);
  return value;
}

Value pickView(run::LiveRun& live, const Value& body) {
  run::Viewpoint viewpoint;
  viewpoint.yaw = numberOf(body, "yaw", viewpoint.yaw);
  viewpoint.pitch = numberOf(body, "pitch", viewpoint.pitch);
  viewpoint.width =
      portraitWidth(static_cast<std::int64_t>(numberOf(body, "width", viewpoint.width)));
  const auto point = live.pick(textOf(body, "object"), viewpoint,
                               {numberOf(body, "x", 0.0), numberOf(body, "y", 0.0)});
  if (!point) return Value::Map{{"link", Value()}, {"p", Value()}};
  return Value::Map{{"link", Value(point->link)},
                    {"p", Value(Value::List{Value(point->p_O.x()), Value(point->p_O.y()),
                                            Value(point->p_O.z())})}};
}

}  // namespace synthetic_dataset::programs
