#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <opencv2/core/hal/intrin.hpp>

namespace synthetic_dataset::render {

/// Four numbers that are processed at once (SIMD). Each lane is independent of the others, so that
/// a pixel gets the same value in any lane.
using Lanes = cv::v_float32x4;
inline constexpr int kLaneCount = 4;

[[nodiscard]] inline Lanes lanes(float number) { return cv::v_setall_f32(number); }

/// Four vectors.
struct Lanes3 {
  Lanes x, y, z;
};

[[nodiscard]] inline Lanes3 lanes(float x, float y, float z) {
  return {lanes(x), lanes(y), lanes(z)};
}

[[nodiscard]] inline Lanes3 lanes(const Eigen::Vector3f& vector) {
  return lanes(vector.x(), vector.y(), vector.z());
}

[[nodiscard]] inline Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

[[nodiscard]] inline Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

[[nodiscard]] inline Lanes3 operator*(const Lanes3& a, const Lanes3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

[[nodiscard]] inline Lanes3 operator*(const Lanes3& a, const Lanes& b) {
  return {a.x * b, a.y * b, a.z * b};
}

[[nodiscard]] inline Lanes dot(const Lanes3& a, const Lanes3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline Lanes3 rotated(const Eigen::Matrix3f& rotation, const Lanes3& a) {
  return {dot(lanes(Eigen::Vector3f(rotation.row(0))), a),
          dot(lanes(Eigen::Vector3f(rotation.row(1))), a),
          dot(lanes(Eigen::Vector3f(rotation.row(2))), a)};
}

[[nodiscard]] inline Lanes length(const Lanes3& a) { return cv::v_sqrt(dot(a, a)); }

/// Unit vectors; zero vectors stay zero.
[[nodiscard]] inline Lanes3 normalized(const Lanes3& a) {
  return a * (lanes(1.0F) / cv::v_max(length(a), lanes(1e-12F)));
}

/// `a` where the share is 0, `b` where it is 1.
[[nodiscard]] inline Lanes mix(const Lanes& a, const Lanes& b, const Lanes& share) {
  return a + (b - a) * share;
}

[[nodiscard]] inline Lanes3 mix(const Lanes3& a, const Lanes3& b, const Lanes& share) {
  return {mix(a.x, b.x, share), mix(a.y, b.y, share), mix(a.z, b.z, share)};
}

[[nodiscard]] inline Lanes clamped(const Lanes& a, float low, float high) {
  return cv::v_min(cv::v_max(a, lanes(low)), lanes(high));
}

/// `a` where the mask is set, `b` elsewhere.
[[nodiscard]] inline Lanes3 select(const Lanes& mask, const Lanes3& a, const Lanes3& b) {
  return {cv::v_select(mask, a.x, b.x), cv::v_select(mask, a.y, b.y), cv::v_select(mask, a.z, b.z)};
}

/// e to the power of each, with a relative error of 2e-7, for numbers from -87 to 88; numbers
/// beyond are clamped (S. L. Moshier, Cephes mathematical library, expf).
[[nodiscard]] inline Lanes exponential(const Lanes& power) {
  const Lanes x = clamped(power, -87.0F, 88.0F);
  const cv::v_int32x4 twos = cv::v_round(x * lanes(1.44269504F));
  const Lanes whole = cv::v_cvt_f32(twos);
  // ln 2 in two parts; the product of the first with an integer is exact.
  const Lanes r = x - whole * lanes(0.693359375F) - whole * lanes(-2.12194440e-4F);
  Lanes sum = lanes(1.9875691500e-4F);
  for (const float coefficient :
       {1.3981999507e-3F, 8.3334519073e-3F, 4.1665795894e-2F, 1.6666665459e-1F, 5.0000001201e-1F}) {
    sum = sum * r + lanes(coefficient);
  }
  sum = sum * r * r + r + lanes(1.0F);
  constexpr int kBias = 127;
  const cv::v_int32x4 exponent = (twos + cv::v_setall_s32(kBias)) << 23;
  return sum * cv::v_reinterpret_as_f32(exponent);
}

/// The natural logarithm of each, with a relative error of 2e-7, for numbers from 1e-30 to 1e30;
/// numbers beyond are clamped (Cephes, logf).
[[nodiscard]] inline Lanes logarithm(const Lanes& number) {
  const Lanes x = clamped(number, 1e-30F, 1e30F);
  const cv::v_int32x4 bits = cv::v_reinterpret_as_s32(x);
  // x = fraction * 2^exponent, with a fraction from 0.5 to 1.
  constexpr int kBias = 126;
  Lanes exponent = cv::v_cvt_f32((bits >> 23) - cv::v_setall_s32(kBias));
  Lanes fraction = cv::v_reinterpret_as_f32((bits & cv::v_setall_s32(0x007FFFFF)) |
                                            cv::v_setall_s32(0x3F000000));
  const Lanes is_small = fraction < lanes(0.707106781F);
  exponent = exponent - (lanes(1.0F) & is_small);
  const Lanes m = fraction + (fraction & is_small) - lanes(1.0F);
  Lanes sum = lanes(7.0376836292e-2F);
  for (const float coefficient :
       {-1.1514610310e-1F, 1.1676998740e-1F, -1.2420140846e-1F, 1.4249322787e-1F, -1.6668057665e-1F,
        2.0000714765e-1F, -2.4999993993e-1F, 3.3333331174e-1F}) {
    sum = sum * m + lanes(coefficient);
  }
  const Lanes square = m * m;
  sum = sum * m * square + exponent * lanes(-2.12194440e-4F) - square * lanes(0.5F);
  return m + sum + exponent * lanes(0.693359375F);
}

/// Numbers (0 or more) raised to powers above 0.
[[nodiscard]] inline Lanes power(const Lanes& base, const Lanes& exponent) {
  return exponential(exponent * logarithm(base)) & (base > lanes(0.0F));
}

/// Four pixels of four half floats (IEEE 754 binary16), channel by channel. Subnormal numbers
/// (below 6.1e-5) count as 0.
struct PixelLanes {
  Lanes3 xyz;
  Lanes w;
};

[[nodiscard]] inline Lanes fromHalf(const cv::v_uint32x4& bits) {
  const cv::v_uint32x4 magnitude = (bits & cv::v_setall_u32(0x7FFFU)) << 13;
  const cv::v_uint32x4 sign = (bits & cv::v_setall_u32(0x8000U)) << 16;
  // The exponents' biases are 15 and 127.
  const cv::v_uint32x4 number = magnitude + cv::v_setall_u32((127U - 15U) << 23U);
  const cv::v_uint32x4 is_normal = magnitude >= cv::v_setall_u32(1U << 23U);
  return cv::v_reinterpret_as_f32((number & is_normal) | sign);
}

[[nodiscard]] inline PixelLanes loadHalves(const std::uint16_t* pixels) {
  cv::v_uint32x4 first, second, third, fourth;
  cv::v_expand(cv::v_load(pixels), first, second);
  cv::v_expand(cv::v_load(pixels + 8), third, fourth);
  cv::v_uint32x4 x, y, z, w;
  cv::v_transpose4x4(first, second, third, fourth, x, y, z, w);
  return {{fromHalf(x), fromHalf(y), fromHalf(z)}, fromHalf(w)};
}

/// The nearest half floats, ties to even, of numbers from 0 to 65504.
[[nodiscard]] inline cv::v_uint32x4 halfFrom(const Lanes& numbers) {
  const cv::v_uint32x4 bits = cv::v_reinterpret_as_u32(numbers);
  const cv::v_uint32x4 rebased = bits - cv::v_setall_u32((127U - 15U) << 23U);
  const cv::v_uint32x4 odd = (rebased >> 13) & cv::v_setall_u32(1U);
  const cv::v_uint32x4 rounded = (rebased + cv::v_setall_u32(0xFFFU) + odd) >> 13;
  constexpr float kLeastNormal = 0x1p-14F;
  return rounded & cv::v_reinterpret_as_u32(numbers >= lanes(kLeastNormal));
}

/// The inverse of loadHalves(), with 1 as the fourth channel.
inline void storeHalves(std::uint16_t* pixels, const Lanes3& colours) {
  constexpr std::uint32_t kOne = 0x3C00;
  cv::v_uint32x4 first, second, third, fourth;
  cv::v_transpose4x4(halfFrom(colours.x), halfFrom(colours.y), halfFrom(colours.z),
                     cv::v_setall_u32(kOne), first, second, third, fourth);
  cv::v_store(pixels, cv::v_pack(first, second));
  cv::v_store(pixels + 8, cv::v_pack(third, fourth));
}

}  // namespace synthetic_dataset::render
