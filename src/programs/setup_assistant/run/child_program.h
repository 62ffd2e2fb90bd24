#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// The file of one of this package's programs. @throws Error when it is not there
[[nodiscard]] std::string programBesideThis(const std::string& name);

/// A program that runs beside this one and is asked to stop when this one dies, however it does:
/// by SIGINT, after which `generate` finishes its scene and can go on another time.
///
/// The system watches the thread that made it, which therefore has to live as long as the program.
class ChildProgram {
 public:
  /// @param command  the program's file and its arguments
  /// @throws Error when it cannot be started
  explicit ChildProgram(const std::vector<std::string>& command);

  /// Stops the program at once where wait() was not called.
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Reads what it prints, both of its outputs, until it closes them.
  /// @param take  gets each line
  void read(const std::function<void(const std::string& line)>& take) const;

  /// @return its exit code, as a shell has it: 128 + signal where one ended it
  int wait();

  /// Its own until wait() is called.
  [[nodiscard]] pid_t id() const { return id_; }

 private:
  pid_t id_ = -1;
  int output_ = -1;
  bool is_waited_for_ = false;
};

}  // namespace synthetic_dataset::programs
