#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/cuboid_lines.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/json_file.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::image_folder {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The position of each image's line in a file of JSON lines.
class LineIndex {
 public:
  /// @throws Error if a line is not JSON with a `file_name`
  explicit LineIndex(const std::filesystem::path& file);

  /// @throws Error if there is no line with this `file_name`
  [[nodiscard]] json line(const std::string& file_name) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::int64_t> begins_;
};

LineIndex::LineIndex(const std::filesystem::path& file) : file_(file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("'" + file.string() + "': cannot be read");
  std::int64_t begin = 0;
  readingJson(file, [&] {
    for (std::string text; std::getline(stream, text);) {
      if (!text.empty()) {
        begins_.emplace(parsedJson<json>(text).at("file_name").get<std::string>(), begin);
      }
      begin += static_cast<std::int64_t>(text.size()) + 1;
    }
  });
}

json LineIndex::line(const std::string& file_name) const {
  const auto found = begins_.find(file_name);
  if (found == begins_.end()) {
    throw Error("'" + file_.string() + "': no line of '" + file_name + "'");
  }
  std::ifstream stream(file_, std::ios::binary);
  std::string text;
  if (!stream.seekg(found->second) || !std::getline(stream, text)) {
    throw Error("'" + file_.string() + "': cannot be read");
  }
  return readingJson(file_, [&] { return parsedJson<json>(text); });
}

CameraModel cameraOf(const json& line) {
  constexpr double kNear = 1e-3;  // the line has no near and far limits
  constexpr double kFar = 1e6;
  const json& camera = line.at("camera");
  const auto k = camera.at("K").get<std::array<double, 9>>();
  const Distortion distortion = makeDistortion(camera.at("distortion_model").get<std::string>(),
                                               camera.at("D").get<std::vector<double>>());
  return {integerOf(line.at("width")),
          integerOf(line.at("height")),
          {k[0], k[4], k[2], k[5]},
          kNear,
          kFar,
          distortion};
}

Pose poseOf(const json& numbers) {
  const auto rows = numbers.get<std::array<double, 16>>();
  Pose X_AB = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      X_AB.matrix()(row, column) = rows.at(static_cast<std::size_t>(4 * row + column));
    }
  }
  return X_AB;
}

/// The label of the `i`th object in the lists.
DrawnLabel labelOf(const json& objects, std::size_t i, const cv::Mat& instances,
                   const CameraModel& camera) {
  DrawnLabel label;
  label.caption = objects.at("class_names").at(i).get<std::string>();
  label.class_names = {label.caption};
  if (objects.contains("names")) label.object_name = objects.at("names").at(i).get<std::string>();
  label.X_CO = poseOf(objects.at("X_CO").at(i));
  const auto box = objects.at("bbox").at(i).get<std::array<double, 4>>();
  label.box = Box{box[0] - 0.5, box[1] - 0.5, box[0] + box[2] - 0.5, box[1] + box[3] - 0.5};
  if (!instances.empty()) label.mask = instances == integerOf(objects.at("instances").at(i));
  const auto cuboid = objects.at("cuboid").at(i).get<std::array<double, 6>>();
  label.lines = cuboidLines({{cuboid[0], cuboid[1], cuboid[2]}, {cuboid[3], cuboid[4], cuboid[5]}},
                            *label.X_CO, camera);
  const json& keypoints = objects.at("keypoints").at(i);
  for (std::size_t k = 0; k < keypoints.size(); ++k) {
    const auto place = keypoints.at(k).get<std::array<double, 2>>();
    const int flag = integerOf(objects.at("keypoint_visibility").at(i).at(k));
    if (flag == 2) label.keypoints.emplace_back(place[0], place[1]);
    if (flag == 1) label.hidden_keypoints.emplace_back(place[0], place[1]);
  }
  return label;
}

// Hugging Face's imagefolder: <split>/metadata.jsonl with one line per image and paths relative to
// that file.
LabelledPicture readScene(const WrittenScene& scene) {
  const auto image =
      std::find_if(scene.files.begin(), scene.files.end(), [&](const fs::path& file) {
        return file.stem() == fs::path(scene.name).filename() &&
               (file.extension() == ".png" || file.extension() == ".jpg");
      });
  if (image == scene.files.end()) {
    throw Error("'" + scene.folder.string() + "': no image of scene " + scene.name);
  }
  LabelledPicture picture{readPicture(*image, cv::IMREAD_COLOR), {}};
  const fs::path split = scene.folder / *image->lexically_relative(scene.folder).begin();
  const fs::path metadata = split / "metadata.jsonl";
  readingJson(metadata, [&] {
    const json line =
        scene.kept->get<LineIndex>(metadata)->line(image->lexically_relative(split).string());
    cv::Mat instances;
    if (line.contains("mask_file_name")) {
      instances =
          readPicture(split / line.at("mask_file_name").get<std::string>(), cv::IMREAD_UNCHANGED);
      if (instances.channels() != 1) {
        throw Error("'" + metadata.string() + "': its mask_file_name should have one channel");
      }
    }
    const json& objects = line.at("objects");
    for (std::size_t i = 0; i < objects.at("bbox").size(); ++i) {
      picture.labels.push_back(labelOf(objects, i, instances, cameraOf(line)));
    }
  });
  return picture;
}

/// Decodes normals from their 8-bit colours, with that precision.
cv::Mat normalsOf(const cv::Mat_<cv::Vec3b>& colours) {
  const auto coordinate = [](uchar byte) { return static_cast<float>(byte) / 127.5F - 1.0F; };
  cv::Mat_<cv::Vec3f> normals(colours.size());
  std::transform(colours.begin(), colours.end(), normals.begin(), [&](const cv::Vec3b& c) {
    return c == cv::Vec3b() ? cv::Vec3f()
                            : cv::Vec3f(coordinate(c[2]), coordinate(c[1]), coordinate(c[0]));
  });
  return normals;
}

cv::Mat flowOf(const fs::path& u_file, const fs::path& v_file) {
  const std::vector<cv::Mat> parts = {readPicture(u_file, cv::IMREAD_UNCHANGED),
                                      readPicture(v_file, cv::IMREAD_UNCHANGED)};
  if (parts[0].size() != parts[1].size() || parts[0].type() != CV_32FC1 ||
      parts[1].type() != CV_32FC1) {
    throw Error("'" + u_file.string() + "': it and '" + v_file.string() +
                "' should have 32 bits and the same size");
  }
  cv::Mat both;
  cv::merge(parts, both);
  return both;
}

std::vector<DecodedPicture> picturesOf(const WrittenScene& scene, const CameraModel& /*camera*/,
                                       const DatasetInfo& /*dataset*/) {
  const auto fileOf = [&](const std::string& end) -> std::optional<fs::path> {
    const std::string name = scene.name + end;
    for (const fs::path& file : scene.files) {
      const std::string path = file.string();
      if (path.size() > name.size() &&
          path.compare(path.size() - name.size(), name.size(), name) == 0) {
        return file;
      }
    }
    return std::nullopt;
  };
  std::vector<DecodedPicture> pictures;
  if (const auto file = fileOf(".normals.png")) {
    const cv::Mat colours = readPicture(*file, cv::IMREAD_UNCHANGED);
    if (colours.type() != CV_8UC3) throw Error("'" + file->string() + "': it should have colours");
    pictures.push_back({"normals", normalsOf(colours), "normals.colours", colours, {}, {*file}});
  }
  const auto u_file = fileOf(".flow_u.tiff");
  const auto v_file = fileOf(".flow_v.tiff");
  if (u_file && v_file) {
    const cv::Mat flow = flowOf(*u_file, *v_file);
    pictures.push_back({"optical_flow", flow, "optical_flow", flow, {}, {*u_file, *v_file}});
  }
  return pictures;
}

}  // namespace

Format format() { return {"synthetic_dataset/ImageFolder", true, readScene, picturesOf}; }

}  // namespace synthetic_dataset::formats::image_folder
