// SPDX-License-Identifier: GPL-3.0-or-later

// Test Anderson's acceleration on fixed-point iterations that diverge or hardly converge by themselves.

#include <lahar/simulator/anderson_acceleration.h>

#include "tests.h"

using namespace Tests;

/// Iterate x ← g(x) with a start of zero. @return the number of evaluations until they change x by less than 1e-10.
template <typename F>
unsigned int iterate(const F &g, const unsigned int depth, const unsigned int size, Vector<double> &x)
{
  AndersonAcceleration acceleration(depth);
  Vector<double> weights(size);
  for (unsigned int i = 0; i < size; ++i)
    weights[i] = 1. + i;
  x.reinit(size);
  for (unsigned int n = 1; n <= 100; ++n)
  {
    const Vector<double> image = g(x);
    Vector<double> difference  = image;
    difference -= x;
    if (difference.l2_norm() < 1e-10)
      return n;
    x = acceleration.next_iterate(x, image, weights);
  }
  return 1000;
}

int main()
{
  const unsigned int size = 4;

  // Linear, with the factors 3, −2, 0.99 and 0.5: n unknowns need n + 1 evaluations, one that confirms and
  // one for round-off.
  const auto linear = [](const Vector<double> &x) {
    const double factors[size] = {3., -2., 0.99, 0.5};
    Vector<double> y(size);
    for (unsigned int i = 0; i < size; ++i)
      y[i] = factors[i] * x[i] + (i + 1.) * (1. - factors[i]);
    return y;
  };
  Vector<double> x;
  const unsigned int n_linear = iterate(linear, size, size, x);
  check("linear iteration ends after n + 3 evaluations", n_linear <= size + 3);
  for (unsigned int i = 0; i < size; ++i)
    check("linear iteration finds the fixed point", x[i] - (i + 1.), 1e-9);

  // x = 3 cos x by itself wanders about.
  const auto cosine = [](const Vector<double> &x) {
    Vector<double> y(x);
    for (double &value : y)
      value = 3. * std::cos(value);
    return y;
  };
  const unsigned int n_cosine = iterate(cosine, 1, 1, x);
  check("nonlinear iteration converges like the secant method", n_cosine < 15);
  check("nonlinear iteration finds a fixed point", x[0] - 3. * std::cos(x[0]), 1e-9);

  // Differences that depend on each other.
  const unsigned int n_dependent = iterate(
    [](const Vector<double> &x) {
      Vector<double> y(size);
      y = 2. * x[0] - 1.;
      return y;
    },
    size, size, x);
  check("dependent differences do no harm", n_dependent <= 5 && std::abs(x[size - 1] - 1.) < 1e-9);
  return n_failed;
}
