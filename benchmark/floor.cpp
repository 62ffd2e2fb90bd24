/// The least that a scene costs if Mesa's llvmpipe draws it: colour, lit without shadows, and
/// identifiers of the same triangles, drawn in one pass, read back, and compressed as two PNGs in
/// another thread while the next scene is drawn.
///
///   benchmark_floor FOLDER SCENES [same]
///
/// FOLDER holds the room of speed/room.py. With `same`, the picture is the same as ours, but made
/// in the usual way: with a shadow map and lookups of 16 texels, and four samples per pixel. Prints
/// the seconds from the first scene to the last, as JSON.

#include <array>
#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "base/background_worker.h"
#include "base/image/png_encoder.h"
#include "floor_picture.h"
#include "floor_shaders.h"
#include "render/gl/framebuffer.h"
#include "render/gl/offscreen_context.h"
#include "render/gl/shader_program.h"
#include "render/parts/mesh_library.h"
#include "render/parts/texture_library.h"
#include "render/view.h"
#include "world/world_loader.h"

namespace {

using namespace synthetic_dataset;
using namespace synthetic_dataset::benchmark;

constexpr GLsizei kShadowMap = 2048;  // side length [texel]
constexpr GLsizei kSamples = 4;       // per pixel
constexpr GLuint kPictureUnit = 0;
constexpr GLuint kShadowUnit = 1;

/// A surface of the room.
struct Drawn {
  std::shared_ptr<const world::Mesh> shape;
  const render::MeshBuffers* mesh;
  GLuint picture;
  Eigen::Vector4f diffuse;
  Pose X_WV;        ///< in the scene being drawn
  Pose X_MV;        ///< in its model
  int object = -1;  ///< -1 for static surfaces
};

/// The direction to the sun.
Eigen::Vector3d toLight(const nlohmann::json& room) {
  const auto light = room["light_direction"].get<std::array<double, 3>>();
  return -Eigen::Vector3d(light.data());
}

class Floor {
 public:
  /// @param same  whether to draw shadows and smooth edges
  Floor(const world::Description& description, const nlohmann::json& room, bool same)
      : gl_(context_.gl()),
        meshes_(gl_),
        textures_(gl_),
        program_(gl_, kVertexShader, fragmentShader(same ? kShadows : kNoShadows)),
        picture_(gl_, {room["width"], room["height"]}, 1) {
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.FrontFace(GL_CW);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Enable(GL_CULL_FACE);
    gl_.DepthFunc(GL_GREATER);
    take(description);
    lookFrom(room);
    if (same) castShadows(room);
  }

  /// @param placed  for each object: x, y, z [m], yaw [rad]
  void draw(const nlohmann::json& placed) {
    place(placed);
    if (shadow_program_) drawShadows();
    const FloorPicture& drawn = samples_ ? *samples_ : picture_;
    drawn.begin();
    program_.use();
    for (const Drawn& each : drawn_) {
      program_.set("world_from_mesh", Eigen::Matrix4f(each.X_WV.matrix().cast<float>()));
      program_.set("diffuse", each.diffuse);
      program_.set("part", static_cast<std::uint32_t>(each.object + 1));
      gl_.BindTextureUnit(kPictureUnit, each.picture);
      each.mesh->draw();
    }
    if (samples_) samples_->resolveTo(picture_);
  }

  [[nodiscard]] const FloorPicture& picture() const { return picture_; }

 private:
  void place(const nlohmann::json& placed) {
    for (Drawn& each : drawn_) {
      if (each.object < 0) continue;
      const nlohmann::json& at = placed[static_cast<std::size_t>(each.object)];
      const Eigen::AngleAxisd turn(at[3].get<double>(), Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d place(at[0].get<double>(), at[1].get<double>(), at[2].get<double>());
      each.X_WV = makePose(place, Eigen::Quaterniond(turn)) * each.X_MV;
    }
  }

  void drawShadows() {
    constexpr float kFarthest = 0.0F;
    gl_.ClearNamedFramebufferfv(shadow_framebuffer_->name(), GL_DEPTH, 0, &kFarthest);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer_->name());
    gl_.Viewport(0, 0, kShadowMap, kShadowMap);
    shadow_program_->use();
    for (const Drawn& each : drawn_) {
      shadow_program_->set("world_from_mesh", Eigen::Matrix4f(each.X_WV.matrix().cast<float>()));
      each.mesh->draw();
    }
  }

  void take(const world::Description& description) {
    for (const world::Model& model : description.models) {
      const bool is_object = model.name.rfind("object", 0) == 0;
      for (const world::Link& link : model.links) {
        for (const world::Visual& visual : link.visuals) {
          for (const world::Surface& surface : visual.surfaces) {
            const Pose X_MV = link.X_ML * visual.X_LV;
            const auto& picture = surface.material.texture ? surface.material.texture : white_;
            drawn_.push_back({surface.mesh, &meshes_.get(surface.mesh),
                              textures_.get(picture, render::PixelMeaning::kData).texture.name(),
                              surface.material.diffuse, model.X_WM * X_MV, X_MV,
                              is_object ? std::stoi(model.name.substr(6)) : -1});
          }
        }
      }
    }
  }

  void lookFrom(const nlohmann::json& room) {
    Pose X_WC = Pose::Identity();
    const cv::Size size(room["width"], room["height"]);
    for (int row = 0; row < 3; ++row) {
      const auto i = static_cast<std::size_t>(row);
      X_WC.translation()[row] = room["camera"][i];
      for (int column = 0; column < 3; ++column) {
        X_WC.linear()(row, column) = room["rotation"][i][static_cast<std::size_t>(column)];
      }
    }
    const double f = room["focal"];
    const CameraModel camera(size.width, size.height,
                             {f, f, 0.5 * (size.width - 1), 0.5 * (size.height - 1)}, 0.05, 100.0);
    const Eigen::Matrix4d clip_from_world =
        render::clipFromCamera(camera) * X_WC.inverse().matrix();
    program_.set("clip_from_world", Eigen::Matrix4f(clip_from_world.cast<float>()));
    program_.set("to_light", Eigen::Vector3f(toLight(room).normalized().cast<float>()));
  }

  /// The projection of the whole room as the sun sees it: x and y from -1 to 1, z from 0 to 1, with
  /// 1 nearest to the sun.
  [[nodiscard]] Eigen::Matrix4d shadowFromWorld(const nlohmann::json& room) const {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(toLight(room), Eigen::Vector3d::UnitZ());
    Eigen::AlignedBox3d seen;
    for (const Drawn& each : drawn_) {
      for (const auto& position : each.shape->positions) {
        seen.extend(turn * (each.X_WV * position.cast<double>().eval()));
      }
    }
    const Eigen::Vector3d scale =
        Eigen::Vector3d(2.0, 2.0, 1.0).cwiseQuotient(seen.max() - seen.min());
    Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
    result.topLeftCorner<3, 3>() = scale.asDiagonal() * turn.toRotationMatrix();
    result.topRightCorner<3, 1>() =
        -scale.cwiseProduct(seen.min()) - Eigen::Vector3d(1.0, 1.0, 0.0);
    return result;
  }

  void castShadows(const nlohmann::json& room) {
    samples_.emplace(gl_, cv::Size(room["width"], room["height"]), kSamples);
    shadow_map_.emplace(render::makePlane(gl_, GL_DEPTH_COMPONENT32F, kShadowMap, kShadowMap));
    shadow_framebuffer_.emplace(render::makeFramebuffer(gl_));
    render::attachPlanes(gl_, *shadow_framebuffer_, {}, &*shadow_map_);
    const GLuint map = shadow_map_->name();
    gl_.TextureParameteri(map, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl_.TextureParameteri(map, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    gl_.BindTextureUnit(kShadowUnit, map);
    const Eigen::Matrix4f shadow_from_world = shadowFromWorld(room).cast<float>();
    program_.set("shadow_from_world", shadow_from_world);
    program_.set("shadow", static_cast<int>(kShadowUnit));
    shadow_program_.emplace(gl_, kVertexShader, kDepthAlone);
    shadow_program_->set("clip_from_world", shadow_from_world);
  }

  render::OffscreenContext context_;
  const render::GlFunctions& gl_;
  render::MeshLibrary meshes_;
  render::TextureLibrary textures_;
  render::ShaderProgram program_;
  FloorPicture picture_;
  std::shared_ptr<const world::Texture> white_ = std::make_shared<const world::Texture>(
      world::Texture{"white", cv::Mat(1, 1, CV_8UC4, cv::Scalar::all(255))});
  std::vector<Drawn> drawn_;

  // Only for the same picture as ours:
  std::optional<FloorPicture> samples_;
  std::optional<render::GlTexture> shadow_map_;
  std::optional<render::GlFramebuffer> shadow_framebuffer_;
  std::optional<render::ShaderProgram> shadow_program_;
};

void write(const std::string& file, const std::vector<uchar>& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + file);
}

double secondsOf(const std::string& folder, std::size_t scenes, bool same) {
  const nlohmann::json room = nlohmann::json::parse(std::ifstream(folder + "/scene.json"));
  const world::ResourceFinder finder(
      {}, [](const std::string&) -> std::optional<std::string> { return std::nullopt; });
  Floor floor(world::loadWorld(folder + "/room.sdf", finder), room, same);
  base::BackgroundWorker encoder(2);
  auto begin = std::chrono::steady_clock::now();
  for (std::size_t scene = 0; scene <= scenes; ++scene) {  // the first is a warm-up
    if (scene == 1) {
      encoder.finish();
      begin = std::chrono::steady_clock::now();
    }
    floor.draw(room["scenes"][scene % room["scenes"].size()]);
    encoder.add([&folder, scene, colour = floor.picture().readColour(),
                 ids = floor.picture().readIdentifiers()] {
      constexpr int kCompression = 1;  // our default, the fastest
      cv::Mat identifiers;
      ids.convertTo(identifiers, CV_8U);
      const std::string name = folder + "/floor" + std::to_string(scene);
      write(name + ".png", base::encodePng(colour, {}, kCompression));
      write(name + "_ids.png", base::encodePng(identifiers, {}, kCompression));
    });
  }
  encoder.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const bool same = argc == 4 && std::string(argv[3]) == "same";
    if (argc != 3 && !same) {
      throw std::invalid_argument("usage: benchmark_floor FOLDER SCENES [same]");
    }
    const double seconds = secondsOf(argv[1], std::stoul(argv[2]), same);
    std::cout << nlohmann::json{{"seconds", seconds}} << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_floor: " << error.what() << '\n';
    return 1;
  }
}
