#pragma once

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::lens {

/// A function's value and its derivative.
struct Slope {
  double value = 0.0;
  double slope = 0.0;
};

/// Finds where in [0, end] an increasing function with f(0) = 0 reaches a value: by Newton steps,
/// or bisection where they would leave the interval that contains the solution.
/// @param function  gives a Slope
template <class Function>
double solveIncreasing(const Function& function, double wanted, double end) {
  double low = 0.0;
  double high = end;
  double x = std::min(wanted, 0.5 * end);
  for (int i = 0; i < 200 && high - low > 1e-16 * high; ++i) {
    const Slope f = function(x);
    if (f.value == wanted) return x;
    (f.value < wanted ? low : high) = x;
    const double newton = x - (f.value - wanted) / f.slope;
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - x) <= 1e-16 * x) return next;
    x = next;
  }
  return x;
}

}  // namespace synthetic_dataset::lens
