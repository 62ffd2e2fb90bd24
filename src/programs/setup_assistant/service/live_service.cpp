#include "programs/setup_assistant/service/live_service.h"

#include <utility>

#include "programs/setup_assistant/catalogue/problem_fields.h"
#include "programs/setup_assistant/service/live_views.h"
#include "run/live/live_recording.h"
#include "run/live/live_setup.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

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

Value LiveService::pick(const Value& body) {
  return latest("pick", {}, [body](run::LiveRun& live) { return pickView(live, body); });
}

HttpResponse LiveService::picture(const std::string& name) const {
  const auto bytes = pictures_.find(name);
  if (bytes == nullptr) throw HttpError(404, "this picture is not kept any more; ask for it anew");
  HttpResponse response;
  response.type = name.find(".png") != std::string::npos ? "image/png" : "image/jpeg";
  response.body = *bytes;
  // Its address never means another picture.
  response.headers["Cache-Control"] = "private, max-age=3600, immutable";
  return response;
}

Value LiveService::latest(const std::string& kind, const HttpRequest& request,
                          const LiveWorker::Job& job) {
  const std::string page = request.parameter("view").value_or("");
  return worker_.ask(kind + " of " + page, withSettings(job)).get();
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
