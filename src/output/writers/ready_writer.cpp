#include "output/writers/ready_writer.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "output/writers/writer_outputs.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// Global, since an exit handler has no other way to find out.
std::atomic<const std::string*> writer_at_work{nullptr};

/// Marks a writer as running. If a plugin ends the program meanwhile with `exit`, its writer is
/// named on standard error and the exit code is 1: an unfinished run must not look like a finished
/// one.
class WriterAtWork {
 public:
  /// @param name  of the writer; must outlive this
  explicit WriterAtWork(const std::string& name) { writer_at_work = &name; }
  ~WriterAtWork() { writer_at_work = nullptr; }
  WriterAtWork(const WriterAtWork&) = delete;
  WriterAtWork& operator=(const WriterAtWork&) = delete;
};

void refuseExit() {
  const std::string* writer = writer_at_work.load();
  if (writer == nullptr) return;  // the program ends normally
  std::fprintf(stderr,
               "writer '%s': its plugin has ended the program by calling exit(); the dataset is "
               "unfinished, and the same command continues it\n",
               writer->c_str());
  std::fflush(nullptr);
  _exit(EXIT_FAILURE);
}

/// Call after each writer library is loaded: exit handlers run in reverse order of registration,
/// and this one must run before those of the library.
void watchExits() {
  (void)std::atexit(refuseExit);
  (void)std::at_quick_exit(refuseExit);
}

}  // namespace

ReadyWriter::ReadyWriter(WriterLoader& loader, const WriterOptions& choice,
                         const DatasetInfo& dataset)
    : type_(choice.type), parameters_(choice.parameters, choice.name, choice.output_folder) {
  try {
    instance_ = loader.create(choice.type);
  } catch (const Error& error) {
    throw Error("writer '" + choice.name + "': " + error.what());
  }
  watchExits();
  const WriterAtWork at_work(choice.name);
  // These calls name the writer themselves if they fail.
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
