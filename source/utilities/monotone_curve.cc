// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/exceptions.h>

#include <lahar/utilities/monotone_curve.h>

#include <algorithm>

namespace Lahar
{
  MonotoneCurve::MonotoneCurve(const std::vector<double> &x, const std::vector<double> &y, const double slope)
    : x(x)
    , y(y)
    , slopes(x.size(), slope)
  {
    Assert(!x.empty() && x.size() == y.size(), dealii::ExcMessage("Points of a curve."));
    if (x.size() == 1)
      return;
    const auto length = [&](const unsigned int i) { return x[i + 1] - x[i]; };
    const auto chord  = [&](const unsigned int i) { return (y[i + 1] - y[i]) / length(i); };
    slopes.front()    = chord(0);
    slopes.back()     = chord(x.size() - 2);
    for (unsigned int i = 1; i + 1 < x.size(); ++i)
    {
      // The harmonic mean of both chords, the longer one weighing less.
      const double before = length(i - 1) + 2. * length(i), after = 2. * length(i - 1) + length(i);
      slopes[i] = (before + after) / (before / chord(i - 1) + after / chord(i));
    }
  }



  std::pair<double, double> MonotoneCurve::operator()(const double at) const
  {
    if (at <= x.front())
      return {y.front() + slopes.front() * (at - x.front()), slopes.front()};
    if (at >= x.back())
      return {y.back() + slopes.back() * (at - x.back()), slopes.back()};
    const unsigned int i = std::upper_bound(x.begin(), x.end(), at) - x.begin() - 1;
    const double length = x[i + 1] - x[i], chord = (y[i + 1] - y[i]) / length, t = (at - x[i]) / length;
    // y_i + h (t s_i + t² a + t³ b), b = s_i + s_{i+1} − 2 chord, a = chord − s_i − b.
    const double cubic = slopes[i] + slopes[i + 1] - 2. * chord, square = chord - slopes[i] - cubic;
    return {y[i] + length * t * (slopes[i] + t * (square + t * cubic)),
            slopes[i] + t * (2. * square + t * 3. * cubic)};
  }
} // namespace Lahar
