#pragma once

#include <functional>
#include <string>

#include "programs/setup_assistant/live/live_worker.h"
#include "programs/setup_assistant/live/picture_cache.h"
#include "programs/setup_assistant/service/document_service.h"
#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// The set-up that results from the settings, and pictures of it.
class LiveService {
 public:
  using OnSetup = std::function<void(const Value& setup)>;

  /// @param document  has to outlive this
  /// @param on_setup  receives the resulting set-up after each change of the settings
  LiveService(DocumentService& document, OnSetup on_setup);

  /// To be called when the settings have changed: reads the set-up again in the background.
  void refresh();

  /// Refuses all requests from now on, and interrupts a set-up in progress.
  void close() { worker_.close(); }

  [[nodiscard]] Value setup();

  /// All formats; their writers are loaded in the same thread as those of a run.
  [[nodiscard]] Value formats();

  /// The full check of the run, whose findings are added to the set-up.
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
  [[nodiscard]] Value pick(const HttpRequest& request);
  [[nodiscard]] HttpResponse picture(const std::string& name) const;

 private:
  /// Has a job done with the current settings and waits for it. Of waiting jobs of one kind and
  /// page, which the header X-Page names, only the latest is done.
  [[nodiscard]] Value latest(const std::string& kind, const HttpRequest& request,
                             const LiveWorker::Job& job);

  /// Like latest(), but for jobs that do the same for all pages: one answers all that wait.
  [[nodiscard]] Value once(const std::string& kind, const LiveWorker::Job& job);

  [[nodiscard]] LiveWorker::Job withSettings(const LiveWorker::Job& job);
  [[nodiscard]] Value readSetup(run::LiveRun& live);
  [[nodiscard]] Value setupView(const run::LiveSetup& setup) const;
  void prepare(run::LiveRun& live);

  DocumentService& document_;
  OnSetup on_setup_;
  PictureCache pictures_;
  EffectiveSettings shown_;  ///< last given to LiveRun; only the worker's thread uses it
  LiveWorker worker_;        ///< declared last: its jobs use the other members
};

}  // namespace synthetic_dataset::programs
