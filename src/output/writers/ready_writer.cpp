#include "output/writers/ready_writer.h"

#include "output/writers/exit_guard.h"
#include "output/writers/writer_outputs.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {

ReadyWriter::ReadyWriter(WriterLoader& loader, const WriterOptions& choice,
                         const DatasetInfo& dataset)
    : type_(choice.type), parameters_(choice.parameters, choice.name, choice.output_folder) {
  try {
    instance_ = loader.create(choice.type);
  } catch (const Error& error) {
    throw Error("writer '" + choice.name + "': " + error.what());
  }
  const WriterAtWork at_work(choice.name);
  // These name the writer themselves when they fail.
  instance_->initialize(parameters_, dataset);
  requirements_ = instance_->requirements();
}

void ReadyWriter::writeScene(const Scene& scene, std::size_t index, SceneResult& result) const {
  GatheringSceneOutput output(index, parameters_, result.files, result.warnings);
  const WriterAtWork at_work(parameters_.writerName());
  instance_->writeScene(scene, output);
}

void ReadyWriter::finalize(const SceneRecords& records, DatasetOutput& output) const {
  const WriterAtWork at_work(parameters_.writerName());
  instance_->finalize(records, output);
}

}  // namespace synthetic_dataset::output
