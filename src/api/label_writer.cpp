#include "synthetic_dataset/label_writer.h"

#include <algorithm>

#include <utility>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

/// Runs a writer's own code so that whatever it throws names the writer.
template <class Work>
auto named(const std::string& writer, Work work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::exception& error) {
    throw Error("writer '" + writer + "': " + error.what());
  } catch (...) {
    throw Error("writer '" + writer + "': threw something that is not a std::exception");
  }
}

}  // namespace

WriterParameters::WriterParameters(Parameters parameters, std::string writer_name,
                                   std::string output_folder)
    : Parameters(std::move(parameters)),
      writer_name_(std::move(writer_name)),
      output_folder_(std::move(output_folder)) {}

FileParameter WriterParameters::requiredFile(const std::string& name) {
  const std::size_t errors_before = errors().size();
  std::string file = required<std::string>(name);
  if (errors().size() != errors_before) return {};
  if (file.empty() || file.back() == '/') {
    addError(name, "found '" + file + "'; it should be the path of a file");
    return {};
  }
  if (std::any_of(file.begin(), file.end(),
                  [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; })) {
    addError(name, "found a path with a control character; it should be the path of a file");
    return {};
  }
  if (file.front() != '/') file = output_folder_ + file;
  files_.insert(file);
  return FileParameter(std::move(file));
}

LabelWriter::~LabelWriter() = default;

void LabelWriter::initialize(WriterParameters& parameters, const DatasetInfo& dataset) {
  if (initialized_) throw Error("writer '" + name_ + "': initialised twice");
  name_ = parameters.writerName();
  named(name_, [&] { doInitialize(parameters, dataset); });
  initialized_ = true;
}

Requirements LabelWriter::requirements() const {
  if (!initialized_) throw Error("a writer was asked for its requirements before initialize");
  return named(name_, [&] { return doRequirements(); });
}

void LabelWriter::writeScene(const Scene& scene, SceneOutput& output) const {
  if (!initialized_) throw Error("a writer was given a scene before initialize");
  named(name_, [&] { doWriteScene(scene, output); });
}

void LabelWriter::finalize(const SceneRecords& records, DatasetOutput& output) const {
  if (!initialized_) throw Error("a writer was finalised before initialize");
  named(name_, [&] { doFinalize(records, output); });
}

void LabelWriter::doInitialize(WriterParameters& /*parameters*/, const DatasetInfo& /*dataset*/) {}

Requirements LabelWriter::doRequirements() const { return {}; }

void LabelWriter::doFinalize(const SceneRecords& /*records*/, DatasetOutput& /*output*/) const {}

}  // namespace v2
}  // namespace synthetic_dataset
