#include "plugins/pvnet/pvnet_values.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "plugins/pvnet/numpy_array.h"
#include "plugins/readback/files.h"
#include "plugins/readback/json_document.h"
#include "plugins/readback/model_values.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::pvnet {
namespace {

using nlohmann::json;
using Points = std::vector<Eigen::Vector3d>;

json listOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

json listOf(const Points& points) {
  json list = json::array();
  for (const Eigen::Vector3d& point : points) list.push_back(listOf(point));
  return list;
}

/// The rows [R | t].
std::vector<std::vector<double>> rowsOf(const Pose& pose) {
  std::vector<std::vector<double>> rows(3);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      rows[static_cast<std::size_t>(row)].push_back(pose.matrix()(row, column));
    }
  }
  return rows;
}

/// The points in a file `fps.txt`, to be kept.
struct PointFile {
  explicit PointFile(const std::filesystem::path& file) {
    for (const std::string& line : readLines(file)) {
      const std::vector<std::string> words = wordsOf(line);
      if (words.size() != 3) throw Error("'" + file.string() + "': found the line '" + line + "'");
      points.emplace_back(numberOf(words[0], file), numberOf(words[1], file),
                          numberOf(words[2], file));
    }
  }

  Points points;
};

/// Whether points are vertices of a model, each as far from those before it, and from the centre of
/// the model's extent, as any vertex is (clean-pvnet's farthest_point_sampling.cpp).
bool areFarthest(const Points& points, const ObjectModel& model) {
  constexpr double kSinglePrecision = 1e-6;
  const Cuboid extent = extentOf(model);
  const double tolerance = kSinglePrecision * (1.0 + extent.high.norm() + extent.low.norm());
  Points before = {0.5 * (extent.low + extent.high)};
  const auto distanceOf = [&](const Eigen::Vector3d& point) {
    double least = (point - before.front()).norm();
    for (const Eigen::Vector3d& each : before) least = std::min(least, (point - each).norm());
    return least;
  };
  for (const Eigen::Vector3d& point : points) {
    bool is_vertex = false;
    double farthest = 0.0;
    for (const ObjectModel::Vertex& vertex : model.vertices) {
      is_vertex = is_vertex || (vertex.position - point).norm() <= tolerance;
      farthest = std::max(farthest, distanceOf(vertex.position));
    }
    if (!is_vertex || distanceOf(point) < farthest - 10.0 * tolerance) return false;
    before.push_back(point);
  }
  return true;
}

/// What is known of an object's model.
struct Model {
  bool has_surface = false;
  double diameter = 0.0;
  Points corners;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

/// A sample of an object through a camera.
struct Sample {
  std::int64_t instant = 0;
  std::string split;
  Pose X_CO = Pose::Identity();
};

class PvNetValues : public ValueCheck {
 public:
  PvNetValues(std::string image_format, std::string data_root, const DatasetInfo& dataset)
      : image_format_(std::move(image_format)),
        data_root_(std::move(data_root)),
        dataset_(dataset) {
    for (std::size_t i = 0; i < dataset_.objects.size(); ++i) {
      models_.emplace_back();
      const ObjectModel surface = dataset_.model(i);
      if (surface.vertices.empty()) continue;
      const Cuboid extent = extentOf(surface);
      const auto corners = extent.corners();
      models_.back() = {true,
                        surface.diameter,
                        {corners.begin(), corners.end()},
                        0.5 * (extent.low + extent.high)};
    }
  }

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject& object = scene.objects[i];
      const std::string folder = folderOf(i, scene.camera_index);
      if (!object.labelled() || !models_.at(i).has_surface) continue;
      if (!isBefore(i, folder, scene.camera, *object.X_CO, files)) continue;
      const std::string number = sceneNumber(scene.instant);
      files.compareWithScene(folder + "scenes/rgb/" + number + image_format_, truth);
      files.compareMask(folder + "scenes/mask/" + number + ".png", object.visible_mask());
      comparePose(folder + "scenes/pose/" + number + ".npy", *object.X_CO, files);
      samples_[folder].push_back({scene.instant, scene.splitFolder(), *object.X_CO});
    }
  }

  void checkDataset(FoundFiles& files) override {
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (!models_[i].has_surface) continue;
      for (std::size_t camera = 0; camera < dataset_.cameras.size(); ++camera) {
        checkFolder(i, camera, files);
      }
    }
  }

 private:
  [[nodiscard]] std::string folderOf(std::size_t object, std::size_t camera) const {
    return safeFileName(dataset_.objects.at(object).name) + "/" + dataset_.cameraFolder(camera);
  }

  static const Points& farthestPoints(const std::string& folder, const FoundFiles& files) {
    return files.kept().get<PointFile>(files.folder() / (folder + "fps.txt"))->points;
  }

  [[nodiscard]] bool isBefore(std::size_t object, const std::string& folder,
                              const CameraModel& camera, const Pose& X_CO,
                              const FoundFiles& files) const {
    Points points = models_[object].corners;
    const Points& farthest = farthestPoints(folder, files);
    points.insert(points.end(), farthest.begin(), farthest.end());
    points.push_back(models_[object].centre);
    return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& p_O) {
      return camera.project(X_CO * p_O).has_value();
    });
  }

  static void comparePose(const std::string& name, const Pose& X_CO, FoundFiles& files) {
    const auto file = files.take(name);
    if (!file) return;
    const std::string found = readText(*file);
    const std::string right = numpyArray(rowsOf(X_CO));
    const std::size_t header = right.size() - 12 * sizeof(double);
    if (found.size() != right.size() || found.compare(0, header, right, 0, header) != 0) {
      files.differences().add(name + ": it is no array of 3 x 4 doubles");
      return;
    }
    for (std::size_t i = 0; i < 12; ++i) {
      std::array<double, 2> numbers{};
      std::memcpy(&numbers[0], found.data() + header + i * sizeof(double), sizeof(double));
      std::memcpy(&numbers[1], right.data() + header + i * sizeof(double), sizeof(double));
      if (areNear(numbers[0], numbers[1])) continue;
      files.differences().add(name + ", number " + std::to_string(i), std::to_string(numbers[0]),
                              std::to_string(numbers[1]));
    }
  }

  void checkFolder(std::size_t object, std::size_t camera, FoundFiles& files) {
    const std::string folder = folderOf(object, camera);
    const Model& model = models_[object];
    const ObjectModel surface = dataset_.model(object);
    comparePly(folder + "model.ply", surface, 1.0, files);
    const Intrinsics& k = dataset_.cameras[camera].model.intrinsics();
    compareNumbers(folder + "camera.txt", {{k.fx, 0.0, k.cx}, {0.0, k.fy, k.cy}, {0.0, 0.0, 1.0}},
                   files);
    compareNumbers(folder + "corners.txt", model.corners, files);
    compareNumbers(folder + "fps.txt", farthestPoints(folder, files), files);
    const std::size_t fewest = 8;  // that clean-pvnet takes
    if (farthestPoints(folder, files).size() != fewest ||
        !areFarthest(farthestPoints(folder, files), surface)) {
      files.differences().add(folder + "fps.txt: its points are not the model's farthest eight");
    }
    compareDiameter(folder + "diameter.txt", model.diameter, files);
    const std::vector<Sample>& samples = samples_[folder];
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::string scenes = (files.folder() / (folder + "scenes")).string();
      const std::string number = sceneNumber(samples[i].instant);
      const std::string name = std::to_string(i);
      files.compareBytes(folder + "rgb/" + name + image_format_,
                         scenes + "/rgb/" + number + image_format_);
      files.compareBytes(folder + "mask/" + name + ".png", scenes + "/mask/" + number + ".png");
      files.compareBytes(folder + "pose/pose" + name + ".npy", scenes + "/pose/" + number + ".npy");
    }
    for (const std::string& split : dataset_.splitFolders()) {
      compareSplit(object, camera, split, files);
    }
  }

  /// A file of lines of three numbers.
  static void compareNumbers(const std::string& name, const Points& right, FoundFiles& files) {
    const auto file = files.take(name);
    if (file) {
      compareJson(listOf(PointFile(*file).points), listOf(right), name, files.differences());
    }
  }

  static void compareDiameter(const std::string& name, double right, FoundFiles& files) {
    const auto file = files.take(name);
    if (!file) return;
    const std::vector<std::string> words = wordsOf(readText(*file));
    if (words.size() == 1 && areNear(numberOf(words[0], *file), right)) return;
    files.differences().add(name, joined(words), std::to_string(right));
  }

  void compareSplit(std::size_t object, std::size_t camera, const std::string& split,
                    FoundFiles& files) {
    const std::string folder = folderOf(object, camera);
    json images = json::array();
    json annotations = json::array();
    const std::vector<Sample>& samples = samples_[folder];
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].split != split) continue;
      const int id = static_cast<int>(images.size()) + 1;
      const CameraModel& model = dataset_.cameras[camera].model;
      images.push_back({{"file_name", data_root_ + "/rgb/" + std::to_string(i) + image_format_},
                        {"height", model.height()},
                        {"width", model.width()},
                        {"id", id}});
      annotations.push_back(
          annotationOf(object, model, samples[i].X_CO, farthestPoints(folder, files)));
      annotations.back()["mask_path"] = data_root_ + "/mask/" + std::to_string(i) + ".png";
      annotations.back()["id"] = annotations.back()["image_id"] = id;
    }
    const json categories = {{"supercategory", "none"}, {"id", 1}, {"name", "cat"}};
    files.compareJson(folder + split + ".json", {{"images", images},
                                                 {"annotations", annotations},
                                                 {"categories", json::array({categories})}});
  }

  [[nodiscard]] json annotationOf(std::size_t object, const CameraModel& camera, const Pose& X_CO,
                                  const Points& farthest) const {
    const Model& model = models_[object];
    const auto placeOf = [&](const Eigen::Vector3d& p_O) -> json {
      const auto pixel = camera.project(X_CO * p_O);
      return pixel ? json{pixel->x(), pixel->y()} : json();
    };
    const auto placesOf = [&](const Points& points) {
      json places = json::array();
      for (const Eigen::Vector3d& point : points) places.push_back(placeOf(point));
      return places;
    };
    const Intrinsics& k = camera.intrinsics();
    return {{"corner_3d", listOf(model.corners)},
            {"corner_2d", placesOf(model.corners)},
            {"center_3d", listOf(model.centre)},
            {"center_2d", placeOf(model.centre)},
            {"fps_3d", listOf(farthest)},
            {"fps_2d", placesOf(farthest)},
            {"category_id", 1},
            {"K", {{k.fx, 0.0, k.cx}, {0.0, k.fy, k.cy}, {0.0, 0.0, 1.0}}},
            {"pose", rowsOf(X_CO)},
            {"data_root", data_root_ + "/rgb"},
            {"type", "real"},
            {"cls", "cat"}};
  }

  std::string image_format_;
  std::string data_root_;
  DatasetInfo dataset_;
  std::vector<Model> models_;
  std::map<std::string, std::vector<Sample>> samples_;  ///< by folder
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  const std::string format = parameters.optionalChoice("image_format", {"jpg", "png"}, "jpg");
  return std::make_unique<PvNetValues>(
      "." + format, parameters.optional<std::string>("data_root", "data/custom"), dataset);
}

}  // namespace synthetic_dataset::formats::pvnet
