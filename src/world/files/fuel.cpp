#include "world/files/fuel.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <system_error>

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

bool isNumber(const std::string& text) {
  constexpr std::size_t kMostDigits = 9;
  return !text.empty() && text.size() <= kMostDigits &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, '/');) {
    if (!part.empty()) parts.push_back(percentDecoded(part));
  }
  return parts;
}

/// The names by which caches may know a server: it has moved once, and caches and URIs use both
/// names; its web page has a third.
std::vector<std::string> namesOf(const std::string& server) {
  std::vector<std::string> names;
  if (server != "app.gazebosim.org" && server != "app.ignitionrobotics.org") {
    names.push_back(server);
  }
  for (const char* name : {"fuel.gazebosim.org", "fuel.ignitionrobotics.org"}) {
    if (server != name) names.emplace_back(name);
  }
  return names;
}

/// The subfolder with the highest number as its name.
std::string newestVersion(const fs::path& folder) {
  std::string newest;
  std::error_code error;
  for (fs::directory_iterator each(folder, error); !error && each != fs::directory_iterator();
       each.increment(error)) {
    const std::string name = each->path().filename().string();
    if (isNumber(name) && (newest.empty() || std::stol(name) > std::stol(newest))) newest = name;
  }
  return newest;
}

}  // namespace

std::string percentDecoded(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool code = text[i] == '%' && i + 2 < text.size() &&
                      std::isxdigit(static_cast<unsigned char>(text[i + 1])) != 0 &&
                      std::isxdigit(static_cast<unsigned char>(text[i + 2])) != 0;
    if (code) {
      result += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

std::optional<FuelUri> parseFuelUri(const std::string& uri) {
  const std::size_t scheme_end = uri.find("://");
  if (scheme_end == std::string::npos) return std::nullopt;
  const std::string scheme = uri.substr(0, scheme_end);
  if (scheme != "https" && scheme != "http" && scheme != "fuel") return std::nullopt;
  const std::vector<std::string> parts = split(uri.substr(scheme_end + 3));
  const auto kind = std::find_if(parts.begin(), parts.end(), [](const std::string& part) {
    return part == "models" || part == "worlds";
  });
  if (kind == parts.end() || kind + 1 == parts.end() || kind - parts.begin() < 2) {
    return std::nullopt;
  }
  FuelUri result;
  result.server = lowerCase(parts.front());
  const bool web_page = *(kind - 1) == "fuel" && kind - parts.begin() > 2;
  result.owner = *(kind - (web_page ? 2 : 1));
  if (result.owner == "1.0") return std::nullopt;  // the version of the API
  result.kind = *kind;
  auto next = kind + 1;
  result.name = *next++;
  if (next != parts.end() && (isNumber(*next) || *next == "tip")) {
    result.version = *next == "tip" ? "" : *next;
    ++next;
  }
  if (next != parts.end() && *next == "files") ++next;
  for (; next != parts.end(); ++next) result.path += (result.path.empty() ? "" : "/") + *next;
  return result;
}

std::vector<fs::path> fuelCaches() {
  std::vector<fs::path> caches;
  for (const char* variable : {"GZ_FUEL_CACHE_PATH", "IGN_FUEL_CACHE_PATH"}) {
    const char* folder = std::getenv(variable);
    if (folder != nullptr && *folder != '\0') caches.emplace_back(folder);
  }
  if (const char* home = std::getenv("HOME")) {
    caches.push_back(fs::path(home) / ".gz/fuel");
    caches.push_back(fs::path(home) / ".ignition/fuel");
  }
  return caches;
}

std::vector<fs::path> fuelPlaces(const FuelUri& uri, const std::vector<fs::path>& caches) {
  std::vector<fs::path> places;
  for (const fs::path& cache : caches) {
    for (const std::string& server : namesOf(uri.server)) {
      const fs::path folder =
          cache / server / lowerCase(uri.owner) / uri.kind / lowerCase(uri.name);
      const std::string version = uri.version.empty() ? newestVersion(folder) : uri.version;
      const fs::path model = version.empty() ? folder : folder / version;
      places.push_back(uri.path.empty() ? model : model / uri.path);
    }
  }
  return places;
}

}  // namespace synthetic_dataset::world
