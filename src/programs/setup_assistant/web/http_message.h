#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "programs/setup_assistant/web/event_stream.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

struct HttpRequest {
  std::string method;                          ///< "GET"
  std::string path;                            ///< "/api/state"; percent-decoded
  std::map<std::string, std::string> query;    ///< percent-decoded, too
  std::map<std::string, std::string> headers;  ///< by their names in lower case
  std::string body;

  /// @return empty if there is none
  [[nodiscard]] std::string header(const std::string& name) const;
  [[nodiscard]] std::optional<std::string> parameter(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json; charset=utf-8";
  std::string body;
  std::map<std::string, std::string> headers;
  std::shared_ptr<EventStream> events;  ///< instead of a body; sent until the stream is closed
};

/// The error of a request that cannot be fulfilled; the status says why.
class HttpError : public Error {
 public:
  HttpError(int status, const std::string& message) : Error(message), status_(status) {}
  [[nodiscard]] int status() const { return status_; }

 private:
  int status_;
};

[[nodiscard]] HttpResponse jsonResponse(const Value& value, int status = 200);
[[nodiscard]] HttpResponse errorResponse(int status, const std::string& message);

}  // namespace synthetic_dataset::programs
