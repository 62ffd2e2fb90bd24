#include "run/live/live_setup.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "run/check/output_checks.h"
#include "run/live/json_values.h"

namespace synthetic_dataset::run {
namespace {

/// The path of the setting whose full name a text is, such as "camera/pose" or
/// "motions/0/bag_file"; empty for a file or a sentence.
std::vector<std::string> settingPath(const std::string& text) {
  const auto isOfName = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '/';
  };
  if (text.empty() || text.front() == '/' || !std::all_of(text.begin(), text.end(), isOfName)) {
    return {};
  }
  std::vector<std::string> path;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, '/');) path.push_back(part);
  return path;
}

bool isIndex(const std::string& part) {
  return !part.empty() && part.size() < 9 &&
         std::all_of(part.begin(), part.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

LiveProblem problemAbout(base::Severity severity, const std::string& about,
                         const std::string& what) {
  LiveProblem problem{severity, about, settingPath(about), what};
  const std::size_t cure = what.find("; ");
  if (cure == std::string::npos) return problem;
  problem.found = what.substr(0, cure);
  problem.cure = what.substr(cure + 2);
  return problem;
}

std::string textOf(const LiveProblem& problem) {
  return problem.found + (problem.cure.empty() ? "" : "; ") + problem.cure;
}

Value earlierValue(const output::EarlierRun& earlier) {
  return Value::Map{{"complete", earlier.complete},
                    {"scenes", earlier.scene_count},
                    {"fault", earlier.fault},
                    {"differences", namesValue(earlier.differences)}};
}

Value figuresValue(const LiveSetup& setup) {
  Value::Map splits;
  for (const SplitInfo& split : setup.splits) splits[split.name] = split.scene_count;
  Value::Map map = {
      {"scenes", setup.scenes}, {"splits", splits}, {"output_folder", setup.output_folder}};
  if (!setup.figures) return map;
  map["bytes"] = setup.figures->bytes;
  map["seconds"] = setup.figures->seconds;
  map["memory"] = setup.figures->memory;
  if (setup.figures->free_disk) map["free_bytes"] = *setup.figures->free_disk;
  return map;
}

const char* nameOf(base::Severity severity) {
  switch (severity) {
    case base::Severity::kError:
      return "error";
    case base::Severity::kWarning:
      return "warning";
    case base::Severity::kNote:
      return "note";
  }
  return "";
}

}  // namespace

LiveProblem problemOf(base::Severity severity, const std::string& message) {
  const std::size_t end = message.find(": ");
  if (end == std::string::npos) return problemAbout(severity, "", message);
  return problemAbout(severity, message.substr(0, end), message.substr(end + 2));
}

LiveProblem problemOf(const Finding& finding) {
  return {base::Severity::kWarning, finding.about, settingPath(finding.about), finding.found,
          finding.cure};
}

LiveSetup describeSetup(const RunSetup& run) {
  LiveSetup live;
  live.ready = true;
  for (const Finding& each : run.findings) live.problems.push_back(problemOf(each));
  for (const base::Diagnostic& each : run.diagnostics.all()) {
    const bool is_known =
        std::any_of(run.findings.begin(), run.findings.end(),
                    [&](const Finding& finding) { return finding.message() == each.message(); });
    if (is_known) continue;
    live.problems.push_back(each.where.empty()
                                ? problemOf(each.severity, each.what)
                                : problemAbout(each.severity, each.where, each.what));
  }
  for (const MotionSetup& motion : run.motions) {
    live.stamps.insert(live.stamps.end(), motion.timeline.stamps.begin(),
                       motion.timeline.stamps.end());
  }
  for (const scene::CameraRig& camera : run.motions.front().cameras) {
    live.cameras.push_back(camera.name);
  }
  for (const scene::ObjectOptions& object : run.config.objects) live.objects.push_back(object.name);
  live.scenes = run.description.scene_count;
  live.splits = run.splits->splits(live.cameras.size());
  live.output_folder = run.config.output.folder;
  return live;
}

LiveSetup describeCheck(const RunCheck& check, const std::vector<std::string>& warnings) {
  LiveSetup live = describeSetup(check.setup);
  const std::size_t at_setup = live.problems.size();
  for (const Finding& finding : check.findings) {
    if (finding.kind == kEarlierDataset) continue;  // added by addEarlierRun
    const LiveProblem problem = problemOf(finding);
    const bool is_known = std::any_of(
        live.problems.begin(), live.problems.begin() + static_cast<std::ptrdiff_t>(at_setup),
        [&](const LiveProblem& each) {
          return each.about == problem.about && textOf(each) == textOf(problem);
        });
    if (!is_known) live.problems.push_back(problem);
  }
  for (const std::string& each : warnings) {
    live.problems.push_back(problemOf(base::Severity::kWarning, each));
  }
  live.figures = check.figures;
  return live;
}

void addEarlierRun(const RunSetup& run, LiveSetup& live) {
  live.earlier = earlierRunOf(run);
  if (live.earlier && live.earlier->is_written) live.earlier.reset();  // maybe the user's run
  const auto finding = checkEarlierRun(run, live.earlier);
  if (finding) live.problems.push_back(problemOf(*finding));
}

LiveSetup describeErrors(const ErrorList& errors) {
  LiveSetup live;
  for (const std::string& each : errors.messages()) {
    live.problems.push_back(problemOf(base::Severity::kError, each));
  }
  return live;
}

Value problemValue(const LiveProblem& problem) {
  Value::Map map = {{"severity", nameOf(problem.severity)},
                    {"about", problem.about},
                    {"found", problem.found},
                    {"cure", problem.cure}};
  Value::List path;
  for (const std::string& part : problem.path) {
    path.push_back(isIndex(part) ? Value(std::stoi(part)) : Value(part));
  }
  if (!path.empty()) map["path"] = path;
  return map;
}

Value::Map setupValue(const LiveSetup& setup) {
  Value::List problems;
  for (const LiveProblem& each : setup.problems) problems.push_back(problemValue(each));
  Value::List stamps;
  for (const Stamp stamp : setup.stamps) stamps.emplace_back(toSeconds(stamp));
  return {{"ready", setup.ready},
          {"problems", problems},
          {"instants", static_cast<std::int64_t>(setup.stamps.size())},
          {"stamps", stamps},
          {"cameras", namesValue(setup.cameras)},
          {"objects", namesValue(setup.objects)},
          {"figures", figuresValue(setup)},
          {"earlier", setup.earlier ? earlierValue(*setup.earlier) : Value()}};
}

}  // namespace synthetic_dataset::run
