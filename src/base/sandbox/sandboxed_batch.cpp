#include "base/sandbox/sandboxed_batch.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <future>
#include <thread>
#include <variant>

#include "base/sandbox/byte_stream.h"
#include "base/sandbox/sandboxed_process.h"

namespace synthetic_dataset::base {
namespace {

using Results = std::vector<std::optional<std::string>>;

/// Every n-th piece from a first one on, as large pieces are often next to each other.
struct Share {
  const std::vector<SandboxedWork>& pieces;
  std::size_t first;
  std::size_t step;

  [[nodiscard]] SandboxLimits limits(std::uint64_t memory) const {
    SandboxLimits limits;
    limits.memory = memory;
    limits.processor_time = std::chrono::seconds(0);
    for (std::size_t i = first; i < pieces.size(); i += step) {
      limits.processor_time += pieces[i].processor_time;
    }
    return limits;
  }

  /// Runs in the process: for each piece, whether it has a result, and the result.
  [[nodiscard]] std::string work() const {
    ByteWriter writer;
    for (std::size_t i = first; i < pieces.size(); i += step) {
      std::optional<std::string> result;
      try {
        limitSandboxTime(pieces[i].processor_time);
        result = pieces[i].work();
      } catch (const std::exception&) {  // also when it runs out of memory
        result.reset();
      }
      writer.number(result.has_value());
      if (result) writer.text(*result);
    }
    return writer.take();
  }

  /// Stores the results of the process. Each share has its own places in `results`, so that several
  /// threads may do so at a time.
  void take(SandboxedProcess& process, Results& results) const {
    try {
      const auto answer = process.finish();
      const auto* bytes = std::get_if<std::string>(&answer);
      if (bytes == nullptr) return;
      ByteReader reader(*bytes);
      for (std::size_t i = first; i < pieces.size(); i += step) {
        if (reader.number<bool>()) results[i] = reader.text();
      }
    } catch (const std::exception&) {
      for (std::size_t i = first; i < pieces.size(); i += step) results[i].reset();
    }
  }
};

}  // namespace

Results runAllSandboxed(const std::vector<SandboxedWork>& pieces, std::uint64_t memory) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t count = std::min(cores, pieces.size());
  std::vector<Share> shares;
  for (std::size_t i = 0; i < count; ++i) shares.push_back({pieces, i, count});
  std::vector<SandboxedProcess> processes;
  processes.reserve(count);
  for (const Share& share : shares) {
    processes.emplace_back([&share] { return share.work(); }, share.limits(memory));
  }
  Results results(pieces.size());
  std::vector<std::future<void>> takings;
  for (std::size_t i = 0; i < count; ++i) {
    // Deferred, and so one after another, if the system cannot start more threads.
    takings.push_back(std::async(std::launch::async | std::launch::deferred,
                                 [&, i] { shares[i].take(processes[i], results); }));
  }
  for (auto& taking : takings) taking.get();
  return results;
}

}  // namespace synthetic_dataset::base
