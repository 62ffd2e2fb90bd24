#include "world/mesh/skin_pose.h"

#include "world/mesh/assimp_conversions.h"

namespace synthetic_dataset::world {
namespace {

Eigen::Vector3d toEigen(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// The transform given by a node's first keys.
Eigen::Affine3d firstKeyOf(const aiNodeAnim& channel) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  if (channel.mNumPositionKeys > 0) result.translate(toEigen(channel.mPositionKeys[0].mValue));
  if (channel.mNumRotationKeys > 0) {
    const aiQuaternion& q = channel.mRotationKeys[0].mValue;
    result.rotate(Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized());
  }
  if (channel.mNumScalingKeys > 0) result.scale(toEigen(channel.mScalingKeys[0].mValue));
  return result;
}

}  // namespace

SkinPose::SkinPose(const aiScene& skin, const aiScene& animation) {
  for (unsigned i = 0; i < animation.mNumAnimations; ++i) {
    const aiAnimation& moves = *animation.mAnimations[i];
    for (unsigned j = 0; j < moves.mNumChannels; ++j) {
      const aiNodeAnim& channel = *moves.mChannels[j];
      keys_.emplace(channel.mNodeName.C_Str(), firstKeyOf(channel));
    }
  }
  place(*skin.mRootNode, Eigen::Affine3d::Identity());
}

void SkinPose::place(const aiNode& node, const Eigen::Affine3d& parent) {
  const auto key = keys_.find(node.mName.C_Str());
  const Eigen::Affine3d transform =
      parent * (key != keys_.end() ? key->second : affineOf(node.mTransformation));
  nodes_.emplace(node.mName.C_Str(), transform);
  for (unsigned i = 0; i < node.mNumChildren; ++i) place(*node.mChildren[i], transform);
}

std::vector<Eigen::Affine3d> SkinPose::displacements(const aiMesh& mesh) const {
  if (!mesh.HasBones()) return {};
  std::vector<Eigen::Matrix4d> sums(mesh.mNumVertices, Eigen::Matrix4d::Zero());
  for (unsigned i = 0; i < mesh.mNumBones; ++i) {
    const aiBone& bone = *mesh.mBones[i];
    const auto node = nodes_.find(bone.mName.C_Str());
    if (node == nodes_.end()) continue;
    const Eigen::Affine3d displacement = node->second * affineOf(bone.mOffsetMatrix);
    for (unsigned j = 0; j < bone.mNumWeights; ++j) {
      const aiVertexWeight& weight = bone.mWeights[j];
      if (weight.mVertexId >= sums.size()) continue;
      sums[weight.mVertexId] += static_cast<double>(weight.mWeight) * displacement.matrix();
    }
  }
  std::vector<Eigen::Affine3d> result;
  for (const Eigen::Matrix4d& sum : sums) {
    // Weights need not add up to 1, and a vertex may have no bone at all.
    const double weight = sum(3, 3);
    Eigen::Affine3d mean = Eigen::Affine3d::Identity();
    if (weight > 0.0) mean.matrix() = sum / weight;
    result.push_back(mean);
  }
  return result;
}

}  // namespace synthetic_dataset::world
