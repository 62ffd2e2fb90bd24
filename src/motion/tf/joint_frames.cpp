#include "motion/tf/joint_frames.h"

#include <algorithm>
#include <map>

namespace synthetic_dataset::motion {
namespace {

using Positions = std::map<std::string, double>;

/// A joint's displacement from its rest position [m] or [rad].
std::optional<double> displacementOf(const JointedLink& link, const Positions& positions) {
  const auto own = positions.find(link.joint);
  if (own != positions.end()) return own->second - link.rest;
  if (!link.mimic) return std::nullopt;
  const auto other = positions.find(link.mimic->joint);
  if (other == positions.end()) return std::nullopt;
  return link.mimic->multiplier * other->second + link.mimic->offset - link.rest;
}

Pose displaced(const JointedLink& link, double by) {
  if (link.slides) return makePose(by * link.axis_L, Eigen::Quaterniond::Identity());
  return makePose(Eigen::Vector3d::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(by, link.axis_L)));
}

geometry_msgs::Transform messageOf(const Pose& X_AB) {
  const Eigen::Vector3d p = X_AB.translation();
  const Eigen::Quaterniond q(X_AB.linear());
  geometry_msgs::Transform transform;
  transform.translation.x = p.x();
  transform.translation.y = p.y();
  transform.translation.z = p.z();
  transform.rotation.x = q.x();
  transform.rotation.y = q.y();
  transform.rotation.z = q.z();
  transform.rotation.w = q.w();
  return transform;
}

}  // namespace

JointFrames::JointFrames(const JointedRobot& robot, const std::set<std::string>& positions)
    : robot_(robot), positions_(positions) {
  if (robot_.own_link) {
    visit(*robot_.own_link, std::nullopt, robot_.frame, Pose::Identity());
    return;
  }
  for (std::size_t i = 0; i < robot_.links.size(); ++i) {
    if (robot_.links[i].parent) continue;
    visit(i, std::nullopt, robot_.frame, robot_.links[i].X_PL);
  }
}

bool JointFrames::isMoved(const JointedLink& link) const {
  if (link.joint.empty()) return false;
  return positions_.count(link.joint) != 0 ||
         (link.mimic && positions_.count(link.mimic->joint) != 0);
}

/// Visits all links that are connected to a link by joints, except the one from which it came.
void JointFrames::visit(std::size_t link, std::optional<std::size_t> came_from,
                        const std::string& anchor, const Pose& X_AL) {
  const JointedLink& here = robot_.links[link];
  if (here.parent && here.parent != came_from) {
    const std::string& up = robot_.links[*here.parent].frame;
    const Pose X_LP = here.X_PL.inverse();
    if (isMoved(here)) {
      steps_.push_back({anchor, up, X_AL, link, true, X_LP});
      visit(*here.parent, link, up, Pose::Identity());
    } else {
      visit(*here.parent, link, anchor, X_AL * X_LP);
    }
  }
  for (std::size_t i = 0; i < robot_.links.size(); ++i) {
    const JointedLink& child = robot_.links[i];
    if (child.parent != link || i == came_from) continue;
    if (isMoved(child)) {
      steps_.push_back({anchor, child.frame, X_AL * child.X_PL, i, false});
      visit(i, link, child.frame, Pose::Identity());
    } else {
      visit(i, link, anchor, X_AL * child.X_PL);
    }
  }
}

std::vector<std::string> JointFrames::frames() const {
  std::vector<std::string> names;
  for (const Step& step : steps_) names.push_back(step.to);
  return names;
}

std::vector<geometry_msgs::TransformStamped> JointFrames::transforms(
    const sensor_msgs::JointState& message) const {
  Positions positions;
  const std::size_t count = std::min(message.name.size(), message.position.size());
  for (std::size_t i = 0; i < count; ++i) positions[message.name[i]] = message.position[i];
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const Step& step : steps_) {
    const JointedLink& link = robot_.links[step.link];
    const auto by = displacementOf(link, positions);
    if (!by) continue;
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = message.header.stamp;
    transform.header.frame_id = step.from;
    transform.child_frame_id = step.to;
    transform.transform =
        messageOf(step.before * displaced(link, step.is_upwards ? -*by : *by) * step.after);
    transforms.push_back(transform);
  }
  return transforms;
}

}  // namespace synthetic_dataset::motion
