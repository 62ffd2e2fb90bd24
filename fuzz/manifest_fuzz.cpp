// Manifests: SQLite files left by an earlier run, or by somebody else.
#include "fuzzing.h"
#include "output/manifest/manifest.h"
#include "output/manifest/manifest_content.h"
#include "output/written_dataset.h"

namespace {

using namespace synthetic_dataset;

void readAsADataset(const std::string& folder) {
  const output::WrittenDataset dataset(folder);
  const std::int64_t scene = dataset.middleScene();
  static_cast<void>(dataset.scene(scene));
  for (const output::WrittenWriter& writer : dataset.writers()) {
    static_cast<void>(dataset.files(writer, scene));
  }
}

void readToGoOn(const std::string& folder) {
  const auto manifest = output::Manifest::open(folder, std::nullopt, output::Sync::kOff);
  static_cast<void>(manifest.sceneStates());
  static_cast<void>(manifest.filesOfScene(0));
  static_cast<void>(manifest.counts());
  static_cast<void>(manifest.warningCounts());
  static_cast<void>(manifest.objectCounts());
  manifest.forEachRecord(0, "a", [](std::int64_t, const std::string&) {});
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string folder = fuzzing::folder().string();
  const auto write = [&] {  // again each time, as opening it may change it
    std::filesystem::remove(fuzzing::folder() / "manifest.sqlite-journal");
    return fuzzing::write("manifest.sqlite", fuzzing::view(data, size)).string();
  };
  fuzzing::tolerating([&] { static_cast<void>(output::readManifest(write())); });
  fuzzing::tolerating([&] {
    write();
    readAsADataset(folder);
  });
  fuzzing::tolerating([&] {
    write();
    readToGoOn(folder);
  });
  return 0;
}
