#include "programs/setup_assistant/service/live_service.h"

#include <utility>

#include "programs/setup_assistant/service/request_body.h"
#include "run/live/live_scene.h"
#include "run/live/live_setup.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

LiveService::LiveService(DocumentService& document, OnSetup on_setup)
    : document_(document), on_setup_(std::move(on_setup)) {}

void LiveService::refresh() {
  (void)worker_.ask("refresh", [this](run::LiveRun& live) {
    on_setup_(readSetup(live));
    return Value();
  });
}

Value LiveService::setup() {
  return ask("setup", [this](run::LiveRun& live) { return readSetup(live); });
}

Value LiveService::scene(const HttpRequest& request) {
  const std::int64_t instant = wholeParameter(request, "instant", 0);
  const std::string camera = request.parameter("camera").value_or("");
  const std::string view = request.parameter("view").value_or("");
  return ask("scene " + view, [=](run::LiveRun& live) {
    if (!shown_.settings) throw ErrorList(shown_.errors);
    const run::LiveScene made = live.scene(instant, camera);
    Value::Map value = run::sceneValue(made);
    value["revision"] = shown_.revision;
    value["picture"] = pictures_.add(made.scene.image, ".jpg");
    value["depth"] = pictures_.add(run::depthPicture(made.scene.depth()), ".jpg");
    value["instances"] = pictures_.add(run::instancePicture(made.scene.instance_map()), ".png");
    return Value(value);
  });
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

Value LiveService::ask(const std::string& kind, const LiveWorker::Job& job) {
  return worker_
      .ask(kind,
           [this, job](run::LiveRun& live) {
             prepare(live);
             return job(live);
           })
      .get();
}

Value LiveService::readSetup(run::LiveRun& live) {
  prepare(live);
  run::LiveSetup setup;
  if (shown_.settings) {
    setup = live.setup();
  } else {
    for (const std::string& message : shown_.errors) {
      setup.problems.push_back(run::problemOf(base::Severity::kError, message));
    }
  }
  Value::Map value = run::setupValue(setup);
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
