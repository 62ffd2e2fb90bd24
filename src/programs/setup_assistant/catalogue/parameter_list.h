#pragma once

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// All settings of config/params.yaml for the page: path, default or example, description, whether
/// it is required, and, where its description names them, its choices and its unit.
[[nodiscard]] Value parameterList();

}  // namespace synthetic_dataset::programs
