#include "output/writer_settings.h"

#include <cstddef>

namespace synthetic_dataset::output {

Value::Map writerSettings(const std::map<std::string, Value>& settings, const std::string& writer) {
  const std::string group = writer + "/";
  Value::Map parameters;
  for (auto each = settings.lower_bound(group);
       each != settings.end() && each->first.compare(0, group.size(), group) == 0; ++each) {
    // Only one level of groups: the name of a class or an object may contain slashes.
    const std::string name = each->first.substr(group.size());
    const std::size_t slash = name.find('/');
    Value& entry = parameters[name.substr(0, slash)];
    if (slash == std::string::npos) {
      entry = each->second;
      continue;
    }
    if (!entry.is<Value::Map>()) entry = Value::Map{};
    (*entry.as<Value::Map>())[name.substr(slash + 1)] = each->second;
  }
  return parameters;
}

}  // namespace synthetic_dataset::output
