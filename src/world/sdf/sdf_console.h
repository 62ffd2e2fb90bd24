#pragma once

#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

#include <console_bridge/console.h>

namespace synthetic_dataset::world {

/// Keeps libsdformat and the parser of URDF from printing while it lives, and remembers what they
/// would have said: both tell their reasons to the console alone, and libsdformat tells it all that
/// is wrong in a file included by an included one. It prints straight to std::cerr, which is turned
/// aside meanwhile; files are read before other threads work.
class SdfConsole : private console_bridge::OutputHandler {
 public:
  SdfConsole();
  ~SdfConsole() override;
  SdfConsole(const SdfConsole&) = delete;
  SdfConsole& operator=(const SdfConsole&) = delete;

  /// Faults that nothing else reports: "[<place>]: Msg: <reason>".
  [[nodiscard]] std::vector<std::string> unreported() const;

  /// Reasons for faults that are reported without one.
  [[nodiscard]] std::vector<std::string> reasons() const;

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char* file,
           int line) override;

  std::ostringstream text_;
  std::vector<std::string> urdf_errors_;
  std::streambuf* cerr_buffer_;
  console_bridge::OutputHandler* handler_;
};

}  // namespace synthetic_dataset::world
