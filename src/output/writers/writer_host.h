#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/output_options.h"
#include "output/writers/ready_writer.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// Loads the chosen writers from their plugin libraries, runs them and checks what they did.
class WriterHost {
 public:
  /// The result of writing a scene in every format.
  using SceneResult = ReadyWriter::SceneResult;

  /// Loads, initialises and checks every writer; errors about parameters are recorded in the
  /// parameters themselves.
  /// @param plugin_xml_files  where to look for writers; empty for all that installed packages
  ///     export
  /// @throws ErrorList for unknown types (listing the available ones, and why a declared one cannot
  ///     be loaded) and writers that fail to initialise
  WriterHost(const std::vector<WriterOptions>& choices, const DatasetInfo& dataset,
             const std::vector<std::string>& plugin_xml_files = {});
  ~WriterHost();
  WriterHost(const WriterHost&) = delete;
  WriterHost& operator=(const WriterHost&) = delete;

  /// What all writers together require; each frame once, in alphabetical order.
  [[nodiscard]] const Requirements& requirements() const;

  /// The names of all available writer types.
  [[nodiscard]] std::vector<std::string> typeNames() const;

  /// Warnings that writers give before the first scene, with the writers' names.
  [[nodiscard]] std::vector<std::string> warnings() const;

  /// The writers in the form that the store needs, in the order of the choices.
  [[nodiscard]] std::vector<output::StoreWriter> storeWriters() const;

  /// Lets every writer turn the scene into files.
  /// @throws Error naming the writer that failed
  [[nodiscard]] SceneResult writeScene(const Scene& scene) const;

  /// Lets every writer finish its dataset.
  /// @throws Error naming the writer that failed
  void finalize(output::DatasetStore& store) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::output
