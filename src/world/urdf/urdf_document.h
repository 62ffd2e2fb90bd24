#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include "world/files/findings.h"
#include "world/urdf/urdf_text.h"

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

/// A robot as urdfdom reads it, which prints nothing meanwhile.
struct UrdfDocument {
  urdf::ModelInterfaceSharedPtr robot;                  ///< a tree of links; null where it is none
  std::map<std::string, std::string> gazebo_materials;  ///< by link
};

/// What is wrong becomes an error: what urdfdom says, and what it does not see (loops, links with
/// two parents).
[[nodiscard]] UrdfDocument readUrdf(const ModelText& model, Findings& findings);

}  // namespace synthetic_dataset::world
