#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// Compresses an image's bytes to a zlib stream (RFC 1950), the same for the same bytes: by ISA-L
/// or libdeflate, or by zlib in a build without them, which takes several times as long.
/// @param bytes  CV_8UC1, without gaps between rows
/// @param compression  0 and 1 ISA-L, fastest; 2 .. 9 libdeflate, smallest
/// @throws Error if memory runs out or a library fails
[[nodiscard]] std::vector<uchar> deflated(const cv::Mat& bytes, int compression);

/// PNG's checksum (ISO/IEC 15948, annex D), continued from that of the preceding bytes.
[[nodiscard]] std::uint32_t crc32(std::uint32_t sum, const uchar* bytes, std::size_t size);

/// Names and versions of the libraries on which the bytes of a stream depend.
[[nodiscard]] std::map<std::string, std::string> deflateLibraries();

}  // namespace synthetic_dataset::base
