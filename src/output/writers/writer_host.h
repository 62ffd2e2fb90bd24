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
  /// What a scene becomes in every format.
  using SceneResult = ReadyWriter::SceneResult;

  /// Loads, initialises and checks every writer; errors about parameters are noted in the
  /// parameters themselves.
  /// @param plugin_xml_files  where to look for writers; empty: all that installed packages export
  /// @throws ErrorList: an unknown type (with the types that there are, and why a declared one
  ///     cannot be loaded), a writer that fails to initialise
  WriterHost(const std::vector<WriterOptions>& choices, const DatasetInfo& dataset,
             const std::vector<std::string>& plugin_xml_files = {});
  ~WriterHost();
  WriterHost(const WriterHost&) = delete;
  WriterHost& operator=(const WriterHost&) = delete;

  /// What all writers together need; each frame once, in alphabetical order.
  [[nodiscard]] const Requirements& requirements() const;

  /// The names of all types of writers that there are.
  [[nodiscard]] std::vector<std::string> typeNames() const;

  /// What writers warn of before the first scene, with their names.
  [[nodiscard]] std::vector<std::string> warnings() const;

  /// The writers as the store wants them, in the order of the choices.
  [[nodiscard]] std::vector<output::StoreWriter> storeWriters() const;

  /// Has every writer turn the scene into files.
  /// @throws Error naming the writer that failed
  [[nodiscard]] SceneResult writeScene(const Scene& scene) const;

  /// Has every writer finish its dataset.
  /// @throws Error naming the writer that failed
  void finalize(output::DatasetStore& store) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::output
