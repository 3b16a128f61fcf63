// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_monotone_curve_h
#define lahar_utilities_monotone_curve_h

#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * A curve y(x) through given points with x and y growing from point to point: between them Hermite's cubics with the
   * slopes of Fritsch & Butland (SIAM J. Sci. Stat. Comput. 5 (1984) 300), at the ends the slopes of the chords there,
   * and outside straight lines that go on with these. It has a continuous derivative, grows everywhere, and is a straight
   * line where the points are on one.
   */
  class MonotoneCurve
  {
  public:
    MonotoneCurve() = default;

    /// @param x, y the points, at least one. @param slope that of the curve through a single point.
    MonotoneCurve(const std::vector<double> &x, const std::vector<double> &y, const double slope);

    /// y and dy/dx.
    std::pair<double, double> operator()(const double at) const;

  private:
    std::vector<double> x, y, slopes;
  };
} // namespace Lahar

#endif
