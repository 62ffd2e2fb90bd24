#include "readback/files.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include <opencv2/imgcodecs.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::readback {

std::string readText(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("'" + file.string() + "': cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> readLines(const std::filesystem::path& file) {
  std::istringstream stream(readText(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

double numberOf(const std::string& word, const std::filesystem::path& file) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (stream >> number && stream.eof()) return number;
  throw Error("'" + file.string() + "': found '" + word + "'; it should be a number");
}

cv::Mat readPicture(const std::filesystem::path& file, int mode) {
  cv::Mat picture = cv::imread(file.string(), mode);
  if (picture.empty()) throw Error("'" + file.string() + "': no such picture");
  return picture;
}

}  // namespace synthetic_dataset::readback
