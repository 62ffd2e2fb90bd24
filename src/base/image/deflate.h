#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// A zlib stream (RFC 1950) of an image's bytes, the same for the same bytes: by ISA-L or
/// libdeflate; by zlib, in several times their time, where this was built without them.
/// @param bytes  CV_8UC1, without gaps between rows
/// @param compression  0 and 1 ISA-L, fastest; 2 .. 9 libdeflate, smallest
/// @throws Error when there is no memory for it, or a library refuses it
[[nodiscard]] std::vector<uchar> deflated(const cv::Mat& bytes, int compression);

/// The checksum of PNG (ISO/IEC 15948, annex D), going on from that of the bytes before.
[[nodiscard]] std::uint32_t crc32(std::uint32_t sum, const uchar* bytes, std::size_t size);

/// Names and versions of the libraries on which the bytes of a stream depend.
[[nodiscard]] std::map<std::string, std::string> deflateLibraries();

}  // namespace synthetic_dataset::base
