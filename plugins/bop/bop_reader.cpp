#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/bop/bop_models.h"
#include "plugins/bop/bop_options.h"
#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/json_file.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::bop {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// The pose in a JSON entry; all lengths are in millimetres.
Pose poseOf(const Json& json) {
  Pose pose = Pose::Identity();
  for (int i = 0; i < 9; ++i) {
    pose.linear()(i / 3, i % 3) = json.at("cam_R_m2c").at(static_cast<std::size_t>(i));
  }
  for (int i = 0; i < 3; ++i) {
    pose.translation()(i) = json.at("cam_t_m2c").at(static_cast<std::size_t>(i));
  }
  return pose;
}

Intrinsics cameraOf(const Json& json) {
  const Json& k = json.at("cam_K");
  return {k.at(0), k.at(4), k.at(2), k.at(5)};
}

Cuboid boundsOf(const Json& info) {
  const Eigen::Vector3d low(info.at("min_x"), info.at("min_y"), info.at("min_z"));
  return {low, low + Eigen::Vector3d(info.at("size_x"), info.at("size_y"), info.at("size_z"))};
}

/// The toolkit's box is one column and one row smaller than its pixels.
std::optional<Box> boxOf(const Json& json) {
  const double left = json.at(0);
  const double top = json.at(1);
  if (json.at(2).get<double>() < 0.0) return std::nullopt;
  return Box{left - 0.5, top - 0.5, left + json.at(2).get<double>() + 0.5,
             top + json.at(3).get<double>() + 0.5};
}

fs::path imageOf(const WrittenScene& scene) {
  for (const fs::path& file : scene.files) {
    if (file.parent_path().filename() == "rgb") return file;
  }
  throw Error("'" + scene.folder.string() + "': scene " + scene.name + " has no file in rgb/");
}

/// A file's content, to be kept from scene to scene.
struct JsonDocument {
  explicit JsonDocument(const fs::path& file)
      : content(readJson(file, [](const Json& json) { return json; })) {}

  Json content;
};

/// What `read` makes of a kept file.
template <class Read>
auto reading(const fs::path& file, KeptFiles& kept, const Read& read) {
  const auto document = kept.get<JsonDocument>(file);
  return readingJson(file, [&] { return read(document->content); });
}

/// The objects that have a model, which the format's own files do not tell.
struct ModelOwners {
  std::vector<std::string> class_names;
  Pose X_OM = Pose::Identity();  ///< of the model's frame, whose axes are parallel to the object's
};

std::map<int, ModelOwners> ownersIn(const fs::path& file, KeptFiles& kept) {
  if (!fs::exists(file)) return {};
  return reading(file, kept, [](const Json& json) {
    std::map<int, ModelOwners> owners;
    for (const Json& object : json.at("objects")) {
      ModelOwners& of_model = owners[integerOf(object.at("obj_id"))];
      of_model.class_names.push_back(object.at("class").get<std::string>());
      const auto origin = object.at("model_origin").get<std::array<double, 3>>();
      of_model.X_OM.translation() = Eigen::Vector3d(origin[0], origin[1], origin[2]);
    }
    return owners;
  });
}

/// Converts a pose from the model's frame to the object's, and from millimetres to metres.
Pose objectPose(const Pose& X_CM, const Pose& X_OM) {
  Pose X_CO = X_CM * X_OM.inverse();
  X_CO.translation() /= kMillimetres;
  return X_CO;
}

LabelledPicture readScene(const WrittenScene& scene) {
  const fs::path image = imageOf(scene);
  const fs::path folder = image.parent_path().parent_path();
  const std::string name = image.stem().string();
  if (name.empty() || name.size() > 9 ||
      name.find_first_not_of("0123456789") != std::string::npos) {
    throw Error("'" + image.string() + "': its name should be a number");
  }
  const std::string key = std::to_string(std::stoi(name));
  const auto ofImage = [&](const Json& json) { return json.at(key); };
  const Intrinsics camera = reading(folder / "scene_camera.json", *scene.kept,
                                    [&](const Json& json) { return cameraOf(json.at(key)); });
  const Json infos = reading(folder / "scene_gt_info.json", *scene.kept, ofImage);
  const Json models = reading(folder.parent_path().parent_path() / "models" / "models_info.json",
                              *scene.kept, [](const Json& json) { return json; });
  const std::map<int, ModelOwners> owners =
      ownersIn(scene.folder / "dataset_info.json", *scene.kept);
  LabelledPicture picture{readPicture(image, cv::IMREAD_COLOR), {}};
  picture.labels = reading(folder / "scene_gt.json", *scene.kept, [&](const Json& json) {
    std::vector<DrawnLabel> labels;
    for (const Json& object : json.at(key)) {
      const Pose X_CM = poseOf(object);
      const int id = integerOf(object.at("obj_id"));
      DrawnLabel label;
      label.caption = std::to_string(id);
      if (const auto owner = owners.find(id); owner != owners.end()) {
        label.class_names = owner->second.class_names;
        label.X_CO = objectPose(X_CM, owner->second.X_OM);
      }
      const std::string index = sixDigits(static_cast<std::int64_t>(labels.size()));
      label.mask =
          readPicture(folder / "mask_visib" / (name + "_" + index + ".png"), cv::IMREAD_GRAYSCALE);
      label.box = boxOf(infos.at(labels.size()).at("bbox_obj"));
      auto corners = boundsOf(models.at(label.caption)).corners();
      for (Eigen::Vector3d& corner : corners) corner = X_CM * corner;
      addCuboid(label, camera, corners);
      labels.push_back(std::move(label));
    }
    return labels;
  });
  return picture;
}

/// The depth, stored as 16-bit integers.
std::vector<DecodedPicture> picturesOf(const WrittenScene& scene, const CameraModel& /*camera*/,
                                       const DatasetInfo& dataset) {
  constexpr double kMetres = 1e-3;  // per millimetre
  constexpr double kGreatest = 65535.0;
  Parameters parameters(Value(scene.settings));
  const double scale = readBopOptions(parameters, dataset).depth_scale;
  std::vector<DecodedPicture> pictures;
  for (const fs::path& file : scene.files) {
    if (file.parent_path().filename() != "depth") continue;
    DecodedPicture depth;
    depth.name = "depth";
    depth.stored = readPicture(file, cv::IMREAD_UNCHANGED);
    if (depth.stored.type() != CV_16UC1) {
      throw Error("'" + file.string() + "': it should have one channel of 16 bits");
    }
    const double unit = kMetres * scale;
    depth.stored.convertTo(depth.pixels, CV_32F, unit);
    depth.stored_as = scale == 1.0 ? "depth.0.001" : scale == 0.1 ? "depth.0.0001" : "";
    depth.numbers = {unit, 0.5 * unit, kGreatest * unit};
    depth.files = {file};
    pictures.push_back(std::move(depth));
  }
  return pictures;
}

}  // namespace

Format format() { return {"synthetic_dataset/Bop", true, readScene, picturesOf}; }

}  // namespace synthetic_dataset::formats::bop
