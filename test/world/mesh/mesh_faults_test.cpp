#include <gmock/gmock.h>

#include "world/mesh/mesh_loader.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace mesh_faults_test {

using test::kTriangleObj;
using test::TemporaryFolder;
using testing::HasSubstr;

class MeshFaultTest : public testing::Test {
 protected:
  MeshRequest write(const std::string& name, const std::string& content) const {
    MeshRequest request;
    request.file = folder_.write(name, content);
    return request;
  }
  std::string errorOf(const MeshRequest& request) {
    try {
      static_cast<void>(loader_.pieces(request));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  ResourceFinder finder_ = test::finderIn(folder_);
  MeshLoader loader_{finder_};
};

/// A grid of `side` times `side` squares of two triangles each.
std::string gridObj(int side) {
  std::string text;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
    }
  }
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int corner = y * (side + 1) + x + 1;
      const std::string a = std::to_string(corner), b = std::to_string(corner + 1);
      const std::string c = std::to_string(corner + side + 2),
                        d = std::to_string(corner + side + 1);
      text.append("f ").append(a).append(" ").append(b).append(" ").append(c).append("\n");
      text.append("f ").append(a).append(" ").append(c).append(" ").append(d).append("\n");
    }
  }
  return text;
}

TEST_F(MeshFaultTest, RefusesAFileThatBreaksOff) {
  std::string stl(80, '\0');
  stl += std::string("\x02\0\0\0", 4) + std::string(30, '\0');
  EXPECT_THAT(errorOf(write("a.stl", stl)), HasSubstr("a.stl': "));
  EXPECT_THAT(errorOf(write("a.dae", "<COLLADA><library_geometries>")), HasSubstr("a.dae': "));
  EXPECT_THAT(errorOf(write("a.glb", std::string("glTF\x02\0\0\0\xFF\0\0\0", 12))),
              HasSubstr("a.glb': "));
  EXPECT_THAT(
      errorOf(write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n")),
      HasSubstr("a.ply': "));
  EXPECT_THAT(errorOf(write("a.ply",
                            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                            "end_header3 0 1 2")),
              HasSubstr("no line 'end_header'"));
  EXPECT_THAT(errorOf(write("a.obj", "")), HasSubstr("a.obj': "));
}

TEST_F(MeshFaultTest, RefusesAnIndexThatIsOutOfRange) {
  EXPECT_THAT(errorOf(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")),
              HasSubstr("a.obj': "));
  EXPECT_THAT(
      errorOf(write("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                    "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")),
      HasSubstr("a.ply': cannot be read (has a face with vertex 7 (counted from 0) of 3"));
}

TEST_F(MeshFaultTest, RefusesAnInfiniteVertex) {
  EXPECT_THAT(errorOf(write("a.obj", "v inf 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
              HasSubstr("a.obj': has a vertex that is not a number"));
}

TEST_F(MeshFaultTest, RefusesAnAbsurdScale) {
  MeshRequest request = write("a.obj", kTriangleObj);
  request.scale = {1, 1e9, 1};
  EXPECT_THAT(errorOf(request), HasSubstr("a.obj': reaches 2e+09 m from its origin"));
}

TEST_F(MeshFaultTest, MakesNormalsForDegenerateTriangles) {
  const MeshRequest request =
      write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 2 2\nf 1 2 3\nf 4 4 4\n");
  for (const Eigen::Vector3f& normal : loader_.whole(request)->normals) {
    EXPECT_NEAR(normal.norm(), 1.0F, 1e-5F);
  }
}

TEST_F(MeshFaultTest, ReadsAMillionTriangles) {
  const MeshRequest request = write("a.obj", gridObj(708));
  EXPECT_EQ(loader_.whole(request)->indices.size(), std::size_t{3} * 2 * 708 * 708);
}

}  // namespace mesh_faults_test
}  // namespace synthetic_dataset::world
