/// The tool `verify`: checks datasets against their manifests, file by file and label by label.
///
///   rosrun synthetic_dataset verify [--quick | --redraw] DATASET...
///
/// DATASET is the folder of a run's manifest, or of those of its shards. Prints a line on the
/// standard output for each problem; exit code 0 without any, 1 with some, 2 for a wrong usage.
/// With --quick, it only checks the manifest itself, and that the files exist and have their sizes;
/// with --redraw, it also checks that the inputs give the same scenes again.

#include <unistd.h>

#include <chrono>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "base/printable_text.h"
#include "output/verify/dataset_verifier.h"
#include "programs/console/heap.h"
#include "run/redraw.h"

namespace {

using namespace synthetic_dataset;

/// Prints lines on the standard output, and the progress if there is a terminal.
class Console : public output::VerificationListener {
 public:
  void problem(const std::string& line) override {
    ++problems_;
    say(line);
  }

  void remark(const std::string& line) override { say("note: " + line); }

  void progress(std::int64_t scene_count, std::int64_t of) override {
    constexpr std::chrono::milliseconds kPeriod(200);
    const auto now = std::chrono::steady_clock::now();
    if (!is_terminal_ || now - last_shown_ < kPeriod) return;
    last_shown_ = now;
    std::cerr << "\rscene " << scene_count << " of " << of << kEraseRest << std::flush;
    is_shown_ = true;
  }

  void clearProgress() {
    if (is_shown_) std::cerr << '\r' << kEraseRest << std::flush;
    is_shown_ = false;
  }

  [[nodiscard]] std::int64_t problems() const { return problems_; }

 private:
  void say(const std::string& line) {
    clearProgress();
    std::cout << base::printable(line) << std::endl;
  }

  static constexpr const char* kEraseRest = "\033[K";  // to the line's end: ECMA-48, EL

  bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point last_shown_{};
  std::int64_t problems_ = 0;
};

constexpr const char* kUsage =
    R"(usage: verify [--quick | --redraw] DATASET...

Checks datasets against their manifests, file by file and label by label. DATASET is the
folder of a run's manifest, or of those of its shards. Prints a line for each problem;
lines that begin with `note:` are not problems.

  --quick   checks that all files exist with the right size, but no labels
  --redraw  also draws all scenes again and compares them with the files; needs all inputs
            where they were, such as bags and worlds, and takes as long as the run did
  --help    prints this

  verify /data/run_7

Exit codes: 0 no problem, 1 some, 2 wrong usage.
)";

int wrongUsage() {
  std::cerr << kUsage;
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  programs::heap::prepare();
  output::VerificationDepth depth = output::VerificationDepth::kLabels;
  Console console;
  output::DrawAgain draw_again;
  std::vector<std::string> folders;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--help" || argument == "-h") {
      std::cout << kUsage;
      return 0;
    }
    if (argument == "--quick") {
      depth = output::VerificationDepth::kSizes;
    } else if (argument == "--redraw") {
      draw_again = [&console](const auto& dataset, auto& verifier) {
        run::redraw(dataset, verifier, console);
      };
    } else if (argument.empty() || argument.front() == '-') {
      return wrongUsage();
    } else {
      folders.push_back(argument);
    }
  }
  const bool is_quick = depth == output::VerificationDepth::kSizes;
  if (folders.empty() || (is_quick && draw_again)) return wrongUsage();
  output::VerificationCounts counts;
  for (const std::string& folder : folders) {
    try {
      const output::VerificationCounts of_one =
          output::verifyDataset(folder, depth, console, draw_again);
      counts.scenes += of_one.scenes;
      counts.files += of_one.files;
      counts.labels += of_one.labels;
      counts.drawn += of_one.drawn;
    } catch (const std::exception& error) {
      console.problem("'" + folder + "': " + error.what());
    }
  }
  console.clearProgress();
  std::cout << counts.scenes << " scenes, " << counts.files << " files, " << counts.labels
            << " labels checked, "
            << (draw_again ? std::to_string(counts.drawn) + " scenes drawn again, " : "")
            << console.problems() << " problems\n";
  return console.problems() == 0 ? 0 : 1;
}
