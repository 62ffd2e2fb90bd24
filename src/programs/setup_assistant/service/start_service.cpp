#include "programs/setup_assistant/service/start_service.h"

#include <optional>
#include <vector>

#include "programs/setup_assistant/service/request_body.h"
#include "programs/start/draft_inputs.h"
#include "programs/start/settings_draft.h"

namespace synthetic_dataset::programs {
namespace {

std::vector<std::string> filesIn(const Value& body, const std::string& name,
                                 const AllowedFolders& allowed) {
  const Value given = entryOf(body, name);
  const auto* list = given.as<Value::List>();
  std::vector<std::string> files;
  for (const Value& each : list != nullptr ? *list : Value::List()) {
    files.push_back(allowed.resolve(each.text()).string());
  }
  return files;
}

}  // namespace

std::string startText(const Value& body, const AllowedFolders& allowed) {
  const std::vector<std::string> bags = filesIn(body, "bags", allowed);
  if (bags.empty()) throw HttpError(400, "bags: it should be a list of at least one");
  const std::string named = textOf(body, "world");
  std::optional<std::string> world;
  if (!named.empty()) world = allowed.resolve(named).string();
  DraftInputs inputs = readDraftInputs(bags, world);
  inputs.formats = {"coco", "ultralytics"};
  inputs.objects = objectsOf(filesIn(body, "models", allowed), inputs.contents);
  if (inputs.objects.empty()) {
    for (const motion::RobotFrame& robot : motion::robotFrames(inputs.contents)) {
      inputs.objects.push_back({objectNameOf(robot), std::nullopt, 0.0});
    }
  }
  return draftSettings(inputs).text;
}

}  // namespace synthetic_dataset::programs
