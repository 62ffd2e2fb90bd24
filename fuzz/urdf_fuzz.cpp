// Robots of URDF, as a parameter holds them.
#include "fuzzing.h"
#include "world/world_loader.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  const auto noPackages = [](const std::string&) -> std::optional<std::string> { return {}; };
  const world::ResourceFinder finder({}, noPackages);
  fuzzing::tolerating([&] {
    const std::string text = "<robot " + std::string(fuzzing::view(data, size));
    static_cast<void>(world::WorldLoader(finder).loadModel(text, "robot"));
  });
  return 0;
}
