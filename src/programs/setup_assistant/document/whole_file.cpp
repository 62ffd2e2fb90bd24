#include "programs/setup_assistant/document/whole_file.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "output/files/pending_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

void writeWhole(const std::string& file, const std::string& content) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path target = fs::exists(file, none) ? fs::canonical(file) : fs::absolute(file);
  const auto write = [&](const std::string& pending_name) {
    std::ofstream stream(pending_name, std::ios::binary);
    if (fs::exists(target)) {
      fs::permissions(pending_name, fs::status(target).permissions(), none);
    }
    if (!(stream << content << std::flush)) throw Error("'" + file + "' cannot be written");
  };
  auto pending = output::PendingFile::writtenBy(target.string(), write);
  pending.publish();
  pending.keep();
}

}  // namespace synthetic_dataset::programs
