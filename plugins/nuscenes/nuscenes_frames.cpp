#include "plugins/nuscenes/nuscenes_frames.h"

#include <Eigen/Geometry>

#include "plugins/nuscenes/nuscenes_options.h"
#include "plugins/shared/json.h"

namespace synthetic_dataset::nuscenes {
namespace {

Json placementJson(const Placement& placement) {
  const Eigen::Vector3d& p = placement.translation;
  const Quaternion& q = placement.rotation;
  return {p.x(), p.y(), p.z(), q(0), q(1), q(2), q(3)};
}

Placement placementOf(const Json& numbers) {
  const auto at = [&](std::size_t i) { return numbers.at(i).get<double>(); };
  Placement placement{{at(0), at(1), at(2)}, {}};
  placement.rotation << at(3), at(4), at(5), at(6);
  return placement;
}

}  // namespace

Placement placementOf(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  Placement placement{pose.translation(), {}};
  placement.rotation << q.w(), q.x(), q.y(), q.z();
  return placement;
}

bool isLidar(const DatasetInfo& dataset, const Frame& frame) {
  return frame.camera == static_cast<std::int64_t>(dataset.cameras.size());
}

std::string dataToken(const DatasetInfo& dataset, const Frame& frame) {
  return nuScenesToken(NuScenesTable::kSampleData, frame.scene, isLidar(dataset, frame) ? 1 : 0);
}

std::string recordOf(const Frame& frame) {
  Json objects = Json::array();
  for (const SeenObject& each : frame.objects) {
    objects.push_back({{"object", each.object},
                       {"pose", placementJson(each.X_GB)},
                       {"size", {each.size.x(), each.size.y(), each.size.z()}},
                       {"visibility", each.visibility},
                       {"pixels", each.pixels},
                       {"points", each.points},
                       {"box", {each.box.left, each.box.top, each.box.right, each.box.bottom}}});
  }
  return jsonText({{"instant", frame.instant},
                   {"microseconds", frame.microseconds},
                   {"sequence", frame.sequence},
                   {"camera", frame.camera},
                   {"file", frame.file},
                   {"ego", placementJson(frame.X_GE)},
                   {"objects", std::move(objects)}});
}

Frame frameOf(std::int64_t scene, const std::string& record) {
  const Json content = parsedJson<Json>(record);
  Frame frame;
  frame.scene = scene;
  frame.instant = content.at("instant").get<std::int64_t>();
  frame.microseconds = content.at("microseconds").get<std::int64_t>();
  frame.sequence = content.at("sequence").get<std::int64_t>();
  frame.camera = content.at("camera").get<std::int64_t>();
  frame.file = content.at("file").get<std::string>();
  frame.X_GE = placementOf(content.at("ego"));
  for (const Json& each : content.at("objects")) {
    const auto number = [&](const char* list, std::size_t i) {
      return each.at(list).at(i).get<double>();
    };
    frame.objects.push_back(
        {each.at("object").get<std::int64_t>(),
         placementOf(each.at("pose")),
         {number("size", 0), number("size", 1), number("size", 2)},
         each.at("visibility").get<double>(),
         each.at("pixels").get<std::int64_t>(),
         each.at("points").get<std::int64_t>(),
         {number("box", 0), number("box", 1), number("box", 2), number("box", 3)}});
  }
  return frame;
}

}  // namespace synthetic_dataset::nuscenes
