// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/graded_points.h>
#include <lahar/geometry/take_places.h>
#include <lahar/utilities/share_of_rank.h>

#include <numeric>

namespace Lahar
{
  namespace
  {
    /// Points of different lattices keep this distance, over h.
    constexpr double clearance = 0.65;
  } // namespace



  template <int dim>
  DividedPoints<dim> with_graded_lattice(const std::vector<Point<dim>> &contour, const SizeFunction<dim> &h,
                                         const std::vector<double> &levels, const Lattice<dim> &lattice,
                                         const MPI_Comm &communicator)
  {
    DividedPoints<dim> points;
    const auto [begin, end] = share_of_rank(contour.size(), communicator);
    for (unsigned int i = begin; i < end; ++i)
      points.append(contour[i], i);

    unsigned int n = contour.size();
    for (unsigned int level = 0; level < levels.size(); ++level)
    {
      const auto is_wanted = [&](const Point<dim> &p) {
        if (levels.size() == 1)
          return true;
        const double size = h(p);
        return size >= levels[level] && (level + 1 == levels.size() || size < levels[level + 1]);
      };
      const std::vector<Point<dim>> share = lattice(levels[level], is_wanted);
      const std::vector<unsigned int> sizes =
        Utilities::MPI::all_gather(communicator, static_cast<unsigned int>(share.size()));
      unsigned int number =
        std::accumulate(sizes.begin(), sizes.begin() + Utilities::MPI::this_mpi_process(communicator), n);
      for (const Point<dim> &p : share)
        points.append(p, number++);
      n = std::accumulate(sizes.begin(), sizes.end(), n);
    }
    divide(points, communicator);
    if (levels.size() > 1)
    {
      const std::vector<bool> stands = take_places<dim>(
        points, std::vector<bool>(points.size(), true), [&](const Point<dim> &p) { return clearance * h(p); },
        [&](const Point<dim> &, const unsigned int number, const Point<dim> &, const unsigned int) {
          return number >= contour.size();
        },
        communicator);
      points.keep_if([&](const std::size_t i) { return stands[i]; });
    }
    return points;
  }



  template DividedPoints<2> with_graded_lattice(const std::vector<Point<2>> &, const SizeFunction<2> &,
                                                const std::vector<double> &, const Lattice<2> &,
                                                const MPI_Comm &);
  template DividedPoints<3> with_graded_lattice(const std::vector<Point<3>> &, const SizeFunction<3> &,
                                                const std::vector<double> &, const Lattice<3> &,
                                                const MPI_Comm &);
} // namespace Lahar
