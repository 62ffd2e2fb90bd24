#include "output/writers/writer_host.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>

#include "output/files/file_name_rules.h"
#include "output/writers/writer_loader.h"
#include "output/writers/writer_outputs.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// While it lives, a writer is at work. A plugin that ends the program meanwhile, by `exit`, is
/// named on the standard error, and the exit code is 1: a run that has not come to its end must not
/// look like one that has.
class WriterAtWork {
 public:
  /// @param name  of the writer; it outlives this
  explicit WriterAtWork(const std::string& name);
  ~WriterAtWork();
  WriterAtWork(const WriterAtWork&) = delete;
  WriterAtWork& operator=(const WriterAtWork&) = delete;
};

/// Whoever calls `exit` leaves nothing else that knows.
std::atomic<const std::string*> writer_at_work{nullptr};

void refuseExit() {
  const std::string* writer = writer_at_work.load();
  if (writer == nullptr) return;  // the program comes to its own end
  std::fprintf(stderr,
               "writer '%s': its plugin has ended the program by a call of exit(); the dataset is "
               "unfinished, and the same command goes on with it\n",
               writer->c_str());
  std::fflush(nullptr);
  _exit(EXIT_FAILURE);
}

void watchExits() {
  static const bool is_watching = [] {
    return std::atexit(refuseExit) == 0 && std::at_quick_exit(refuseExit) == 0;
  }();
  (void)is_watching;
}

WriterAtWork::WriterAtWork(const std::string& name) {
  watchExits();
  writer_at_work = &name;
}

WriterAtWork::~WriterAtWork() { writer_at_work = nullptr; }

struct ReadyWriter {
  std::string type;
  WriterParameters parameters;
  WriterLoader::Instance instance;
  Requirements requirements;
};

ReadyWriter makeReady(WriterLoader& loader, const WriterOptions& choice,
                      const DatasetInfo& dataset) {
  WriterLoader::Instance instance;
  try {
    instance = loader.create(choice.type);
  } catch (const Error& error) {
    throw Error("writer '" + choice.name + "': " + error.what());
  }
  WriterParameters parameters(choice.parameters, choice.name, choice.output_folder);
  const WriterAtWork at_work(choice.name);
  // These name the writer themselves when they fail.
  instance->initialize(parameters, dataset);
  Requirements requirements = instance->requirements();
  return {choice.type, std::move(parameters), std::move(instance), std::move(requirements)};
}

constexpr bool Requirements::*kFlags[] = {
    &Requirements::silhouettes,     &Requirements::visible_masks, &Requirements::visibility,
    &Requirements::keypoint_states, &Requirements::class_map,     &Requirements::world_map,
    &Requirements::part_map,        &Requirements::depth,         &Requirements::normals,
    &Requirements::optical_flow};

Requirements merged(const std::vector<ReadyWriter>& writers) {
  Requirements all;
  std::set<std::string> frames;
  for (const ReadyWriter& writer : writers) {
    const Requirements& own = writer.requirements;
    for (const auto flag : kFlags) all.*flag = all.*flag || own.*flag;
    frames.insert(own.frames.begin(), own.frames.end());
  }
  all.frames.assign(frames.begin(), frames.end());
  return all;
}

}  // namespace

struct WriterHost::Impl {
  explicit Impl(const std::vector<std::string>& plugin_xml_files) : loader(plugin_xml_files) {}

  WriterLoader loader;  // outlives the writers that it made
  std::vector<ReadyWriter> writers;
  Requirements requirements;
};

WriterHost::WriterHost(const std::vector<WriterOptions>& choices, const DatasetInfo& dataset,
                       const std::vector<std::string>& plugin_xml_files)
    : impl_(std::make_unique<Impl>(plugin_xml_files)) {
  std::vector<std::string> errors;
  for (const WriterOptions& choice : choices) {
    try {
      impl_->writers.push_back(makeReady(impl_->loader, choice, dataset));
    } catch (const Error& error) {
      errors.emplace_back(error.what());
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
  impl_->requirements = merged(impl_->writers);
}

WriterHost::~WriterHost() = default;

const Requirements& WriterHost::requirements() const { return impl_->requirements; }

std::vector<std::string> WriterHost::typeNames() const { return impl_->loader.typeNames(); }

std::vector<output::StoreWriter> WriterHost::storeWriters() const {
  std::vector<output::StoreWriter> writers;
  for (const ReadyWriter& ready : impl_->writers) {
    output::StoreWriter writer;
    writer.name = ready.parameters.writerName();
    writer.type = ready.type;
    writer.output_folder = ready.parameters.outputFolder();
    for (const std::string& path : ready.parameters.files()) {
      writer.user_files.push_back(output::absolutePath(path));
    }
    writers.push_back(std::move(writer));
  }
  return writers;
}

WriterHost::SceneResult WriterHost::writeScene(const Scene& scene) const {
  SceneResult result;
  for (std::size_t i = 0; i < impl_->writers.size(); ++i) {
    const ReadyWriter& writer = impl_->writers[i];
    GatheringSceneOutput output(i, writer.parameters, result.files, result.warnings);
    try {
      const WriterAtWork at_work(writer.parameters.writerName());
      writer.instance->writeScene(scene, output);
    } catch (const Error& error) {
      throw Error("scene " + scene.name + ": " + error.what());
    }
  }
  return result;
}

void WriterHost::finalize(output::DatasetStore& store) const {
  for (std::size_t i = 0; i < impl_->writers.size(); ++i) {
    const ReadyWriter& writer = impl_->writers[i];
    StoringDatasetOutput output(i, writer.parameters, store);
    const WriterAtWork at_work(writer.parameters.writerName());
    writer.instance->finalize(*store.records(i), output);
  }
}

}  // namespace synthetic_dataset::output
