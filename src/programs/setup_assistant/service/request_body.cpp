#include "programs/setup_assistant/service/request_body.h"

#include "base/json_text.h"
#include "base/yaml_scalar.h"

namespace synthetic_dataset::programs {
namespace {

const Value* bodyEntry(const Value& body, const std::string& name) {
  const auto* map = body.as<Value::Map>();
  if (map == nullptr) return nullptr;
  const auto found = map->find(name);
  return found == map->end() ? nullptr : &found->second;
}

}  // namespace

Value bodyOf(const HttpRequest& request) {
  if (request.body.empty()) return Value::Map{};
  try {
    return base::parseJson(request.body, "the request");
  } catch (const Error& error) {
    throw HttpError(400, error.what());
  }
}

const Value& requiredOf(const Value& body, const std::string& name) {
  const Value* value = bodyEntry(body, name);
  if (value == nullptr) throw HttpError(400, name + ": found nothing; it is required");
  return *value;
}

std::int64_t wholeNumberOf(const Value& body, const std::string& name) {
  const Value& value = requiredOf(body, name);
  if (const auto* number = value.as<std::int64_t>()) return *number;
  throw HttpError(400, name + ": found " + value.text() + "; it should be a whole number");
}

Value entryOf(const Value& body, const std::string& name) {
  const Value* value = bodyEntry(body, name);
  return value == nullptr ? Value() : *value;
}

double numberOf(const Value& body, const std::string& name, double fallback) {
  const Value* value = bodyEntry(body, name);
  if (value == nullptr) return fallback;
  if (const auto* whole = value->as<std::int64_t>()) return static_cast<double>(*whole);
  if (const auto* number = value->as<double>()) return *number;
  throw HttpError(400, name + ": found " + value->text() + "; it should be a number");
}

std::string textOf(const Value& body, const std::string& name) {
  const Value* value = bodyEntry(body, name);
  const auto* text = value == nullptr ? nullptr : value->as<std::string>();
  return text == nullptr ? "" : *text;
}

std::int64_t wholeParameter(const HttpRequest& request, const std::string& name,
                            std::int64_t fallback) {
  const auto text = request.parameter(name);
  if (!text) return fallback;
  if (const auto number = base::asInteger(*text)) return *number;
  throw HttpError(400, name + ": found '" + *text + "'; it should be a whole number");
}

double numberParameter(const HttpRequest& request, const std::string& name, double fallback) {
  const auto text = request.parameter(name);
  if (!text) return fallback;
  if (const auto number = base::decimalNumber(*text)) return *number;
  throw HttpError(400, name + ": found '" + *text + "'; it should be a number");
}

}  // namespace synthetic_dataset::programs
