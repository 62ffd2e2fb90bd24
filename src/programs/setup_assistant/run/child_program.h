#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// The file of one of this package's programs. @throws Error when it does not exist
[[nodiscard]] std::string programBesideThis(const std::string& name);

/// A program that runs as a child process and receives SIGINT when this process dies, for whatever
/// reason: `generate` then finishes its scene and can be resumed later.
///
/// The system ties this to the thread that started the program, which therefore has to live as long
/// as the program.
class ChildProgram {
 public:
  /// @param command  the program's file and its arguments
  /// @throws Error when it cannot be started
  explicit ChildProgram(const std::vector<std::string>& command);

  /// Kills the program if wait() was not called.
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Reads what the program prints on its standard output and error, until it closes both.
  /// @param take  receives each line
  void read(const std::function<void(const std::string& line)>& take) const;

  /// @return the exit code as in a shell: 128 + signal if a signal ended the program
  int wait();

  /// The process id, which is not reused until wait() is called.
  [[nodiscard]] pid_t id() const { return id_; }

 private:
  pid_t id_ = -1;
  int output_ = -1;
  bool is_waited_for_ = false;
};

}  // namespace synthetic_dataset::programs
