#include "render/lens/lens_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <opencv2/core/utility.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

/// If rays are farther from the axis than this, one plane gets too large, and the sides of a cube
/// are drawn.
constexpr double kWidestFace = 1.05;  // [rad]

constexpr double kDensity = 2.0;    // face pixels per pixel of the picture, in each direction
constexpr double kFinest = 4.0;     // at most this many times the lens's focal length
constexpr int kFilterMargin = 8;    // [px] drawn beyond what the pixels look at, for filters
constexpr int kLargestTile = 4096;  // [px]

/// A plane that is drawn, and the part of it that the picture's pixels look at.
struct Plane {
  Pose X_CF = Pose::Identity();
  double left = std::numeric_limits<double>::infinity();  // at z = 1
  double top = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = -std::numeric_limits<double>::infinity();
  double least_area = std::numeric_limits<double>::infinity();  // of a pixel, at z = 1
  double least_cosine = 1.0;  // of the angle between a ray and the plane's axis

  [[nodiscard]] bool used() const { return left <= right; }
};

/// A direction as an Eigen vector.
Eigen::Vector3d vectorOf(const cv::Vec3f& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// The sides of a cube: front, right, left, bottom, top, back.
std::vector<Plane> cubePlanes() {
  std::vector<Plane> planes(6);
  const std::array<std::array<int, 9>, 6> axes = {{
      // x, y and z of the side's frame, in the lens's frame
      {1, 0, 0, 0, 1, 0, 0, 0, 1},
      {0, 0, -1, 0, 1, 0, 1, 0, 0},
      {0, 0, 1, 0, 1, 0, -1, 0, 0},
      {1, 0, 0, 0, 0, -1, 0, 1, 0},
      {1, 0, 0, 0, 0, 1, 0, -1, 0},
      {-1, 0, 0, 0, 1, 0, 0, 0, -1},
  }};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < 9; ++j) {
      planes[i].X_CF.matrix()(static_cast<Eigen::Index>(j % 3), static_cast<Eigen::Index>(j / 3)) =
          axes[i][j];
    }
  }
  return planes;
}

int cubeSide(const cv::Vec3f& ray) {
  const float x = std::abs(ray[0]);
  const float y = std::abs(ray[1]);
  const float z = std::abs(ray[2]);
  if (z >= x && z >= y) return ray[2] > 0.0F ? 0 : 5;
  if (x >= y) return ray[0] > 0.0F ? 1 : 2;
  return ray[1] > 0.0F ? 3 : 4;
}

/// A map with each pixel's direction, and with 0 or -1 (the lens sees nothing) in `face`.
LensMap lookAlongRays(const CameraModel& camera) {
  LensMap map;
  map.rays = cv::Mat::zeros(camera.height(), camera.width(), CV_32FC3);
  map.face = cv::Mat(camera.height(), camera.width(), CV_16SC1, cv::Scalar(-1));
  // Rows are processed in parallel; no two calls share a pixel.
  cv::parallel_for_(cv::Range(0, camera.height()), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < camera.width(); ++u) {
        const auto ray = camera.ray(Eigen::Vector2d(u, v));
        if (!ray) continue;
        const Eigen::Vector3f r = ray->cast<float>();
        map.rays.at<cv::Vec3f>(v, u) = {r.x(), r.y(), r.z()};
        map.face.at<std::int16_t>(v, u) = 0;
      }
    }
  });
  return map;
}

bool fitsOnePlane(const LensMap& map) {
  const auto least = static_cast<float>(std::cos(kWidestFace));
  for (int v = 0; v < map.face.rows; ++v) {
    for (int u = 0; u < map.face.cols; ++u) {
      if (map.face.at<std::int16_t>(v, u) < 0) continue;
      if (map.rays.at<cv::Vec3f>(v, u)[2] < least) return false;
    }
  }
  return true;
}

/// The point, at z = 1, where the ray meets the plane.
Eigen::Vector2d meet(const Plane& plane, const cv::Vec3f& ray) {
  const Eigen::Vector3d d = plane.X_CF.linear().transpose() * vectorOf(ray);
  return d.head<2>() / d.z();
}

/// The step on the plane from a pixel to the next one, or from the previous one to it; nothing if
/// it has neither.
std::optional<Eigen::Vector2d> stepOn(const Plane& plane, const LensMap& map, int u, int v, int du,
                                      int dv) {
  const int side = neighbourSide(map, plane.X_CF, u, v, du, dv);
  if (side == 0) return std::nullopt;
  return meet(plane, map.rays.at<cv::Vec3f>(v + side * dv, u + side * du)) -
         meet(plane, map.rays.at<cv::Vec3f>(v, u));
}

/// A pixel's area at z = 1; in an image of one row or column, the pixel is taken to be square.
double areaOn(const Plane& plane, const LensMap& map, int u, int v) {
  const auto across = stepOn(plane, map, u, v, 1, 0);
  const auto along = stepOn(plane, map, u, v, 0, 1);
  if (across && along) return std::abs(across->x() * along->y() - across->y() * along->x());
  if (across) return across->squaredNorm();
  return along ? along->squaredNorm() : std::numeric_limits<double>::infinity();
}

/// Extends the used part of a plane, and its limits, by a pixel.
void measure(const LensMap& map, int u, int v, Plane& plane) {
  const cv::Vec3f& ray = map.rays.at<cv::Vec3f>(v, u);
  const Eigen::Vector2d place = meet(plane, ray);
  plane.left = std::min(plane.left, place.x());
  plane.right = std::max(plane.right, place.x());
  plane.top = std::min(plane.top, place.y());
  plane.bottom = std::max(plane.bottom, place.y());
  plane.least_cosine =
      std::min(plane.least_cosine, (plane.X_CF.linear().transpose() * vectorOf(ray)).z());
  plane.least_area = std::min(plane.least_area, areaOn(plane, map, u, v));
}

double focalLengthOf(const Plane& plane, const CameraModel& camera) {
  const double coarsest = 0.1 * std::min(camera.intrinsics().fx, camera.intrinsics().fy);
  const double finest = kFinest * std::max(camera.intrinsics().fx, camera.intrinsics().fy);
  if (std::isinf(plane.least_area)) return finest;  // for pixels without neighbours
  return std::clamp(kDensity / std::sqrt(plane.least_area), coarsest, finest);
}

/// How a plane's used part is cut, in one direction, into tiles of equal length [px].
struct Cut {
  int count = 1;
  int first = 0;   ///< the first tile's first pixel, counted from the plane's axis
  int length = 1;  ///< of each tile, without its margins

  [[nodiscard]] int tileOf(double place) const {
    const int tile = static_cast<int>(std::floor((place - first) / length));
    return std::clamp(tile, 0, count - 1);
  }
};

Cut cutInto(double low, double high) {
  Cut cut;
  cut.first = static_cast<int>(std::floor(low));
  const int whole = static_cast<int>(std::ceil(high)) - cut.first + 1;
  cut.count = (whole + kLargestTile - 1) / kLargestTile;
  cut.length = (whole + cut.count - 1) / cut.count;
  return cut;
}

/// The tiles of a plane, and the index in the list of faces at which they begin.
struct Tiles {
  double focal_length = 1.0;
  Cut across;
  Cut down;
  int first_face = 0;
};

/// Whether the lens's view begins exactly at the face's own near plane.
bool sharesNearPlane(const Plane& plane, const CameraModel& camera) {
  return camera.hasNearPlane() && plane.X_CF.linear().isIdentity();
}

/// The depth of a face's near plane, chosen so that it cuts off nothing that the lens shows: if the
/// lens's limit is a distance, or its near plane is turned relative to the face, the face's plane
/// moves nearer.
double nearOf(const Plane& plane, const CameraModel& camera) {
  constexpr double kSlack = 0.98;  // for the margins
  return sharesNearPlane(plane, camera) ? camera.near()
                                        : camera.near() * plane.least_cosine * kSlack;
}

/// The limit in front of which nothing may be drawn when the near plane has been moved nearer.
std::optional<NearLimit> nearLimitOf(const Plane& plane, const CameraModel& camera) {
  if (sharesNearPlane(plane, camera)) return std::nullopt;
  if (!camera.hasNearPlane()) return NearLimit{Eigen::Vector3d::Zero(), camera.near()};
  return NearLimit{plane.X_CF.linear().row(2), camera.near()};
}

Tiles addTiles(const Plane& plane, const CameraModel& camera, std::vector<LensFace>& faces) {
  Tiles tiles;
  tiles.focal_length = focalLengthOf(plane, camera);
  const double f = tiles.focal_length;
  tiles.across = cutInto(f * plane.left, f * plane.right);
  tiles.down = cutInto(f * plane.top, f * plane.bottom);
  tiles.first_face = static_cast<int>(faces.size());
  for (int row = 0; row < tiles.down.count; ++row) {
    for (int column = 0; column < tiles.across.count; ++column) {
      const double left = tiles.across.first + column * tiles.across.length - kFilterMargin;
      const double top = tiles.down.first + row * tiles.down.length - kFilterMargin;
      const CameraModel tile(tiles.across.length + 2 * kFilterMargin,
                             tiles.down.length + 2 * kFilterMargin, {f, f, -left, -top},
                             nearOf(plane, camera), camera.far());
      faces.push_back({tile, plane.X_CF, nearLimitOf(plane, camera)});
    }
  }
  return tiles;
}

/// The pixels that look at each face.
std::vector<RayGrid> gridsOf(const LensMap& map) {
  std::vector<std::vector<PlacedRay>> rays(map.faces.size());
  std::vector<FacePlane> planes;
  for (const LensFace& face : map.faces) planes.emplace_back(face);
  for (int v = 0; v < map.face.rows; ++v) {
    for (int u = 0; u < map.face.cols; ++u) {
      const auto face = map.face.at<std::int16_t>(v, u);
      if (face < 0) continue;
      const auto i = static_cast<std::size_t>(face);
      const Eigen::Vector2f place = planes[i].placeOf(map.rays.at<cv::Vec3f>(v, u));
      rays[i].push_back({place.x(), place.y(), v * map.face.cols + u});
    }
  }
  std::vector<RayGrid> grids;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const CameraModel& camera = map.faces[i].camera;
    const cv::Size cells(static_cast<int>(camera.width() / kDensity) + 1,
                         static_cast<int>(camera.height() / kDensity) + 1);
    grids.push_back(makeRayGrid(intrinsicsInCells(map.faces[i]), cells, rays[i]));
  }
  return grids;
}

}  // namespace

Intrinsics intrinsicsInCells(const LensFace& face) {
  const Intrinsics& k = face.camera.intrinsics();
  return {k.fx / kDensity, k.fy / kDensity, k.cx / kDensity, k.cy / kDensity};
}

bool hasDistortion(const CameraModel& camera) {
  constexpr double kHalfPi = 1.5707963;
  return camera.distortion().model != DistortionModel::kNone || camera.largestAngle() < kHalfPi;
}

int neighbourSide(const LensMap& map, const Pose& X_CF, int u, int v, int du, int dv) {
  // Pixels look at a plane down to a cosine of 0.58; much below, places on it say nothing about the
  // pixel.
  constexpr double kLeastCosine = 0.25;
  const cv::Rect image(cv::Point(), map.face.size());
  for (const int side : {1, -1}) {
    const cv::Point neighbour(u + side * du, v + side * dv);
    if (!image.contains(neighbour) || map.face.at<std::int16_t>(neighbour) < 0) continue;
    const Eigen::Vector3d ray = vectorOf(map.rays.at<cv::Vec3f>(neighbour));
    if (X_CF.linear().col(2).dot(ray) > kLeastCosine) return side;
  }
  return 0;
}

LensMap makeLensMap(const CameraModel& camera) {
  LensMap map = lookAlongRays(camera);
  const bool one_plane = fitsOnePlane(map);
  std::vector<Plane> planes = one_plane ? std::vector<Plane>(1) : cubePlanes();
  const auto planeOf = [&](int v, int u) {
    return one_plane ? 0 : cubeSide(map.rays.at<cv::Vec3f>(v, u));
  };
  for (int v = 0; v < map.face.rows; ++v) {
    for (int u = 0; u < map.face.cols; ++u) {
      if (map.face.at<std::int16_t>(v, u) < 0) continue;
      measure(map, u, v, planes[static_cast<std::size_t>(planeOf(v, u))]);
    }
  }
  std::vector<Tiles> tiles(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].used()) tiles[i] = addTiles(planes[i], camera, map.faces);
  }
  for (int v = 0; v < map.face.rows; ++v) {
    for (int u = 0; u < map.face.cols; ++u) {
      auto& face = map.face.at<std::int16_t>(v, u);
      if (face < 0) continue;
      const auto i = static_cast<std::size_t>(planeOf(v, u));
      const Eigen::Vector2d place =
          tiles[i].focal_length * meet(planes[i], map.rays.at<cv::Vec3f>(v, u));
      face = static_cast<std::int16_t>(tiles[i].first_face +
                                       tiles[i].down.tileOf(place.y()) * tiles[i].across.count +
                                       tiles[i].across.tileOf(place.x()));
    }
  }
  map.is_pinhole = !hasDistortion(camera);
  map.grids = gridsOf(map);
  return map;
}

}  // namespace synthetic_dataset::render
