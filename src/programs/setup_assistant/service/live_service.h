#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
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

  [[nodiscard]] Value setup();
  [[nodiscard]] Value scene(const HttpRequest& request);
  [[nodiscard]] HttpResponse picture(const std::string& name) const;

 private:
  /// Does a job with the current settings, and waits for it.
  [[nodiscard]] Value ask(const std::string& kind, const LiveWorker::Job& job);
  [[nodiscard]] Value readSetup(run::LiveRun& live);
  void prepare(run::LiveRun& live);

  DocumentService& document_;
  OnSetup on_setup_;
  PictureCache pictures_;
  EffectiveSettings shown_;  ///< to LiveRun; only the worker's thread uses it
  LiveWorker worker_;        ///< last: its jobs use the others
};

}  // namespace synthetic_dataset::programs
