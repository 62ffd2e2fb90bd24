#pragma once

#include <cstdint>
#include <string>

#include "programs/setup_assistant/web/http_message.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The JSON of a request; without a body, an empty group.
/// @throws HttpError 400 when it is not valid JSON
[[nodiscard]] Value bodyOf(const HttpRequest& request);

/// An entry of a body. @throws HttpError 400 when it is missing or of another kind
[[nodiscard]] const Value& requiredOf(const Value& body, const std::string& name);
[[nodiscard]] std::int64_t wholeNumberOf(const Value& body, const std::string& name);

/// An entry of a body; null if there is none.
[[nodiscard]] Value entryOf(const Value& body, const std::string& name);

/// A number; the fallback if there is none.
[[nodiscard]] double numberOf(const Value& body, const std::string& name, double fallback);

/// A text; empty if there is none.
[[nodiscard]] std::string textOf(const Value& body, const std::string& name);

/// A whole number, or any number, in the address; the fallback if there is none.
/// @throws HttpError 400 when it is not such a number
[[nodiscard]] std::int64_t wholeParameter(const HttpRequest& request, const std::string& name,
                                          std::int64_t fallback);
[[nodiscard]] double numberParameter(const HttpRequest& request, const std::string& name,
                                     double fallback);

}  // namespace synthetic_dataset::programs
