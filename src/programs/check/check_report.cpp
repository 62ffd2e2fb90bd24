#include "programs/check/check_report.h"

#include <ostream>
#include <string>
#include <system_error>

#include <opencv2/imgcodecs.hpp>

#include "programs/check/check_sheet.h"
#include "programs/check/world_map.h"
#include "run/check/run_check.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const cv::Mat& picture, std::ostream& out) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(file.string(), picture);
  } catch (const cv::Exception&) {  // which does not say more
  }
  if (!is_written) throw Error("--out: '" + file.string() + "' cannot be written");
  out << "wrote " << file.string() << '\n';
}

void writePictures(const run::RunCheck& check, const fs::path& folder, std::ostream& out) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!check.scenes.empty()) write(folder / "check.png", checkSheet(check.scenes), out);
  for (const run::MotionSetup& motion : check.setup.motions) {
    const bool is_only = check.setup.motions.size() == 1;
    const std::string name =
        is_only ? "map.png" : "map_" + safeFileName(motion.entry.name) + ".png";
    write(folder / name, worldMap(motion, is_only, check.scenes), out);
  }
}

}  // namespace

bool checkAndPrint(const Value& settings, const fs::path& folder, std::ostream& out) {
  run::WarningList warnings;
  const run::RunCheck check = run::checkRun(settings, warnings);
  for (const std::string& line : run::planLines(check.setup, check.figures)) out << line << '\n';
  for (const std::string& note : check.setup.diagnostics.messages(base::Severity::kNote)) {
    out << "note: " << note << '\n';
  }
  for (const run::Finding& finding : check.findings) out << "odd: " << finding.message() << '\n';
  for (const std::string& warning : warnings.messages) out << "odd: " << warning << '\n';
  writePictures(check, folder, out);
  const std::size_t odd = check.findings.size() + warnings.messages.size();
  out << check.scenes.size() << " scenes were made to look at: "
      << (odd == 0 ? "nothing is odd"
                   : std::to_string(odd) + (odd == 1 ? " thing is" : " things are") + " odd")
      << '\n';
  return odd == 0;
}

}  // namespace synthetic_dataset::programs
