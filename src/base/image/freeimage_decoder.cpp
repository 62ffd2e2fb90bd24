#include "base/image/freeimage_decoder.h"

#include <cstring>
#include <memory>
#include <utility>

#include <FreeImage.h>

namespace synthetic_dataset::base {
namespace {

struct Closer {
  void operator()(FIMEMORY* memory) const { FreeImage_CloseMemory(memory); }
  void operator()(FIBITMAP* bitmap) const { FreeImage_Unload(bitmap); }
};
using Memory = std::unique_ptr<FIMEMORY, Closer>;
using Bitmap = std::unique_ptr<FIBITMAP, Closer>;

/// Whether a format is one of those documented as supported. Others are not read: FreeImage's icon
/// reader, for example, allocates as much memory as a broken file asks for.
bool isRead(FREE_IMAGE_FORMAT format) {
  switch (format) {
    case FIF_PNG:
    case FIF_JPEG:
    case FIF_BMP:
    case FIF_TIFF:
    case FIF_WEBP:
    case FIF_TARGA:
    case FIF_GIF:
    case FIF_DDS:
    case FIF_PSD:
    case FIF_HDR:
    case FIF_EXR:
      return true;
    default:
      return false;
  }
}

Bitmap load(const std::vector<std::uint8_t>& file, const std::string& name) {
  // const_cast: FreeImage only reads from it.
  const Memory memory(
      FreeImage_OpenMemory(const_cast<BYTE*>(file.data()), static_cast<DWORD>(file.size())));
  FREE_IMAGE_FORMAT format = FreeImage_GetFileTypeFromMemory(memory.get(), 0);
  if (format == FIF_UNKNOWN) format = FreeImage_GetFIFFromFilename(name.c_str());
  if (!isRead(format) || FreeImage_FIFSupportsReading(format) == FALSE) return nullptr;
  return Bitmap(FreeImage_LoadFromMemory(format, memory.get(), 0));
}

/// Converts to blue, green, red, alpha of 8 bits; 16-bit grey has no direct conversion.
Bitmap toBgra(Bitmap bitmap) {
  if (bitmap && FreeImage_GetImageType(bitmap.get()) == FIT_UINT16) {
    bitmap.reset(FreeImage_ConvertTo8Bits(bitmap.get()));
  }
  return Bitmap(bitmap ? FreeImage_ConvertTo32Bits(bitmap.get()) : nullptr);
}

bool holdsFloats(const Bitmap& bitmap) {
  const FREE_IMAGE_TYPE type = bitmap ? FreeImage_GetImageType(bitmap.get()) : FIT_UNKNOWN;
  return type == FIT_FLOAT || type == FIT_RGBF || type == FIT_RGBAF;
}

/// @param type  OpenCV's type of a pixel
cv::Mat pixelsOf(const Bitmap& bitmap, int type) {
  if (!bitmap || FreeImage_HasPixels(bitmap.get()) == FALSE) return {};
  cv::Mat pixels(static_cast<int>(FreeImage_GetHeight(bitmap.get())),
                 static_cast<int>(FreeImage_GetWidth(bitmap.get())), type);
  for (int row = 0; row < pixels.rows; ++row) {  // FreeImage's first row is the lowest
    std::memcpy(pixels.ptr(row), FreeImage_GetScanLine(bitmap.get(), pixels.rows - 1 - row),
                static_cast<std::size_t>(pixels.cols) * pixels.elemSize());
  }
  return pixels;
}

}  // namespace

cv::Mat decodeWithFreeImage(const std::vector<std::uint8_t>& file, const std::string& name) {
  Bitmap bitmap = load(file, name);
  if (!holdsFloats(bitmap)) return pixelsOf(toBgra(std::move(bitmap)), CV_8UC4);
  return pixelsOf(Bitmap(FreeImage_ConvertToRGBF(bitmap.get())), CV_32FC3);
}

}  // namespace synthetic_dataset::base
