#include "output/writers/exit_guard.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace synthetic_dataset::output {
namespace {

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

}  // namespace

WriterAtWork::WriterAtWork(const std::string& name) {
  watchExits();
  writer_at_work = &name;
}

WriterAtWork::~WriterAtWork() { writer_at_work = nullptr; }

}  // namespace synthetic_dataset::output
