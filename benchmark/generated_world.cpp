#include "generated_world.h"

#include <cmath>
#include <fstream>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr int kModels = 50;
constexpr int kPictures = 5;
constexpr int kRings = 50;  // 2 * 50 * 50 triangles
constexpr double kPi = 3.14159265358979;

void writeFile(const fs::path& file, const std::string& content) {
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  if (!stream.flush()) throw Error(file.string() + ": cannot be written");
}

/// A bumpy sphere as an OBJ file; the bumps depend on the model.
std::string bumpySphere(int model) {
  std::string text = "mtllib skin.mtl\nusemtl skin\n";
  for (int i = 0; i <= kRings; ++i) {
    for (int j = 0; j <= kRings; ++j) {
      const double a = kPi * i / kRings;
      const double b = 2.0 * kPi * j / kRings;
      const double r = 0.4 + 0.02 * std::sin((3 + model % 7) * b) * std::sin(4 * a);
      const auto number = [](double value) { return " " + std::to_string(value); };
      text += "v" + number(r * std::sin(a) * std::cos(b)) + number(r * std::sin(a) * std::sin(b)) +
              number(r * std::cos(a)) + "\n";
      text += "vt" + number(static_cast<double>(j) / kRings) +
              number(static_cast<double>(i) / kRings) + "\n";
    }
  }
  const auto corner = [](int i, int j) {
    const std::string index = std::to_string(i * (kRings + 1) + j + 1);
    return " " + index + "/" + index;
  };
  for (int i = 0; i < kRings; ++i) {
    for (int j = 0; j < kRings; ++j) {
      text += "f" + corner(i, j) + corner(i + 1, j) + corner(i + 1, j + 1) + "\n";
      text += "f" + corner(i, j) + corner(i + 1, j + 1) + corner(i, j + 1) + "\n";
    }
  }
  return text;
}

void writePicture(const fs::path& file, int seed) {
  cv::Mat pixels(512, 512, CV_8UC3);
  for (int v = 0; v < pixels.rows; ++v) {
    for (int u = 0; u < pixels.cols; ++u) {
      const auto channel = [&](int k) {
        return static_cast<unsigned char>(u * k + (v ^ u) + seed);
      };
      pixels.at<cv::Vec3b>(v, u) = {channel(1), channel(2), channel(3)};
    }
  }
  fs::create_directories(file.parent_path());
  if (!cv::imwrite(file.string(), pixels)) throw Error(file.string() + ": cannot be written");
}

std::string modelInWorld(int model, const std::string& mesh) {
  const std::string place =
      std::to_string(2 + model / 10) + " " + std::to_string(model % 10 - 4.5) + " 0.5 0 0 0";
  return "<model name='m" + std::to_string(model) + "'><static>true</static><pose>" + place +
         "</pose><link name='body'><visual name='v'><geometry><mesh><uri>" + mesh +
         "</uri></mesh></geometry></visual></link></model>\n";
}

}  // namespace

GeneratedWorld generateWorld(const fs::path& folder) {
  GeneratedWorld world;
  for (int picture = 0; picture < kPictures; ++picture) {
    world.pictures.push_back(folder / "pictures" / (std::to_string(picture) + ".png"));
    writePicture(world.pictures.back(), 50 * picture);
  }
  std::string models;
  for (int model = 0; model < kModels; ++model) {
    const std::string name = "model" + std::to_string(model);
    const std::string picture =
        world.pictures[static_cast<std::size_t>(model % kPictures)].string();
    world.meshes.push_back(folder / name / "shape.obj");
    writeFile(world.meshes.back(), bumpySphere(model));
    writeFile(folder / name / "skin.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd " + picture + "\n");
    models += modelInWorld(model, world.meshes.back().string());
  }
  world.world = folder / "benchmark.world";
  writeFile(world.world,
            "<sdf version='1.6'><world name='benchmark'>\n" + models + "</world></sdf>\n");
  return world;
}

}  // namespace synthetic_dataset::benchmark
