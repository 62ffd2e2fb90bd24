#include "run/redraw.h"

#include <cstdint>
#include <set>

#include "output/verify/scene_verifier.h"
#include "output/written_dataset.h"
#include "run/reporter.h"
#include "run/scene_loop.h"
#include "run/setup/run_record.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

/// Checks the inputs: other inputs would make other scenes, and comparing those would be
/// meaningless.
void requireInputs(const output::RunDescription& run) {
  const std::string cure = "; restore the file that the dataset was made from";
  std::vector<std::string> problems;
  for (const auto& [path, input] : run.inputs) {
    try {
      if (describeInput(path).digest == input.digest) continue;
      problems.push_back("the input '" + path + "' has changed" + cure);
    } catch (const Error& error) {
      problems.push_back(error.what() + cure);
    }
  }
  if (!problems.empty()) throw ErrorList(problems);
}

class RedrawnScenes : public SceneSink {
 public:
  RedrawnScenes(const RunSetup& setup, const output::WrittenDataset& dataset,
                output::SceneVerifier& verifier, output::VerificationListener& listener)
      : setup_(setup), dataset_(dataset), verifier_(verifier), listener_(listener) {
    for (const std::int64_t scene : dataset.scenes()) scenes_.insert(scene);
  }

  [[nodiscard]] Requirements requirements() const override {
    return setup_.writers->requirements();
  }

  /// By now the OpenGL version is known.
  void begin(const DatasetInfo& /*dataset*/) override {
    const output::RunDescription& recorded = dataset_.content().run;
    output::RunDescription current = setup_.description;
    current.software = recorded.software;
    const std::vector<std::string> others = output::differences(recorded, current, "then", "now");
    if (!others.empty()) throw ErrorList(others);
    for (const std::string& each :
         output::differences(recorded, setup_.description, "then", "now")) {
      listener_.remark("'" + dataset_.manifest() + "': " + each +
                       "; individual pixels of a new drawing may differ");
    }
  }

  [[nodiscard]] bool wants(std::int64_t scene) const override { return scenes_.count(scene) != 0; }

  [[nodiscard]] std::vector<base::Warning> add(const FinishedScene& finished) override {
    const output::StoreOptions& options = setup_.config.output;
    if (finished.is_left_out) {
      listener_.problem("drawn again, scene " + std::to_string(finished.facts.index) +
                        ": its labels do not fit its recorded picture; it should not be there");
    } else {
      verifier_.verifyDrawn({finished.scene,
                             finished.facts,
                             {finished.scene.image, finished.image_file},
                             {options.png_compression, options.jpeg_quality}});
    }
    listener_.progress(++done_, static_cast<std::int64_t>(scenes_.size()));
    return {};
  }

  void finish(RunEnd /*end*/) override {}

 private:
  const RunSetup& setup_;
  const output::WrittenDataset& dataset_;
  output::SceneVerifier& verifier_;
  output::VerificationListener& listener_;
  std::set<std::int64_t> scenes_;
  std::int64_t done_ = 0;
};

}  // namespace

void redraw(const output::WrittenDataset& dataset, output::SceneVerifier& verifier,
            output::VerificationListener& listener,
            const std::vector<std::string>& plugin_xml_files) {
  const output::ManifestContent& content = dataset.content();
  if (!content.is_current) {
    throw Error("it is from release 0.1.0, whose scenes other releases draw differently");
  }
  requireInputs(content.run);
  RunSetup setup =
      setUpRun(recordedSettings(content, dataset.folder(), dataset.folder()), plugin_xml_files);
  RedrawnScenes scenes(setup, dataset, verifier, listener);
  Reporter silent;
  SceneLoop(setup, scenes, silent).run();
}

}  // namespace synthetic_dataset::run
