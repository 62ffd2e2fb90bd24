#pragma once

#include <string>

namespace synthetic_dataset::output {

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

}  // namespace synthetic_dataset::output
