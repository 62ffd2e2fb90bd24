#include "world/mesh/mesh_batch.h"

#include <algorithm>
#include <exception>
#include <future>
#include <thread>
#include <utility>
#include <variant>

#include "synthetic_dataset/errors.h"
#include "world/files/byte_stream.h"
#include "world/files/trial_process.h"
#include "world/mesh/mesh_file_bytes.h"

namespace synthetic_dataset::world {
namespace {

using Files = std::vector<std::filesystem::path>;

TrialLimits limitsFor(const Files& files) {
  TrialLimits limits;
  limits.processor_time = std::chrono::seconds(0);
  for (const auto& file : files) limits.processor_time += meshTrialLimits(file).processor_time;
  return limits;
}

/// What a share's process hands over: each file's path and content, without those that have faults.
std::string importAll(const Files& files) {
  ByteWriter writer;
  for (const auto& file : files) {
    try {
      const std::string content = toBytes(importMeshFile(file));
      writer.text(file.string());
      writer.text(content);
    } catch (const Error&) {
      continue;  // told when the file is read alone
    }
  }
  writer.text("");
  return writer.take();
}

/// What a share's process has read.
std::map<std::string, MeshFile> takeShare(TrialProcess& process) {
  std::map<std::string, MeshFile> result;
  try {
    const auto answer = process.finish();
    const auto* bytes = std::get_if<std::string>(&answer);
    if (bytes == nullptr) return result;
    ByteReader reader(*bytes);
    for (std::string path = reader.text(); !path.empty(); path = reader.text()) {
      result.emplace(path, meshFileOf(reader.text()));
    }
  } catch (const std::exception&) {
    result.clear();  // the files are read one by one then
  }
  return result;
}

}  // namespace

std::map<std::string, MeshFile> readMeshFiles(const Files& files) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<Files> shares(std::min(cores, files.size()));
  for (std::size_t i = 0; i < files.size(); ++i) shares[i % shares.size()].push_back(files[i]);
  std::vector<TrialProcess> processes;
  processes.reserve(shares.size());
  for (const Files& share : shares) {
    processes.emplace_back([&share] { return importAll(share); }, limitsFor(share));
  }
  std::vector<std::future<std::map<std::string, MeshFile>>> readings;
  readings.reserve(processes.size());
  for (TrialProcess& process : processes) {
    // One after another, where the system starts no more threads.
    readings.push_back(
        std::async(std::launch::async | std::launch::deferred, takeShare, std::ref(process)));
  }
  std::map<std::string, MeshFile> result;
  for (auto& reading : readings) result.merge(reading.get());
  return result;
}

}  // namespace synthetic_dataset::world
