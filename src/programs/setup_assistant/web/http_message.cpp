#include "programs/setup_assistant/web/http_message.h"

#include "base/json_text.h"

namespace synthetic_dataset::programs {

std::string HttpRequest::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? "" : found->second;
}

std::optional<std::string> HttpRequest::parameter(const std::string& name) const {
  const auto found = query.find(name);
  if (found == query.end()) return std::nullopt;
  return found->second;
}

HttpResponse jsonResponse(const Value& value, int status) {
  HttpResponse response;
  response.status = status;
  response.body = base::strictJsonText(value);
  return response;
}

HttpResponse errorResponse(int status, const std::string& message) {
  return jsonResponse(Value::Map{{"error", Value(message)}}, status);
}

}  // namespace synthetic_dataset::programs
