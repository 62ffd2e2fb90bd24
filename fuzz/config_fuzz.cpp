// Settings: YAML, and everything that is read from it before the run.
#include "base/yaml_value.h"
#include "config/config.h"
#include "config/motion_list.h"
#include "fuzzing.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  fuzzing::tolerating([&] {
    const Value settings = base::parseYaml(std::string(fuzzing::view(data, size)), "settings");
    for (const config::MotionEntry& motion : config::readMotions(settings).entries) {
      Parameters root(motion.settings);
      static_cast<void>(config::readConfig(root));
      static_cast<void>(config::unknownParameterErrors(root, root.unknownNames()));
    }
  });
  return 0;
}
