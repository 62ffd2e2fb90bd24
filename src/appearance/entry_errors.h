#pragma once

#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::appearance {

/// Does something for an entry of the settings; errors that it throws name the entry then:
/// "<entry>: <error>".
template <class Work>
auto forEntry(const std::string& entry, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const ErrorList& list) {
    std::vector<std::string> messages;
    for (const std::string& each : list.messages()) messages.push_back(entry + ": " + each);
    throw ErrorList(std::move(messages));
  } catch (const Error& error) {
    throw Error(entry + ": " + error.what());
  }
}

}  // namespace synthetic_dataset::appearance
