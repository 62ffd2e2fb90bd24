#pragma once

#include <string>
#include <vector>

/// Arrays of doubles in NumPy's file format, version 1.0.
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
namespace synthetic_dataset {

/// The bytes of a file that numpy.load reads as an array of these rows, of equal length.
[[nodiscard]] std::string numpyArray(const std::vector<std::vector<double>>& rows);

/// The numbers of such a file, row by row.
/// @param bytes  as numpyArray made them
[[nodiscard]] std::vector<double> numbersOfNumpyArray(const std::string& bytes);

}  // namespace synthetic_dataset
