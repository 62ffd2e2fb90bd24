#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "programs/console/ticker.h"
#include "programs/embedded/embedded_files.h"
#include "programs/setup_assistant/folders/allowed_folders.h"
#include "programs/setup_assistant/service/document_service.h"
#include "programs/setup_assistant/service/live_service.h"
#include "programs/setup_assistant/service/result_service.h"
#include "programs/setup_assistant/service/run_service.h"
#include "programs/setup_assistant/web/event_stream.h"
#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// Answers the requests of the set-up page (docs/setup_assistant.md).
class Assistant {
 public:
  /// @param file  the settings file, which exists
  /// @param folders  more folders that the page may look into
  /// @param page  the page's files
  Assistant(const std::string& file, const std::vector<std::string>& folders, EmbeddedFiles page);
  ~Assistant() { close(); }
  Assistant(const Assistant&) = delete;
  Assistant& operator=(const Assistant&) = delete;

  /// Answers a request that has been admitted. Called from many threads.
  /// @throws HttpError, Error if the request cannot be fulfilled
  [[nodiscard]] HttpResponse answer(const HttpRequest& request);

  /// Ends all streams of events, so that the server can end.
  void close();

 private:
  using Route = std::function<HttpResponse(const HttpRequest& request)>;

  void addDocumentRoutes();
  void addCatalogueRoutes();
  void addLiveRoutes();
  void addRunRoutes();
  void get(const std::string& path, const std::function<Value(const HttpRequest&)>& answer);
  void post(const std::string& path, const std::function<Value(const Value& body)>& answer);
  void publish(const std::string& name, const Value& value);
  [[nodiscard]] HttpResponse pageFile(const std::string& name) const;

  AllowedFolders allowed_;
  EmbeddedFiles page_;
  EventHub events_;
  DocumentService document_;
  std::unique_ptr<LiveService> live_;
  std::unique_ptr<RunService> run_;
  ResultService result_;
  std::map<std::string, Route> routes_;  ///< by "GET /api/state"
  std::optional<Ticker> ticker_;         ///< watches the file and the run; is destroyed first
};

}  // namespace synthetic_dataset::programs
