#include "run/run_summary.h"

#include <algorithm>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {

namespace {

/// The program `report` parses this line, too.
std::string timeLine(const StageTimes& times) {
  return "time: set-up " + fixed(times.setup, 1) + " s; side by side drawing " +
         fixed(times.drawing, 1) + " s, labels " + fixed(times.labels, 1) + " s, writing " +
         fixed(times.writing, 1) + " s; files of the whole dataset " +
         fixed(times.dataset_files, 1) + " s";
}

}  // namespace

std::vector<std::string> summaryLines(const RunSummary& summary) {
  std::vector<std::string> lines;
  if (summary.was_complete) return {"manifest: " + summary.manifest};
  const double rate =
      summary.seconds > 0.0 ? static_cast<double>(summary.scenes) / summary.seconds : 0.0;
  std::string made = std::to_string(summary.scenes) + " of " +
                     std::to_string(summary.planned_scenes) + " scenes in " +
                     fixed(summary.seconds, 1) + " s (" + fixed(rate, 1) + " scenes/s)";
  if (summary.dataset_scenes > summary.scenes) {
    made += ", " + std::to_string(summary.dataset_scenes - summary.scenes) + " made before";
  }
  lines.push_back(made + "; " + std::to_string(summary.files) + " files, " +
                  fixed(static_cast<double>(summary.bytes) / 1e6, 1) + " MB");
  if (summary.scenes > 0) lines.push_back(timeLine(summary.times));
  for (const RunSummary::Object& object : summary.objects) {
    std::string line = "object " + object.name + ": in view in " +
                       std::to_string(object.scenes_in_view) + " scenes";
    if (object.scenes_seen > 0) line += ", seen in " + std::to_string(object.scenes_seen);
    if (object.scenes_dropped > 0) {
      line += ", too little seen for a label in " + std::to_string(object.scenes_dropped);
    }
    if (object.mask_agreement) {
      line += "; visible masks by background subtraction: mean intersection over union " +
              fixed(*object.mask_agreement, 4) + " with exact ones";
    }
    lines.push_back(line);
  }
  for (const auto& [kind, count] : summary.warnings) {
    const auto& missing = summary.missing_labels;
    if (std::find(missing.begin(), missing.end(), kind) != missing.end()) continue;
    lines.push_back("warning, " + std::to_string(count) + (count == 1 ? " time: " : " times: ") +
                    kind);
  }
  lines.push_back("manifest: " + summary.manifest);
  return lines;
}

Value::Map summaryValue(const RunSummary& summary) {
  Value::Map value = {{"manifest", Value(summary.manifest)},
                      {"was_complete", Value(summary.was_complete)}};
  if (summary.was_complete) return value;
  value["scenes"] = Value(summary.scenes);
  value["seconds"] = Value(summary.seconds);
  value["dataset_scenes"] = Value(summary.dataset_scenes);
  value["planned_scenes"] = Value(summary.planned_scenes);
  value["files"] = Value(summary.files);
  value["bytes"] = Value(summary.bytes);
  Value::List objects;
  for (const RunSummary::Object& object : summary.objects) {
    objects.emplace_back(Value::Map{{"name", Value(object.name)},
                                    {"scenes_in_view", Value(object.scenes_in_view)},
                                    {"scenes_seen", Value(object.scenes_seen)},
                                    {"scenes_labelled", Value(object.scenes_labelled)}});
  }
  value["objects"] = Value(objects);
  Value::Map warnings;
  for (const auto& [kind, count] : summary.warnings) warnings[kind] = Value(count);
  value["warnings"] = Value(warnings);
  return value;
}

std::string lastLine(const RunSummary& summary) {
  const std::vector<std::string>& missing_labels = summary.missing_labels;
  if (summary.was_complete) {
    return "done: the dataset was complete already, nothing had to be made (`if_exists: overwrite` "
           "makes it anew)";
  }
  if (missing_labels.empty()) return "done";
  const std::size_t more = missing_labels.size() - 1;
  return "done, but " + missing_labels.front() +
         (more == 0 ? ""
                    : " (and " + std::to_string(more) +
                          (more == 1 ? " more such warning)" : " more such warnings)"));
}

}  // namespace synthetic_dataset::run
