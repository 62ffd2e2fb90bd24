#pragma once

#include <string>
#include <vector>

#include <console_bridge/console.h>

namespace synthetic_dataset::world {

/// Keeps urdfdom from printing while it lives, and remembers its errors: it gives its reasons to
/// the console alone.
class UrdfConsole : private console_bridge::OutputHandler {
 public:
  UrdfConsole();
  ~UrdfConsole() override;
  UrdfConsole(const UrdfConsole&) = delete;
  UrdfConsole& operator=(const UrdfConsole&) = delete;

  [[nodiscard]] const std::vector<std::string>& errors() const { return errors_; }

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char* file,
           int line) override;

  std::vector<std::string> errors_;
  console_bridge::OutputHandler* handler_;
};

}  // namespace synthetic_dataset::world
