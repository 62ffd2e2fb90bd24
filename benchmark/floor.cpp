/// What a scene costs at the least where Mesa's llvmpipe draws: colour, lit without shadows, and
/// identifiers of the same triangles in one pass, read, and compressed as two PNGs in another
/// thread, while the next scene is drawn.
///
///   benchmark_floor FOLDER SCENES
///
/// FOLDER holds the room of speed/room.py. Prints the seconds from the first scene to the last, as
/// JSON.

#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "output/background_worker.h"
#include "output/image/png_encoder.h"
#include "render/gl/gl_planes.h"
#include "render/gl/osmesa_context.h"
#include "render/gl/shader_program.h"
#include "render/parts/mesh_library.h"
#include "render/parts/texture_library.h"
#include "render/view.h"
#include "world/world_loader.h"

namespace {

using namespace synthetic_dataset;

constexpr char kVertexShader[] = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinates;
uniform mat4 world_from_mesh;
uniform mat4 clip_from_world;
out vec3 seen_normal;
out vec2 seen_coordinates;
void main() {
  seen_normal = mat3(world_from_mesh) * normal;
  seen_coordinates = coordinates;
  gl_Position = clip_from_world * world_from_mesh * vec4(position, 1.0);
}
)";
constexpr char kFragmentShader[] = R"(#version 450 core
in vec3 seen_normal;
in vec2 seen_coordinates;
uniform vec4 diffuse;
uniform sampler2D picture;
uniform vec3 to_light;
uniform uint part;
layout(location = 0) out vec4 colour;
layout(location = 1) out uint identifier;
void main() {
  float sun = max(dot(normalize(seen_normal), to_light), 0.0);
  colour = vec4(diffuse.rgb * texture(picture, seen_coordinates).rgb * (0.35 + 0.75 * sun), 1.0);
  identifier = part;
}
)";

/// A surface of the room.
struct Drawn {
  const render::MeshBuffers* mesh;
  GLuint picture;
  Eigen::Vector4f diffuse;
  Pose X_WV;        ///< of what stands still
  Pose X_MV;        ///< in its model
  int object = -1;  ///< -1 for what stands still
};

class Floor {
 public:
  Floor(const world::Description& description, const nlohmann::json& room)
      : gl_(context_.gl()),
        size_(room["width"], room["height"]),
        meshes_(gl_),
        textures_(gl_),
        program_(gl_, kVertexShader, kFragmentShader),
        colour_(render::makePlane(gl_, GL_RGBA8, size_.width, size_.height)),
        identifiers_(render::makePlane(gl_, GL_R32UI, size_.width, size_.height)),
        depth_(render::makePlane(gl_, GL_DEPTH_COMPONENT32F, size_.width, size_.height)),
        framebuffer_(render::makeFramebuffer(gl_)) {
    render::attachPlanes(gl_, framebuffer_, {&colour_, &identifiers_}, &depth_);
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.FrontFace(GL_CW);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Enable(GL_CULL_FACE);
    gl_.DepthFunc(GL_GREATER);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.Viewport(0, 0, size_.width, size_.height);
    take(description);
    lookFrom(room);
  }

  /// @param placed  for each object: x, y, z [m], yaw [rad]
  void draw(const nlohmann::json& placed) {
    constexpr float kGrey[] = {0.7F, 0.7F, 0.7F, 1.0F};
    constexpr GLuint kNobody[] = {0, 0, 0, 0};
    constexpr float kFarthest = 0.0F;
    gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kGrey);
    gl_.ClearNamedFramebufferuiv(framebuffer_.name(), GL_COLOR, 1, kNobody);
    gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &kFarthest);
    program_.use();
    for (const Drawn& each : drawn_) {
      Pose X_WV = each.X_WV;
      if (each.object >= 0) {
        const nlohmann::json& at = placed[static_cast<std::size_t>(each.object)];
        const Eigen::AngleAxisd turn(at[3].get<double>(), Eigen::Vector3d::UnitZ());
        const Eigen::Vector3d place(at[0].get<double>(), at[1].get<double>(), at[2].get<double>());
        X_WV = makePose(place, Eigen::Quaterniond(turn)) * each.X_MV;
      }
      program_.set("world_from_mesh", Eigen::Matrix4f(X_WV.matrix().cast<float>()));
      program_.set("diffuse", each.diffuse);
      program_.set("part", static_cast<std::uint32_t>(each.object + 1));
      gl_.BindTextureUnit(0, each.picture);
      each.mesh->draw();
    }
  }

  [[nodiscard]] cv::Mat readColour() const {
    return render::readPlane(gl_, framebuffer_, 0, {{}, size_}, CV_8UC3, GL_BGR, GL_UNSIGNED_BYTE);
  }
  [[nodiscard]] cv::Mat readIdentifiers() const {
    return render::readPlane(gl_, framebuffer_, 1, {{}, size_}, CV_32SC1, GL_RED_INTEGER,
                             GL_UNSIGNED_INT);
  }

 private:
  void take(const world::Description& description) {
    for (const world::Model& model : description.models) {
      const bool is_object = model.name.rfind("object", 0) == 0;
      for (const world::Link& link : model.links) {
        for (const world::Visual& visual : link.visuals) {
          for (const world::Surface& surface : visual.surfaces) {
            const Pose X_MV = link.X_ML * visual.X_LV;
            const auto& picture = surface.material.texture ? surface.material.texture : white_;
            drawn_.push_back({&meshes_.get(surface.mesh),
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
    Eigen::Vector3d to_light;
    for (int row = 0; row < 3; ++row) {
      const auto i = static_cast<std::size_t>(row);
      X_WC.translation()[row] = room["camera"][i];
      to_light[row] = -room["light_direction"][i].get<double>();
      for (int column = 0; column < 3; ++column) {
        X_WC.linear()(row, column) = room["rotation"][i][static_cast<std::size_t>(column)];
      }
    }
    const double f = room["focal"];
    const CameraModel camera(size_.width, size_.height,
                             {f, f, 0.5 * (size_.width - 1), 0.5 * (size_.height - 1)}, 0.05,
                             100.0);
    const Eigen::Matrix4d clip_from_world =
        render::clipFromCamera(camera) * X_WC.inverse().matrix();
    program_.set("clip_from_world", Eigen::Matrix4f(clip_from_world.cast<float>()));
    program_.set("to_light", Eigen::Vector3f(to_light.normalized().cast<float>()));
  }

  render::OsmesaContext context_;
  const render::GlFunctions& gl_;
  cv::Size size_;
  render::MeshLibrary meshes_;
  render::TextureLibrary textures_;
  render::ShaderProgram program_;
  render::GlTexture colour_, identifiers_, depth_;
  render::GlFramebuffer framebuffer_;
  std::shared_ptr<const world::Texture> white_ = std::make_shared<const world::Texture>(
      world::Texture{"white", cv::Mat(1, 1, CV_8UC4, cv::Scalar::all(255))});
  std::vector<Drawn> drawn_;
};

void write(const std::string& file, const std::vector<uchar>& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + file);
}

double secondsOf(const std::string& folder, std::size_t scenes) {
  const nlohmann::json room = nlohmann::json::parse(std::ifstream(folder + "/scene.json"));
  const world::ResourceFinder finder(
      {}, [](const std::string&) -> std::optional<std::string> { return std::nullopt; });
  Floor floor(world::loadWorld(folder + "/room.sdf", finder), room);
  output::BackgroundWorker encoder(2);
  auto begin = std::chrono::steady_clock::now();
  for (std::size_t scene = 0; scene <= scenes; ++scene) {  // the first is for warming up
    if (scene == 1) {
      encoder.finish();
      begin = std::chrono::steady_clock::now();
    }
    floor.draw(room["scenes"][scene % room["scenes"].size()]);
    encoder.add([&folder, scene, colour = floor.readColour(), ids = floor.readIdentifiers()] {
      constexpr int kCompression = 1;  // as ours by default: the quickest
      cv::Mat identifiers;
      ids.convertTo(identifiers, CV_8U);
      const std::string name = folder + "/floor" + std::to_string(scene);
      write(name + ".png", output::encodePng(colour, {}, kCompression));
      write(name + "_ids.png", output::encodePng(identifiers, {}, kCompression));
    });
  }
  encoder.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::invalid_argument("usage: benchmark_floor FOLDER SCENES");
    std::cout << nlohmann::json{{"seconds", secondsOf(argv[1], std::stoul(argv[2]))}} << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_floor: " << error.what() << '\n';
    return 1;
  }
}
