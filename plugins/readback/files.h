#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

/// Reading small files, with errors that name them.
namespace synthetic_dataset::formats {

/// @throws Error if it cannot be read
[[nodiscard]] std::string readText(const std::filesystem::path& file);

/// The non-empty lines of a file.
[[nodiscard]] std::vector<std::string> readLines(const std::filesystem::path& file);

[[nodiscard]] std::vector<std::string> wordsOf(const std::string& line);

/// Joins words with spaces.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

/// The index of a line's first coordinate, after an id of several words that may contain decimal
/// points as well. Coordinates have five decimals, and come in groups of `group`.
/// @param shortest_id  [words]
/// @throws Error naming the file and a word among the coordinates that is not a number
[[nodiscard]] std::size_t firstCoordinate(const std::vector<std::string>& words,
                                          std::size_t shortest_id, std::size_t group,
                                          const std::filesystem::path& file);

/// @throws Error if the word is not a number
[[nodiscard]] double numberOf(const std::string& word, const std::filesystem::path& file);

/// @param mode  cv::ImreadModes
/// @throws Error if there is no such picture
[[nodiscard]] cv::Mat readPicture(const std::filesystem::path& file, int mode);

}  // namespace synthetic_dataset::formats
