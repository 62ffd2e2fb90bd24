#pragma once

#include <functional>
#include <string>

#include "programs/setup_assistant/live/live_worker.h"
#include "programs/setup_assistant/live/picture_cache.h"
#include "programs/setup_assistant/service/document_service.h"
#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// What the settings amount to, and pictures of it.
class LiveService {
 public:
  using OnSetup = std::function<void(const Value& setup)>;

  /// @param document  has to outlive this
  /// @param on_setup  gets what the settings amount to after each change
  LiveService(DocumentService& document, OnSetup on_setup);

  /// The settings have changed: finds out in the background what they amount to.
  void refresh();

  /// Answers nothing any more; what takes long is broken off.
  void close() { worker_.close(); }

  [[nodiscard]] Value setup();

  /// All formats; their writers are loaded where a run's are.
  [[nodiscard]] Value formats();

  /// The full check of the run, whose findings are added to what the settings amount to.
  [[nodiscard]] Value check();

  [[nodiscard]] Value scene(const HttpRequest& request);
  /// A coarse picture, a JPEG, from a camera that is moved: LiveRun::glance.
  /// @param request  instant, camera, and its optical frame's pose: x, y, z, qx, qy, qz, qw
  [[nodiscard]] HttpResponse glance(const HttpRequest& request);
  [[nodiscard]] Value draws(const HttpRequest& request);
  [[nodiscard]] Value recording();
  [[nodiscard]] Value world();
  [[nodiscard]] Value placement();
  [[nodiscard]] Value model(const HttpRequest& request);
  [[nodiscard]] Value pick(const Value& body);
  [[nodiscard]] HttpResponse picture(const std::string& name) const;

 private:
  /// Waits for a job with the current settings. Of those of one kind and page, the latest wins.
  [[nodiscard]] Value latest(const std::string& kind, const HttpRequest& request,
                             const LiveWorker::Job& job);

  /// The same for jobs that do the same for all pages.
  [[nodiscard]] Value once(const std::string& kind, const LiveWorker::Job& job);

  [[nodiscard]] LiveWorker::Job withSettings(const LiveWorker::Job& job);
  [[nodiscard]] Value readSetup(run::LiveRun& live);
  [[nodiscard]] Value setupView(const run::LiveSetup& setup) const;
  void prepare(run::LiveRun& live);

  DocumentService& document_;
  OnSetup on_setup_;
  PictureCache pictures_;
  EffectiveSettings shown_;  ///< to LiveRun; only the worker's thread uses it
  LiveWorker worker_;        ///< last: its jobs use the others
};

}  // namespace synthetic_dataset::programs
