#include "world/urdf/urdf_console.h"

namespace synthetic_dataset::world {

UrdfConsole::UrdfConsole() : handler_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

UrdfConsole::~UrdfConsole() { console_bridge::useOutputHandler(handler_); }

void UrdfConsole::log(const std::string& text, console_bridge::LogLevel level, const char*, int) {
  if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) errors_.push_back(text);
}

}  // namespace synthetic_dataset::world
