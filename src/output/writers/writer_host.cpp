#include "output/writers/writer_host.h"

#include <set>
#include <string>
#include <utility>

#include "output/files/file_name_rules.h"
#include "output/writers/writer_loader.h"
#include "output/writers/writer_outputs.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

constexpr bool Requirements::*kFlags[] = {
    &Requirements::silhouettes,     &Requirements::visible_masks, &Requirements::visibility,
    &Requirements::keypoint_states, &Requirements::class_map,     &Requirements::world_map,
    &Requirements::part_map,        &Requirements::depth,         &Requirements::normals,
    &Requirements::optical_flow,    &Requirements::clouds};

Requirements merged(const std::vector<ReadyWriter>& writers) {
  Requirements all;
  std::set<std::string> frames;
  for (const ReadyWriter& writer : writers) {
    const Requirements& own = writer.requirements();
    for (const auto flag : kFlags) all.*flag = all.*flag || own.*flag;
    frames.insert(own.frames.begin(), own.frames.end());
  }
  all.frames.assign(frames.begin(), frames.end());
  return all;
}

}  // namespace

struct WriterHost::Impl {
  explicit Impl(const std::vector<std::string>& plugin_xml_files) : loader(plugin_xml_files) {}

  WriterLoader loader;  // must outlive the writers that it made
  std::vector<ReadyWriter> writers;
  Requirements requirements;
};

WriterHost::WriterHost(const std::vector<WriterOptions>& choices, const DatasetInfo& dataset,
                       const std::vector<std::string>& plugin_xml_files)
    : impl_(std::make_unique<Impl>(plugin_xml_files)) {
  std::vector<std::string> errors;
  for (const WriterOptions& choice : choices) {
    try {
      impl_->writers.emplace_back(impl_->loader, choice, dataset);
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

std::vector<std::string> WriterHost::warnings() const {
  std::vector<std::string> all;
  for (const ReadyWriter& ready : impl_->writers) {
    for (const std::string& warning : ready.parameters().warnings()) {
      all.push_back("writer '" + ready.parameters().writerName() + "': " + warning);
    }
  }
  return all;
}

std::vector<output::StoreWriter> WriterHost::storeWriters() const {
  std::vector<output::StoreWriter> writers;
  for (const ReadyWriter& ready : impl_->writers) {
    output::StoreWriter writer;
    writer.name = ready.parameters().writerName();
    writer.type = ready.type();
    writer.output_folder = ready.parameters().outputFolder();
    for (const std::string& path : ready.parameters().files()) {
      writer.user_files.push_back(output::absolutePath(path));
    }
    writers.push_back(std::move(writer));
  }
  return writers;
}

WriterHost::SceneResult WriterHost::writeScene(const Scene& scene) const {
  SceneResult result;
  for (std::size_t i = 0; i < impl_->writers.size(); ++i) {
    try {
      impl_->writers[i].writeScene(scene, i, result);
    } catch (const Error& error) {
      throw Error("scene " + scene.name + ": " + error.what());
    }
  }
  return result;
}

void WriterHost::finalize(output::DatasetStore& store) const {
  for (std::size_t i = 0; i < impl_->writers.size(); ++i) {
    const ReadyWriter& writer = impl_->writers[i];
    StoringDatasetOutput output(i, writer.parameters(), store);
    writer.finalize(*store.records(i), output);
  }
}

}  // namespace synthetic_dataset::output
