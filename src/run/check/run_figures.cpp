#include "run/check/run_figures.h"

#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

namespace fs = std::filesystem;

/// The limit in a control group's file; nothing if it says "max" or does not exist.
std::optional<std::int64_t> limitIn(const fs::path& file) {
  std::ifstream stream(file);
  std::int64_t bytes = 0;
  if (!(stream >> bytes) || bytes <= 0) return std::nullopt;
  return bytes;
}

/// The path of this process's control group (version 2).
std::string controlGroup() {
  std::ifstream stream("/proc/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("0::/", 0) == 0) return line.substr(4);
  }
  return "";
}

std::string bytesText(std::int64_t bytes) {
  const auto number = static_cast<double>(bytes);
  if (number < 1e6) return fixed(number / 1e3, 0) + " kB";
  return number < 1e9 ? fixed(number / 1e6, 0) + " MB" : fixed(number / 1e9, 1) + " GB";
}

std::string timeText(double seconds) {
  if (seconds < 90.0) return fixed(std::max(seconds, 1.0), 0) + " s";
  if (seconds < 5400.0) return fixed(seconds / 60.0, 0) + " min";
  return fixed(seconds / 3600.0, 1) + " h";
}

std::string windowOf(const MotionSetup& motion, bool is_only) {
  const auto& stamps = motion.timeline.stamps;
  const std::string name = is_only ? "times: " : "motion '" + motion.entry.name + "': ";
  const std::string count = std::to_string(stamps.size()) + (is_only ? "" : " times");
  if (!motion.timeline.is_recorded) return name + count + ", placed";
  return name + count + " from " + fixed(toSeconds(stamps.front()), 3) + " s to " +
         fixed(toSeconds(stamps.back()), 3) + " s of the recording (" +
         fixed(toSeconds(stamps.back() - stamps.front()), 1) + " s), " +
         fixed(motion.config.motion.rate, 2) + " a second";
}

std::string sizeOf(const scene::CameraRig& camera) {
  return camera.name + " (" + std::to_string(camera.model.width()) + " x " +
         std::to_string(camera.model.height()) + ")";
}

std::string scenesLine(const RunSetup& setup) {
  std::string cameras;
  for (const scene::CameraRig& camera : setup.motions.front().cameras) {
    cameras += (cameras.empty() ? "" : ", ") + sizeOf(camera);
  }
  std::string line = "scenes: " + std::to_string(setup.description.scene_count) + ", of " + cameras;
  std::string splits;
  for (const SplitInfo& split : setup.splits->splits(setup.config.cameras.size())) {
    splits += (splits.empty() ? "; " : ", ") + split.name + " " + std::to_string(split.scene_count);
  }
  return line + splits;
}

std::string formatsLine(const RunSetup& setup) {
  std::string formats;
  for (const output::WriterOptions& writer : setup.config.writers) {
    formats += (formats.empty() ? "" : ", ") + writer.name;
  }
  return "formats: " + formats + ", in '" + setup.config.output.folder + "'";
}

}  // namespace

std::int64_t peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr std::int64_t kUnit = 1024;  // getrusage(2) reports kilobytes
  return usage.ru_maxrss * kUnit;
}

std::int64_t memoryLimit() {
  std::int64_t limit = std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGE_SIZE);
  const fs::path root = "/sys/fs/cgroup";
  for (const fs::path& file : {root / controlGroup() / "memory.max", root / "memory.max",
                               root / "memory" / "memory.limit_in_bytes"}) {
    if (const auto bytes = limitIn(file)) limit = std::min(limit, *bytes);
  }
  return limit;
}

std::optional<std::int64_t> freeDisk(const std::string& folder) {
  fs::path path = fs::path(folder).lexically_normal();
  std::error_code error;
  while (!fs::exists(path, error) && path.has_relative_path()) path = path.parent_path();
  struct statvfs disk {};
  if (::statvfs(path.c_str(), &disk) != 0) return std::nullopt;
  return static_cast<std::int64_t>(disk.f_bavail) * static_cast<std::int64_t>(disk.f_frsize);
}

std::vector<Finding> checkFigures(const RunFigures& figures) {
  std::vector<Finding> findings;
  if (figures.free_disk && figures.bytes > *figures.free_disk) {
    findings.push_back({"disk", "output_folder",
                        "the dataset takes about " + bytesText(figures.bytes) + ", and " +
                            bytesText(*figures.free_disk) + " are free",
                        "another disk, fewer scenes or formats, or JPEG images would help"});
  }
  if (figures.memory > figures.memory_limit) {
    findings.push_back({"memory", "processes",
                        "they take about " + bytesText(figures.memory) + " of memory, and " +
                            bytesText(figures.memory_limit) + " are available",
                        "fewer processes would help"});
  }
  return findings;
}

std::vector<std::string> planLines(const RunSetup& setup, const RunFigures& figures) {
  std::vector<std::string> lines;
  for (const MotionSetup& motion : setup.motions) {
    lines.push_back(windowOf(motion, setup.motions.size() == 1));
  }
  lines.push_back(scenesLine(setup));
  lines.push_back(formatsLine(setup));
  lines.push_back("takes about " + bytesText(figures.bytes) + " of disk" +
                  (figures.free_disk ? " (" + bytesText(*figures.free_disk) + " are free)" : "") +
                  ", " + timeText(figures.seconds) + ", " + bytesText(figures.memory) +
                  " of memory (of " + bytesText(figures.memory_limit) + ")");
  return lines;
}

}  // namespace synthetic_dataset::run
