#include "programs/setup_assistant/service/live_service.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "programs/setup_assistant/catalogue/catalogue.h"
#include "programs/setup_assistant/service/request_body.h"
#include "run/live/live_recording.h"
#include "run/live/live_scene.h"
#include "run/live/live_setup.h"
#include "run/live/live_world.h"
#include "run/live/object_portrait.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

// The views of a run that pages show: values of LiveRun, with the addresses of their pictures.

constexpr std::int64_t kMostDraws = 25;
constexpr std::int64_t kNarrowest = 64;  // of a portrait [px]
constexpr std::int64_t kWidest = 1600;

int portraitWidth(std::int64_t wanted) {
  return static_cast<int>(std::clamp(wanted, kNarrowest, kWidest));
}

/// A picture's address; null if there is no picture.
Value addressOf(const cv::Mat& picture, const std::string& extension, PictureCache& pictures) {
  return picture.empty() ? Value() : Value(pictures.add(picture, extension));
}

Pose poseParameter(const HttpRequest& request) {
  const auto number = [&](const char* name, double fallback) {
    return numberParameter(request, name, fallback);
  };
  const Eigen::Quaterniond turn(number("qw", 1.0), number("qx", 0.0), number("qy", 0.0),
                                number("qz", 0.0));
  if (!(turn.norm() > 0.5)) throw HttpError(400, "qx, qy, qz, qw: found no rotation");
  Pose pose = Pose::Identity();
  pose.linear() = turn.normalized().toRotationMatrix();
  pose.translation() << number("x", 0.0), number("y", 0.0), number("z", 0.0);
  return pose;
}

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

/// The link and the point on it that a click on a model's picture hits.
/// @param body  object, yaw, pitch, width, and x and y [px]
Value pickView(run::LiveRun& live, const Value& body) {
  run::Viewpoint viewpoint;
  viewpoint.yaw = numberOf(body, "yaw", viewpoint.yaw);
  viewpoint.pitch = numberOf(body, "pitch", viewpoint.pitch);
  viewpoint.width =
      portraitWidth(std::llround(std::clamp(numberOf(body, "width", viewpoint.width), 0.0, 1e6)));
  const auto point = live.pick(textOf(body, "object"), viewpoint,
                               {numberOf(body, "x", 0.0), numberOf(body, "y", 0.0)});
  if (!point) return Value::Map{{"link", Value()}, {"p", Value()}};
  return Value::Map{{"link", Value(point->link)},
                    {"p", Value(Value::List{Value(point->p_O.x()), Value(point->p_O.y()),
                                            Value(point->p_O.z())})}};
}

}  // namespace

LiveService::LiveService(DocumentService& document, OnSetup on_setup)
    : document_(document), on_setup_(std::move(on_setup)) {}

void LiveService::refresh() {
  worker_.ask("refresh", [this](run::LiveRun& live) {
    on_setup_(readSetup(live));
    return Value();
  });
}

Value LiveService::setup() {
  return worker_.askOnce("setup", [this](run::LiveRun& live) { return readSetup(live); }).get();
}

Value LiveService::formats() {
  const auto list = [](run::LiveRun&) {
    static const Value kFormats = formatList();
    return kFormats;
  };
  return worker_.askOnce("formats", list).get();
}

Value LiveService::check() {
  const Value setup = once("check", [this](run::LiveRun& live) { return setupView(live.check()); });
  on_setup_(setup);
  return setup;
}

Value LiveService::scene(const HttpRequest& request) {
  return latest("scene", request, [this, request](run::LiveRun& live) {
    Value view = sceneView(live, request, pictures_);
    (*view.as<Value::Map>())["revision"] = shown_.revision;
    return view;
  });
}

HttpResponse LiveService::glance(const HttpRequest& request) {
  const Value picture = latest("glance", request, [request](run::LiveRun& live) {
    return Value(encodedPicture(
        live.glance(wholeParameter(request, "instant", 0), request.parameter("camera").value_or(""),
                    poseParameter(request)),
        ".jpg"));
  });
  HttpResponse response;
  response.type = "image/jpeg";
  response.body = picture.text();
  return response;
}

Value LiveService::draws(const HttpRequest& request) {
  return latest("draws", request, [this, request](run::LiveRun& live) {
    return drawsView(live, request, pictures_);
  });
}

Value LiveService::recording() {
  return once("recording",
              [](run::LiveRun& live) { return Value(run::recordingValue(live.recording())); });
}

Value LiveService::world() {
  return once("world", [this](run::LiveRun& live) { return worldView(live, pictures_); });
}

Value LiveService::placement() {
  return once("placement", [this](run::LiveRun& live) { return placementView(live, pictures_); });
}

Value LiveService::model(const HttpRequest& request) {
  return latest(
      "model " + request.parameter("object").value_or(""), request,
      [this, request](run::LiveRun& live) { return modelView(live, request, pictures_); });
}

Value LiveService::pick(const HttpRequest& request) {
  return latest("pick", request,
                [body = bodyOf(request)](run::LiveRun& live) { return pickView(live, body); });
}

HttpResponse LiveService::picture(const std::string& name) const {
  const auto bytes = pictures_.find(name);
  if (bytes == nullptr) throw HttpError(404, "this picture is no longer kept; request it again");
  HttpResponse response;
  response.type = name.find(".png") != std::string::npos ? "image/png" : "image/jpeg";
  response.body = *bytes;
  // An address never means another picture.
  response.headers["Cache-Control"] = "private, max-age=3600, immutable";
  return response;
}

Value LiveService::latest(const std::string& kind, const HttpRequest& request,
                          const LiveWorker::Job& job) {
  return worker_.ask(kind + " of " + request.header("x-page"), withSettings(job)).get();
}

Value LiveService::once(const std::string& kind, const LiveWorker::Job& job) {
  return worker_.askOnce(kind, withSettings(job)).get();
}

LiveWorker::Job LiveService::withSettings(const LiveWorker::Job& job) {
  return [this, job](run::LiveRun& live) {
    prepare(live);
    if (!shown_.settings) throw ErrorList(shown_.errors);
    return job(live);
  };
}

Value LiveService::readSetup(run::LiveRun& live) {
  prepare(live);
  if (shown_.settings) return setupView(live.setup());
  run::LiveSetup setup;
  for (const std::string& message : shown_.errors) {
    setup.problems.push_back(run::problemOf(base::Severity::kError, message));
  }
  return setupView(setup);
}

Value LiveService::setupView(const run::LiveSetup& setup) const {
  Value::Map value = run::setupValue(setup);
  addFields(value, shown_.settings.value_or(Value()));
  value["checked"] = setup.figures.has_value();
  value["revision"] = shown_.revision;
  return value;
}

void LiveService::prepare(run::LiveRun& live) {
  EffectiveSettings now = document_.effective();
  if (now.revision == shown_.revision) return;
  shown_ = std::move(now);
  if (shown_.settings) live.setSettings(*shown_.settings);
}

}  // namespace synthetic_dataset::programs
