#include "run/check/check_sink.h"

#include <chrono>
#include <utility>

#include "output/scene_contents.h"

namespace synthetic_dataset::run {

CheckSink::CheckSink(const RunSetup& setup, std::set<std::int64_t> instants)
    : setup_(setup), instants_(std::move(instants)), statistics_(setup.config.labels) {}

Requirements CheckSink::requirements() const {
  Requirements all = setup_.writers->requirements();
  all.silhouettes = all.visible_masks = all.visibility = true;
  return all;
}

bool CheckSink::wants(std::int64_t scene) const {
  return instants_.count(scene / static_cast<std::int64_t>(setup_.config.cameras.size())) != 0;
}

std::vector<base::Warning> CheckSink::add(const FinishedScene& finished) {
  const auto begin = std::chrono::steady_clock::now();
  const output::WriterHost::SceneResult written = setup_.writers->writeScene(finished.scene);
  const output::StoreOptions& options = setup_.config.output;
  for (const output::SceneContent& content :
       output::encodeScene(written.files.files, {options.png_compression, options.jpeg_quality})) {
    // Files with the same pixels are links to one.
    bytes_ += static_cast<std::int64_t>(content.bytes().size());
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  writing_times_.push_back(time.count());
  scenes_.push_back(finished);
  statistics_.add(finished.scene);
  std::vector<base::Warning> warnings;
  for (const std::string& warning : written.warnings) warnings.push_back({warning});
  return warnings;
}

}  // namespace synthetic_dataset::run
