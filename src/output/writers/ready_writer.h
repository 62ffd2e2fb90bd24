#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/output_options.h"
#include "output/store_types.h"
#include "output/writers/writer_loader.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// A writer that is loaded and has read its parameters.
class ReadyWriter {
 public:
  /// The result of writing a scene.
  struct SceneResult {
    SceneFiles files;
    std::vector<std::string> warnings;  ///< "writer 'stvnet': alpha: a keypoint is behind ..."
  };

  /// @param loader  outlives this
  /// @throws Error naming the writer: its type is unknown, it cannot be loaded, or it fails to
  ///     initialise
  ReadyWriter(WriterLoader& loader, const WriterOptions& choice, const DatasetInfo& dataset);

  [[nodiscard]] const std::string& type() const { return type_; }
  [[nodiscard]] const WriterParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Requirements& requirements() const { return requirements_; }

  /// Adds the files, records and warnings for a scene.
  /// @param index  of the writer among those of the run
  /// @throws Error naming the writer
  void writeScene(const Scene& scene, std::size_t index, SceneResult& result) const;

  /// @throws Error naming the writer
  void finalize(const SceneRecords& records, DatasetOutput& output) const;

 private:
  std::string type_;
  WriterParameters parameters_;
  WriterLoader::Instance instance_;
  Requirements requirements_;
};

}  // namespace synthetic_dataset::output
