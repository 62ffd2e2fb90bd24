#include "synthetic_dataset/required.h"

#include <string>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
inline namespace v2 {

void throwNotRequired(const char* name, const char* requirement) {
  throw Error(std::string(name) + " was not computed: no writer has Requirements::" + requirement);
}

}  // namespace v2
}  // namespace synthetic_dataset
