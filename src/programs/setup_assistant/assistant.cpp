#include "programs/setup_assistant/assistant.h"

#include <set>
#include <sstream>
#include <utility>

#include "base/json_text.h"
#include "programs/setup_assistant/catalogue/catalogue.h"
#include "programs/setup_assistant/folders/file_browser.h"
#include "programs/setup_assistant/service/request_body.h"
#include "programs/setup_assistant/service/start_service.h"

namespace synthetic_dataset::programs {
namespace {

const std::string kPagePath = "/page/";
const std::string kResultPath = "/api/result/image/";
const std::string kPicturePath = "/api/picture/";

std::set<std::string> wordsBetweenCommas(const std::string& text) {
  std::set<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) words.insert(word);
  return words;
}

bool isBelowAddress(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

}  // namespace

Assistant::Assistant(const std::string& file, const std::vector<std::string>& folders,
                     EmbeddedFiles page)
    : allowed_(file, folders),
      page_(std::move(page)),
      document_(file, allowed_,
                [this] {
                  publish("state", document_.state());
                  live_->refresh();
                }),
      result_(document_, allowed_) {
  live_ = std::make_unique<LiveService>(document_,
                                        [this](const Value& setup) { publish("setup", setup); });
  run_ = std::make_unique<RunService>(
      document_, allowed_, [this](const Value& state) { publish("run", state); },
      [this] { live_->refresh(); });
  addDocumentRoutes();
  addCatalogueRoutes();
  addLiveRoutes();
  addRunRoutes();
  live_->refresh();
  ticker_.emplace([this] {
    document_.look();
    run_->look();
  });
}

void Assistant::close() {
  ticker_.reset();
  live_->close();
  events_.close();
}

HttpResponse Assistant::answer(const HttpRequest& request) {
  const auto route = routes_.find(request.method + " " + request.path);
  if (route != routes_.end()) return route->second(request);
  if (request.method == "GET" && request.path == "/") return pageFile("index.html");
  if (request.method == "GET" && isBelowAddress(request.path, kPagePath)) {
    return pageFile(request.path.substr(kPagePath.size()));
  }
  if (request.method == "GET" && isBelowAddress(request.path, kPicturePath)) {
    return live_->picture(request.path.substr(kPicturePath.size()));
  }
  if (request.method == "GET" && isBelowAddress(request.path, kResultPath)) {
    return result_.picture(request.path.substr(kResultPath.size()), request);
  }
  throw HttpError(404, request.method + " " + request.path + ": there is no such request");
}

void Assistant::addDocumentRoutes() {
  get("/api/state", [this](const HttpRequest&) { return document_.state(); });
  post("/api/set", [this](const Value& body) { return document_.set(body); });
  post("/api/text", [this](const Value& body) { return document_.type(body); });
  post("/api/start", [this](const Value& body) {
    Value::Map typed = {{"revision", requiredOf(body, "revision")},
                        {"text", Value(startText(body, allowed_))}};
    return document_.type(Value(std::move(typed)));
  });
  post("/api/undo", [this](const Value&) { return document_.undo(); });
  post("/api/redo", [this](const Value&) { return document_.redo(); });
  post("/api/outside", [this](const Value& body) { return document_.decideOutside(body); });
  routes_["GET /api/events"] = [this](const HttpRequest&) {
    HttpResponse response;
    response.type = "text/event-stream";
    response.events = events_.subscribe();
    response.events->push("state", base::strictJsonText(document_.state()));
    return response;
  };
}

void Assistant::addCatalogueRoutes() {
  get("/api/parameters", [](const HttpRequest&) { return parameterList(); });
  get("/api/formats", [this](const HttpRequest&) { return live_->formats(); });
  get("/api/files", [this](const HttpRequest& request) {
    return listFolder(allowed_, request.parameter("folder").value_or(""),
                      wordsBetweenCommas(request.parameter("kind").value_or("")));
  });
}

void Assistant::addLiveRoutes() {
  get("/api/setup", [this](const HttpRequest&) { return live_->setup(); });
  post("/api/check", [this](const Value&) { return live_->check(); });
  get("/api/scene", [this](const HttpRequest& request) { return live_->scene(request); });
  routes_["GET /api/glance"] = [this](const HttpRequest& request) {
    return live_->glance(request);
  };
  get("/api/draws", [this](const HttpRequest& request) { return live_->draws(request); });
  get("/api/recording", [this](const HttpRequest&) { return live_->recording(); });
  get("/api/world", [this](const HttpRequest&) { return live_->world(); });
  get("/api/placement", [this](const HttpRequest&) { return live_->placement(); });
  get("/api/model", [this](const HttpRequest& request) { return live_->model(request); });
  routes_["POST /api/pick"] = [this](const HttpRequest& request) {
    return jsonResponse(live_->pick(request));
  };
}

void Assistant::addRunRoutes() {
  get("/api/run", [this](const HttpRequest&) { return run_->state(); });
  post("/api/run/start", [this](const Value& body) { return run_->start(body); });
  post("/api/run/stop", [this](const Value&) { return run_->stop(); });
  get("/api/result", [this](const HttpRequest& request) { return result_.page(request); });
  post("/api/verify", [this](const Value&) { return result_.verify(); });
  post("/api/report", [this](const Value&) { return result_.makeReport(); });
  routes_["GET /api/report"] = [this](const HttpRequest&) { return result_.report(); };
}

void Assistant::get(const std::string& path,
                    const std::function<Value(const HttpRequest&)>& answer) {
  routes_["GET " + path] = [answer](const HttpRequest& request) {
    return jsonResponse(answer(request));
  };
}

void Assistant::post(const std::string& path, const std::function<Value(const Value&)>& answer) {
  routes_["POST " + path] = [answer](const HttpRequest& request) {
    return jsonResponse(answer(bodyOf(request)));
  };
}

void Assistant::publish(const std::string& name, const Value& value) {
  events_.publish(name, base::strictJsonText(value));
}

HttpResponse Assistant::pageFile(const std::string& name) const {
  const auto content = page_.find(name);
  if (!content) throw HttpError(404, "the page has no file '" + name + "'");
  HttpResponse response;
  response.type = mediaTypeOf(name);
  response.body = *content;
  return response;
}

}  // namespace synthetic_dataset::programs
