#include "plugins/pvnet/pvnet_pose.h"

#include <cstring>

#include <Eigen/Core>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace {

using Matrix = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
constexpr std::size_t kMatrixBytes = 12 * sizeof(double);

/// Version 1.0 of numpy.lib.format, with the dictionary's length in two bytes. The numbers begin at
/// a multiple of 64 bytes.
std::string header() {
  constexpr std::size_t kDictionaryBytes = 118;
  std::string dictionary = "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }";
  dictionary.resize(kDictionaryBytes - 1, ' ');
  return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(kDictionaryBytes) + '\0' +
         dictionary + '\n';
}

}  // namespace

std::string numpyPose(const Pose& pose) {
  const Matrix matrix = pose.matrix().topRows<3>();
  std::string numbers(kMatrixBytes, '\0');
  std::memcpy(numbers.data(), matrix.data(), kMatrixBytes);
  return header() + numbers;
}

Pose poseOfNumpy(const std::string& bytes) {
  if (bytes.size() < kMatrixBytes) throw Error("found no 3 x 4 numbers");
  Matrix matrix;
  std::memcpy(matrix.data(), bytes.data() + bytes.size() - kMatrixBytes, kMatrixBytes);
  Pose pose = Pose::Identity();
  pose.matrix().topRows<3>() = matrix;
  return pose;
}

}  // namespace synthetic_dataset
