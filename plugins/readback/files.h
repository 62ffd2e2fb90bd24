#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

/// Reading small files, with errors that name them.
namespace synthetic_dataset::formats {

/// @throws Error when it cannot be read
[[nodiscard]] std::string readText(const std::filesystem::path& file);

/// The lines that are not empty.
[[nodiscard]] std::vector<std::string> readLines(const std::filesystem::path& file);

[[nodiscard]] std::vector<std::string> wordsOf(const std::string& line);

/// Words with a space between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

/// Where a line's coordinates begin, behind an id of several words, which may have points as well.
/// Coordinates have five decimals, and come in groups of so many.
/// @param shortest_id  [words]
/// @throws Error naming the file and a word among coordinates that is no number
[[nodiscard]] std::size_t firstCoordinate(const std::vector<std::string>& words,
                                          std::size_t shortest_id, std::size_t group,
                                          const std::filesystem::path& file);

/// @throws Error when the word is no number
[[nodiscard]] double numberOf(const std::string& word, const std::filesystem::path& file);

/// @param mode  cv::ImreadModes
/// @throws Error when there is no such picture
[[nodiscard]] cv::Mat readPicture(const std::filesystem::path& file, int mode);

}  // namespace synthetic_dataset::formats
