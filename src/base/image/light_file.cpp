#include "base/image/light_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

namespace synthetic_dataset::base {
namespace {

bool isRadiance(const PictureBytes& file) {
  return file.has(0, "#?RADIANCE") || file.has(0, "#?RGBE");
}

bool isOpenExr(const PictureBytes& file) { return file.has(0, "v/1\x01"); }

// --- Radiance ---

struct Radiance {
  PictureSize size;
  std::size_t pixels = 0;  ///< where they begin
};

/// Reads the line after the header's empty line: "-Y height +X width".
std::optional<Radiance> readRadiance(const PictureBytes& file) {
  std::size_t at = 0;
  while (at < file.size() && !file.has(at, "\n\n")) ++at;
  at += 2;
  std::string line;
  for (; at < file.size() && file.byte(at) != '\n'; ++at) line += static_cast<char>(file.byte(at));
  std::istringstream words(line);
  std::string down;
  std::string right;
  Radiance found;
  words >> down >> found.size.height >> right >> found.size.width;
  if (!words || down != "-Y" || right != "+X") return std::nullopt;
  found.pixels = at + 1;
  return found;
}

/// Four bytes per pixel, or rows in which each channel is run-length encoded by itself.
bool isWholeRadiance(const PictureBytes& file) {
  const std::optional<Radiance> header = readRadiance(file);
  if (!header) return true;
  const auto& [width, height] = header->size;
  std::uint64_t at = header->pixels;
  for (std::uint64_t row = 0; row < height; ++row) {
    const bool is_packed =
        width >= 8 && width <= 0x7FFF && file.big(at, 2) == 0x0202 && file.big(at + 2, 2) == width;
    if (!is_packed) return at + (height - row) * width * 4 <= file.size();
    at += 4;
    for (int channel = 0; channel < 4; ++channel) {
      for (std::uint64_t done = 0; done < width;) {
        if (at >= file.size()) return false;
        const std::uint64_t head = file.byte(at);
        const bool is_run = head > 128;
        done += is_run ? head - 128 : head;
        at += is_run ? 2 : 1 + head;
      }
    }
  }
  return at <= file.size();
}

// --- OpenEXR ---

std::string readText(const PictureBytes& file, std::size_t& at) {
  std::string text;
  for (; file.byte(at) != 0; ++at) text += static_cast<char>(file.byte(at));
  ++at;
  return text;
}

/// Calls `visit` with the name of each attribute of the header, and where its value begins.
/// @return where the header ends
template <class Visit>
std::size_t readHeader(const PictureBytes& file, Visit visit) {
  std::size_t at = 8;
  while (at < file.size()) {
    const std::string name = readText(file, at);
    if (name.empty()) break;
    readText(file, at);  // the value's type
    visit(name, at + 4);
    at += 4 + file.little(at, 4);
  }
  return at;
}

/// The size of the stored pixels: the attribute "dataWindow", a Box2i.
std::optional<PictureSize> exrSize(const PictureBytes& file) {
  std::optional<PictureSize> size;
  readHeader(file, [&](const std::string& name, std::size_t value) {
    if (name != "dataWindow") return;
    const auto corner = [&](std::size_t i) {
      return static_cast<std::int32_t>(static_cast<std::uint32_t>(file.little(value + 4 * i, 4)));
    };
    const std::int64_t width = std::int64_t{corner(2)} - corner(0) + 1;
    const std::int64_t height = std::int64_t{corner(3)} - corner(1) + 1;
    if (width <= 0 || height <= 0) return;
    size = {static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height)};
  });
  return size;
}

/// Chunks of rows or tiles, to which a table after the header points; the first follows the table.
bool isWholeExr(const PictureBytes& file) {
  constexpr std::uint64_t kTiles = 0x200;
  constexpr std::uint64_t kDeepOrParts = 0x1800;
  const std::uint64_t flags = file.little(4, 4);
  if ((flags & kDeepOrParts) != 0) return true;
  // A chunk begins with its position in the picture, followed by its size.
  const std::uint64_t where = (flags & kTiles) != 0 ? 16 : 4;
  const std::size_t table = readHeader(file, [](const std::string&, std::size_t) {});
  std::uint64_t table_end = file.size();
  for (std::uint64_t at = table; at < table_end; at += 8) {
    const std::uint64_t chunk = file.little(at, 8);
    if (chunk <= at || chunk >= file.size()) return false;
    const std::uint64_t pixels = chunk + where + 4;
    if (pixels + file.little(chunk + where, 4) > file.size()) return false;
    table_end = std::min(table_end, chunk);
  }
  return table < table_end && table_end < file.size();
}

}  // namespace

bool isLight(const PictureBytes& file) { return isRadiance(file) || isOpenExr(file); }

std::optional<PictureSize> lightSize(const PictureBytes& file) {
  if (isOpenExr(file)) return exrSize(file);
  const std::optional<Radiance> header = readRadiance(file);
  return header ? std::optional(header->size) : std::nullopt;
}

bool isWholeLight(const PictureBytes& file) {
  return isOpenExr(file) ? isWholeExr(file) : isWholeRadiance(file);
}

}  // namespace synthetic_dataset::base
