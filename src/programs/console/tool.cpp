#include "programs/console/tool.h"

#include <exception>
#include <iostream>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

int reportingErrors(const std::string& name, const std::function<int()>& work) {
  try {
    return work();
  } catch (const ErrorList& errors) {
    for (const std::string& message : errors.messages())
      std::cerr << name << ": " << message << '\n';
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
  }
  return 1;
}

}  // namespace synthetic_dataset::programs
