// Worlds and models of SDF, with files that include one another.
#include "fuzzing.h"
#include "world/world_loader.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  const std::vector<std::string> names = {"world.sdf", "a/model.config", "a/model.sdf",
                                          "b/model.sdf"};
  const std::vector<std::string> contents = fuzzing::pieces(fuzzing::view(data, size));
  for (std::size_t i = 0; i < names.size(); ++i) {
    fuzzing::write(names[i], i < contents.size() ? contents[i] : "");
  }
  const auto noPackages = [](const std::string&) -> std::optional<std::string> { return {}; };
  const world::ResourceFinder finder({fuzzing::folder().string()}, noPackages);
  // Each input is read one way, which is twice as many inputs.
  world::LoadOptions options;
  options.on_missing_asset =
      size % 2 == 0 ? world::OnMissingAsset::kError : world::OnMissingAsset::kWarn;
  fuzzing::tolerating([&] {
    const auto file = (fuzzing::folder() / "world.sdf").string();
    static_cast<void>(world::loadWorld(file, finder, options));
  });
  return 0;
}
