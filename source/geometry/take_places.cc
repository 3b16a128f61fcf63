// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/packed_points.h>
#include <lahar/geometry/take_places.h>
#include <lahar/utilities/halo_exchange.h>
#include <lahar/utilities/true_on_all_ranks.h>

namespace Lahar
{
  namespace
  {
    constexpr double undecided = 0., stands = 1., fallen = 2.;

    /// To tell the ranks that know this rank's points what has become of these.
    template <int dim>
    HaloExchange exchange_of(const KnownPoints<dim> &known, const MPI_Comm &communicator)
    {
      const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
      std::vector<unsigned int> copies, owners;
      std::vector<std::uint64_t> numbers;
      for (unsigned int i = 0; i < known.size(); ++i)
        if (known.owner[i] != rank)
        {
          copies.push_back(i);
          owners.push_back(known.owner[i]);
          numbers.push_back(known.number[i]);
        }
      HaloExchange exchange(communicator);
      exchange.reinit(copies, owners, numbers, [&](const std::uint64_t number) {
        return std::lower_bound(known.number.begin(), known.number.end(), number) - known.number.begin();
      });
      return exchange;
    }

    /// Decide of points that wait for others. @param hindrances points and those in their way, in order.
    /// @return whether none waits any longer.
    bool decide(const std::vector<std::pair<unsigned int, unsigned int>> &hindrances,
                std::vector<double> &state)
    {
      bool done = true;
      for (auto begin = hindrances.begin(); begin != hindrances.end();)
      {
        const unsigned int i = begin->first;
        bool waits = false, falls = false;
        for (; begin != hindrances.end() && begin->first == i; ++begin)
        {
          falls = falls || state[begin->second] == stands;
          waits = waits || state[begin->second] == undecided;
        }
        if (falls || !waits)
          state[i] = falls ? fallen : stands;
        else
          done = false;
      }
      return done;
    }
  } // namespace



  template <int dim>
  std::vector<bool> take_places(const DividedPoints<dim> &points, const std::vector<bool> &is_free,
                                const std::function<double(const Point<dim> &)> &clearance,
                                const IsInTheWay<dim> &is_in_the_way, const MPI_Comm &communicator)
  {
    AssertDimension(is_free.size(), points.size());
    double reach = 0.;
    for (const Point<dim> &p : points.position)
      reach = std::max(reach, clearance(p));
    std::optional<BoundingBox<dim>> box = bounding_box(points.position);
    if (box)
      box->extend(reach);
    const KnownPoints<dim> known = points_in(box, points, communicator);
    const PackedPoints<dim> places(known.position);

    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    std::vector<double> state(known.size(), undecided);
    std::vector<std::pair<unsigned int, unsigned int>> hindrances;
    for (unsigned int i = 0, k = 0; i < known.size(); ++i)
      if (known.owner[i] == rank)
      {
        const std::size_t n_before = hindrances.size();
        const Point<dim> &p        = known.position[i];
        if (is_free[k])
          places.any_near(p, clearance(p), [&](const unsigned int other) {
            if (other < i && is_in_the_way(p, known.number[i], known.position[other], known.number[other]))
              hindrances.emplace_back(i, other);
            return false;
          });
        if (hindrances.size() == n_before)
          state[i] = is_free[k] ? stands : fallen;
        ++k;
      }
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      decide(hindrances, state);
    else
    {
      const HaloExchange exchange = exchange_of(known, communicator);
      for (bool done = false; !done;)
      {
        exchange.update(state.data(), 1);
        done = true_on_all_ranks(decide(hindrances, state), communicator);
      }
    }

    std::vector<bool> result;
    for (unsigned int i = 0; i < known.size(); ++i)
      if (known.owner[i] == rank)
        result.push_back(state[i] == stands);
    return result;
  }



  template std::vector<bool> take_places(const DividedPoints<2> &, const std::vector<bool> &,
                                         const std::function<double(const Point<2> &)> &,
                                         const IsInTheWay<2> &, const MPI_Comm &);
  template std::vector<bool> take_places(const DividedPoints<3> &, const std::vector<bool> &,
                                         const std::function<double(const Point<3> &)> &,
                                         const IsInTheWay<3> &, const MPI_Comm &);
} // namespace Lahar
