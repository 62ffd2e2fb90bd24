#include "randomize/appearance/variety/shape_change.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::randomize {
namespace {

constexpr double kFlat = 1e-9;  // [m]: lower models are treated as flat

/// A factor between two limits, log-uniform.
double drawFactor(base::RandomSource& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

double overlapInHeight(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  return std::min(a.max().z(), b.max().z()) - std::max(a.min().z(), b.min().z());
}

/// Finds pieces above or below all other large ones, near the model's middle: a cone's foot, a lid.
/// They can become wider or narrower than the others without being torn off or swallowed.
std::vector<bool> stackedPieces(const ModelParts& parts) {
  constexpr double kSmallShare = 0.02;  // of the model's area
  constexpr double kMiddle = 0.1;       // of the model's width
  constexpr double kTouching = 0.5;     // of the lower one's height
  const Eigen::Vector3d size = parts.box_M.sizes();
  std::vector<bool> stacked;
  for (const MeshPiece& piece : parts.pieces) {
    const Eigen::Vector3d off = piece.box_M.center() - parts.box_M.center();
    bool is_stacked = piece.area > kSmallShare * parts.area &&
                      off.head<2>().norm() < kMiddle * size.head<2>().maxCoeff();
    for (const MeshPiece& other : parts.pieces) {
      if (&other == &piece || other.area < kSmallShare * parts.area) continue;
      const double lower = std::min(piece.box_M.sizes().z(), other.box_M.sizes().z());
      is_stacked = is_stacked && overlapInHeight(piece.box_M, other.box_M) <= kTouching * lower;
    }
    stacked.push_back(is_stacked && piece.box_M.sizes().z() < 0.95 * size.z());
  }
  return stacked;
}

std::shared_ptr<const world::Mesh> meshOf(const world::Shape& shape) {
  struct Maker {
    std::shared_ptr<const world::Mesh> operator()(const world::BoxShape& box) const {
      return world::boxMesh(box.size);
    }
    std::shared_ptr<const world::Mesh> operator()(const world::SphereShape& sphere) const {
      return world::sphereMesh(sphere.radius);
    }
    std::shared_ptr<const world::Mesh> operator()(const world::CylinderShape& cylinder) const {
      return world::cylinderMesh(cylinder.radius, cylinder.length);
    }
    std::shared_ptr<const world::Mesh> operator()(const world::PlaneShape& /*infinite*/) const {
      return nullptr;
    }
    std::shared_ptr<const world::Mesh> operator()(const world::MeshShape& mesh) const {
      return mesh.mesh;
    }
  };
  return std::visit(Maker{}, shape);
}

}  // namespace

ShapeChange::ShapeChange(const ModelParts& parts, const std::vector<HeightLevel>& levels,
                         base::RandomSource& random) {
  own_widths_.assign(parts.pieces.size(), 1.0);
  for (const MeshPiece& piece : parts.pieces) boxes_M_.push_back(piece.box_M);
  if (!parts.box_M.isEmpty()) axis_ = parts.box_M.center().head<2>();
  drawWidths(parts, random);
  drawFlanges(levels, random);
  drawHeights(parts, levels, random);
}

/// Finds the lowest and the highest level if they are wider than their neighbours. Only the
/// protruding part is scaled, from where it starts, so that nothing tears.
void ShapeChange::drawFlanges(const std::vector<HeightLevel>& levels, base::RandomSource& random) {
  const double foot = drawFactor(random, 0.65, 2.4);
  const double head = drawFactor(random, 0.65, 1.6);
  if (levels.size() < 2) return;
  const HeightLevel& first = levels.front();
  const HeightLevel& last = levels.back();
  const double border = 1e-3 * (last.high - first.low);
  if (first.top_radius > levels[1].foot_radius) {
    flanges_.push_back({first.low, first.high + border, levels[1].foot_radius, foot});
  }
  const double below = levels[levels.size() - 2].top_radius;
  if (last.foot_radius > below) flanges_.push_back({last.low - border, last.high, below, head});
  // In combination, both could make a foot narrower than what it carries.
  if (!flanges_.empty()) own_widths_.assign(own_widths_.size(), 1.0);
}

/// The factor on a point's distance from the axis.
double ShapeChange::flangeAt(const Eigen::Vector3d& p_M) const {
  const double radius = (p_M.head<2>() - axis_).norm();
  for (const Flange& flange : flanges_) {
    const bool reaches_out =
        radius > flange.radius && p_M.z() >= flange.low - kFlat && p_M.z() <= flange.high + kFlat;
    if (reaches_out) return (flange.radius + flange.factor * (radius - flange.radius)) / radius;
  }
  return 1.0;
}

void ShapeChange::drawWidths(const ModelParts& parts, base::RandomSource& random) {
  // What is round stays nearly round.
  const double width = drawFactor(random, 0.75, 1.6);
  width_ = {width * random.uniform(0.97, 1.03), width * random.uniform(0.97, 1.03)};
  taper_ = random.uniform(-0.22, 0.22) * random.unit();  // mostly small
  bulge_ = random.uniform(-0.1, 0.1);
  const std::vector<bool> stacked = stackedPieces(parts);
  for (std::size_t i = 0; i < stacked.size(); ++i) {
    const double own = drawFactor(random, 0.85, 1.22);
    if (stacked[i]) own_widths_[i] = own;
  }
}

/// The borders of stacked pieces are knots, so that each piece has its own change of height.
void ShapeChange::drawHeights(const ModelParts& parts, const std::vector<HeightLevel>& levels,
                              base::RandomSource& random) {
  const double height = drawFactor(random, kLowest, kHighest);
  const double low = parts.box_M.isEmpty() ? 0.0 : parts.box_M.min().z();
  const double high = std::max(parts.box_M.isEmpty() ? 1.0 : parts.box_M.max().z(), low + kFlat);
  std::vector<double> borders = {low, high};
  for (const HeightLevel& level : levels) borders.push_back(level.high);
  const std::vector<bool> stacked = stackedPieces(parts);
  for (std::size_t i = 0; i < stacked.size(); ++i) {
    if (!stacked[i]) continue;
    borders.push_back(parts.pieces[i].box_M.min().z());
    borders.push_back(parts.pieces[i].box_M.max().z());
  }
  borders.push_back(low + random.uniform(0.3, 0.7) * (high - low));
  std::sort(borders.begin(), borders.end());
  const double apart = 0.02 * (high - low);
  knots_.push_back({low, low});
  for (const double border : borders) {
    if (border < knots_.back().from + apart || (border > high - apart && border < high)) continue;
    const double step = border - knots_.back().from;
    const bool is_small = step < 0.25 * (high - low);
    const double factor = is_small ? drawFactor(random, 0.6, 1.7) : drawFactor(random, 0.85, 1.18);
    knots_.push_back({border, knots_.back().to + factor * step});
  }
  // Scale the total height to what was drawn, about the model's origin, on which it may stand.
  const double drawn = std::max(knots_.back().to - low, kFlat);
  const double scale = height * (high - low) / drawn;
  for (Knot& knot : knots_) knot.to = height * low + scale * (knot.to - low);
}

double ShapeChange::heightAt(double z) const {
  auto above = std::find_if(knots_.begin() + 1, knots_.end(),
                            [&](const Knot& knot) { return z <= knot.from; });
  if (above == knots_.end()) --above;
  const Knot& below = *(above - 1);
  const double slope = (above->to - below.to) / (above->from - below.from);
  return below.to + slope * (z - below.from);
}

double ShapeChange::widthAt(double z) const {
  const double t =
      std::clamp((z - knots_.front().from) / (knots_.back().from - knots_.front().from), 0.0, 1.0);
  return 1.0 + taper_ * (t - 0.5) + bulge_ * (4.0 * t * (1.0 - t) - 0.5);
}

Eigen::Vector3d ShapeChange::moved(const Eigen::Vector3d& p_M, double own_width) const {
  const double width = own_width * flangeAt(p_M) * widthAt(p_M.z());
  const Eigen::Vector2d off = width * (p_M.head<2>() - axis_);
  return {width_.x() * (axis_.x() + off.x()), width_.y() * (axis_.y() + off.y()),
          heightAt(p_M.z())};
}

Eigen::Vector3d ShapeChange::moved(const Eigen::Vector3d& p_M) const {
  double own_width = 1.0;
  for (std::size_t i = 0; i < boxes_M_.size(); ++i) {
    if (own_widths_[i] != 1.0 && boxes_M_[i].contains(p_M)) own_width = own_widths_[i];
  }
  return moved(p_M, own_width);
}

/// Moves a mesh vertex by vertex. Its triangles stay flat, so a normal turns according to the
/// height range of the triangles around it: the derivatives are slopes over that range.
std::shared_ptr<const world::Mesh> ShapeChange::changed(const world::Mesh& mesh,
                                                        const SurfacePart& part) const {
  struct Reach {
    double low;
    double high;
  };
  std::vector<Reach> reach;
  for (const Eigen::Vector3d& p : part.p_M) reach.push_back({p.z(), p.z()});
  for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
    double low = part.p_M[mesh.indices[k]].z();
    double high = low;
    for (std::size_t i = 1; i < 3; ++i) {
      low = std::min(low, part.p_M[mesh.indices[k + i]].z());
      high = std::max(high, part.p_M[mesh.indices[k + i]].z());
    }
    for (std::size_t i = 0; i < 3; ++i) {
      Reach& each = reach[mesh.indices[k + i]];
      each = {std::min(each.low, low), std::max(each.high, high)};
    }
  }
  const double least = 1e-4 * (knots_.back().from - knots_.front().from);
  auto result = std::make_shared<world::Mesh>(mesh);
  const Pose X_VM = part.X_MV.inverse();
  for (std::size_t i = 0; i < part.p_M.size(); ++i) {
    const Eigen::Vector3d& p = part.p_M[i];
    const double piece = own_widths_[part.piece[i]];
    const double own = piece * flangeAt(p);
    result->positions[i] = (X_VM * moved(p, piece)).cast<float>();
    const double low = std::min(reach[i].low, p.z() - least);
    const double high = std::max(reach[i].high, p.z() + least);
    const double rise = (heightAt(high) - heightAt(low)) / (high - low);
    const double widening = own * (widthAt(high) - widthAt(low)) / (high - low);
    // The Jacobian of the movement; a normal is transformed by its inverse transpose.
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (Eigen::Index k = 0; k < 2; ++k) {
      jacobian(k, k) = width_[k] * own * widthAt(p.z());
      jacobian(k, 2) = width_[k] * widening * (p[k] - axis_[k]);
    }
    jacobian(2, 2) = rise;
    const Eigen::Vector3d n_M = part.X_MV.linear() * mesh.normals[i].cast<double>();
    const Eigen::Vector3d turned = jacobian.inverse().transpose() * n_M;
    result->normals[i] = (X_VM.linear() * turned.normalized()).cast<float>();
  }
  return result;
}

void ShapeChange::change(const Pose& X_MC, world::Shape& shape) const {
  const std::shared_ptr<const world::Mesh> mesh = meshOf(shape);
  if (!mesh || mesh->positions.empty()) return;
  auto result = std::make_shared<world::Mesh>(*mesh);
  const Pose X_CM = X_MC.inverse();
  for (Eigen::Vector3f& p : result->positions) {
    p = (X_CM * moved(X_MC * p.cast<double>())).cast<float>();
  }
  shape = world::MeshShape{std::move(result)};
}

void ShapeChange::apply(const ModelParts& parts, world::Model& model) const {
  for (const SurfacePart& part : parts.surfaces) {
    world::Surface& surface = surfaceOf(model, part);
    surface.mesh = changed(*surface.mesh, part);
  }
  const double height =
      (knots_.back().to - knots_.front().to) / (knots_.back().from - knots_.front().from);
  const double volume = width_.x() * width_.y() * height;
  for (world::Link& link : model.links) {
    for (world::Collision& collision : link.collisions) {
      change(link.X_ML * collision.X_LC, collision.shape);
    }
    if (!link.inertia) continue;
    // Approximately those of a body with the same density.
    link.inertia->mass *= volume;
    link.inertia->centre_of_mass_L =
        link.X_ML.inverse() * moved(link.X_ML * link.inertia->centre_of_mass_L);
    link.inertia->moments_L *= volume * std::pow(volume, 2.0 / 3.0);
  }
}

}  // namespace synthetic_dataset::randomize
