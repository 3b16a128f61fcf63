// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/particles/recursive_bisection.h>

#include <algorithm>
#include <limits>

namespace Lahar
{
  namespace
  {
    /// A cut is good enough where the weights differ from what they should be by this part.
    constexpr double tolerance = 0.005;

    /// Halvings of the interval in which the place of a cut is sought.
    constexpr unsigned int max_halvings = 40;
  } // namespace



  template <int dim>
  RecursiveBisection<dim>::RecursiveBisection(const MPI_Comm &communicator)
    : communicator(communicator)
    , parts{{0, 1}}
  {}



  template <int dim>
  void RecursiveBisection<dim>::divide(const std::vector<Point<dim>> &points,
                                       const std::vector<double> &weights)
  {
    AssertDimension(points.size(), weights.size());
    parts = {{0, Utilities::MPI::n_mpi_processes(communicator)}};
    std::vector<unsigned int> part_of(points.size(), 0);
    for (unsigned int begin = 0, end = 1; begin < end; begin = end, end = parts.size())
    {
      // The boxes around the points of this level's parts, by their negative lower and their upper bounds.
      const unsigned int n = end - begin;
      std::vector<double> bounds(n * 2 * dim, -std::numeric_limits<double>::max());
      for (unsigned int i = 0; i < points.size(); ++i)
        if (part_of[i] >= begin)
          for (unsigned int d = 0; d < dim; ++d)
          {
            double *bound = &bounds[((part_of[i] - begin) * dim + d) * 2];
            bound[0]      = std::max(bound[0], -points[i][d]);
            bound[1]      = std::max(bound[1], points[i][d]);
          }
      Utilities::MPI::max(bounds, communicator, bounds);

      std::vector<double> lower(n, 0.), upper(n, 0.);
      for (unsigned int p = 0; p < n; ++p)
      {
        Part &part   = parts[begin + p];
        double width = -1.;
        for (unsigned int d = 0; d < dim; ++d)
        {
          const double *bound = &bounds[(p * dim + d) * 2];
          if (bound[0] + bound[1] > width)
          {
            width          = bound[0] + bound[1];
            part.direction = d;
            lower[p]       = -bound[0];
            upper[p]       = bound[1];
          }
        }
      }

      bool good = false;
      for (unsigned int k = 0; k < max_halvings && !good; ++k)
      {
        std::vector<double> sums(2 * n, 0.); // all weight and that below the cut
        for (unsigned int p = 0; p < n; ++p)
          parts[begin + p].place = 0.5 * (lower[p] + upper[p]);
        for (unsigned int i = 0; i < points.size(); ++i)
          if (part_of[i] >= begin)
          {
            const unsigned int p = part_of[i] - begin;
            sums[2 * p] += weights[i];
            if (points[i][parts[part_of[i]].direction] < parts[part_of[i]].place)
              sums[2 * p + 1] += weights[i];
          }
        Utilities::MPI::sum(sums, communicator, sums);
        good = true;
        for (unsigned int p = 0; p < n; ++p)
        {
          const Part &part                   = parts[begin + p];
          const double share                 = static_cast<double>(part.n_ranks / 2) / part.n_ranks,
                       error                 = sums[2 * p + 1] - share * sums[2 * p];
          (error > 0. ? upper[p] : lower[p]) = part.place;
          good = good && (part.n_ranks == 1 || std::abs(error) <= tolerance * sums[2 * p]);
        }
      }

      for (unsigned int p = begin; p < end; ++p)
        if (const Part part = parts[p]; part.n_ranks > 1)
        {
          parts[p].below = parts.size();
          parts.push_back({part.first, part.n_ranks / 2});
          parts.push_back({part.first + part.n_ranks / 2, part.n_ranks - part.n_ranks / 2});
        }
      for (unsigned int i = 0; i < points.size(); ++i)
        if (const Part &part = parts[part_of[i]]; part.n_ranks > 1)
          part_of[i] = part.below + (points[i][part.direction] < part.place ? 0 : 1);
    }
  }



  template <int dim>
  unsigned int RecursiveBisection<dim>::rank_of(const Point<dim> &point) const
  {
    unsigned int p = 0;
    while (parts[p].n_ranks > 1)
      p = parts[p].below + (point[parts[p].direction] < parts[p].place ? 0 : 1);
    return parts[p].first;
  }



  template class RecursiveBisection<2>;
  template class RecursiveBisection<3>;
} // namespace Lahar
