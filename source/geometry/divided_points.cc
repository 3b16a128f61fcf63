// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/divided_points.h>
#include <lahar/particles/recursive_bisection.h>
#include <lahar/utilities/send_arrays.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <limits>
#include <numeric>

namespace Lahar
{
  namespace
  {
    /// What is sent of a point: its number, which a double holds exactly, and its coordinates.
    template <int dim>
    using Record = std::array<double, dim + 1>;

    template <int dim>
    using Records = std::map<unsigned int, std::vector<Record<dim>>>; // by rank

    template <int dim>
    Record<dim> record(const DividedPoints<dim> &points, const std::size_t i)
    {
      Record<dim> result;
      result[0] = points.number[i];
      for (unsigned int d = 0; d < dim; ++d)
        result[d + 1] = points.position[i][d];
      return result;
    }

    template <int dim>
    void append(const std::vector<Record<dim>> &records, DividedPoints<dim> &points)
    {
      for (const Record<dim> &values : records)
      {
        points.append(Point<dim>(), static_cast<unsigned int>(values[0]));
        std::copy_n(values.begin() + 1, dim, points.position.back().begin_raw());
      }
    }

    template <typename T>
    void put_in_order(const std::vector<unsigned int> &order, std::vector<T> &values)
    {
      std::vector<T> result;
      result.reserve(order.size());
      for (const unsigned int i : order)
        result.push_back(values[i]);
      values.swap(result);
    }

    /// @return the old places of the points, by their numbers.
    template <int dim>
    std::vector<unsigned int> sort(DividedPoints<dim> &points)
    {
      std::vector<unsigned int> order(points.size());
      std::iota(order.begin(), order.end(), 0U);
      std::sort(order.begin(), order.end(), [&](const unsigned int a, const unsigned int b) {
        return points.number[a] < points.number[b];
      });
      put_in_order(order, points.position);
      put_in_order(order, points.number);
      return order;
    }

    unsigned int n_ranks(const MPI_Comm &communicator)
    {
      return Utilities::MPI::n_mpi_processes(communicator);
    }

    unsigned int this_rank(const MPI_Comm &communicator)
    {
      return Utilities::MPI::this_mpi_process(communicator);
    }
  } // namespace



  template <int dim>
  unsigned int end_of_numbers(const DividedPoints<dim> &points, const MPI_Comm &communicator)
  {
    return Utilities::MPI::max(points.number.empty() ? 0U : points.number.back() + 1, communicator);
  }



  template <int dim>
  void send(DividedPoints<dim> &points, const std::function<unsigned int(std::size_t)> &rank_of,
            const MPI_Comm &communicator)
  {
    if (n_ranks(communicator) == 1)
      return;
    const unsigned int rank = this_rank(communicator);
    Records<dim> sent;
    points.keep_if([&](const std::size_t i) {
      const unsigned int to = rank_of(i);
      if (to != rank)
        sent[to].push_back(record(points, i));
      return to == rank;
    });
    for (auto &[sender, records] : send_arrays(sent, communicator))
      append<dim>(records, points);
    sort(points);
  }



  template <int dim>
  void divide(DividedPoints<dim> &points, const MPI_Comm &communicator)
  {
    if (n_ranks(communicator) == 1)
      return;
    RecursiveBisection<dim> parts(communicator);
    parts.divide(points.position, std::vector<double>(points.size(), 1.));
    send<dim>(
      points, [&](const std::size_t i) { return parts.rank_of(points.position[i]); }, communicator);
  }



  template <int dim>
  KnownPoints<dim> points_in(const std::optional<BoundingBox<dim>> &box, const DividedPoints<dim> &points,
                             const MPI_Comm &communicator)
  {
    const unsigned int rank = this_rank(communicator);
    KnownPoints<dim> result;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (box && box->point_inside(points.position[i]))
        result.append(points.position[i], points.number[i]);
    result.owner.assign(result.size(), rank);
    if (n_ranks(communicator) == 1)
      return result;

    std::vector<Point<dim>> corners;
    if (box)
      corners = {box->get_boundary_points().first, box->get_boundary_points().second};
    const auto corners_of_ranks = Utilities::MPI::all_gather(communicator, corners);
    Records<dim> sent;
    for (unsigned int other = 0; other < corners_of_ranks.size(); ++other)
      if (other != rank && !corners_of_ranks[other].empty())
      {
        const BoundingBox<dim> their_box({corners_of_ranks[other][0], corners_of_ranks[other][1]});
        for (std::size_t i = 0; i < points.size(); ++i)
          if (their_box.point_inside(points.position[i]))
            sent[other].push_back(record(points, i));
      }
    for (auto &[sender, records] : send_arrays(sent, communicator))
    {
      append<dim>(records, result);
      result.owner.resize(result.size(), sender);
      std::vector<Record<dim>>().swap(records);
    }
    put_in_order(sort<dim>(result), result.owner);
    return result;
  }



  template <int dim>
  std::vector<Point<dim>> all_points(const DividedPoints<dim> &points, const MPI_Comm &communicator)
  {
    if (n_ranks(communicator) == 1)
      return points.position;
    std::vector<Record<dim>> records;
    for (std::size_t i = 0; i < points.size(); ++i)
      records.push_back(record(points, i));
    DividedPoints<dim> all;
    for (const std::vector<Record<dim>> &of_rank : Utilities::MPI::all_gather(communicator, records))
      append<dim>(of_rank, all);
    sort(all);
    return all.position;
  }



  template <int dim>
  std::optional<Point<dim>> first_of(const DividedPoints<dim> &points,
                                     const std::function<bool(const Point<dim> &)> &condition,
                                     const MPI_Comm &communicator)
  {
    constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
    const std::size_t i         = std::find_if(points.position.begin(), points.position.end(), condition) -
                          points.position.begin();
    const unsigned int number = i < points.size() ? points.number[i] : none,
                       first  = Utilities::MPI::min(number, communicator);
    if (first == none)
      return {};
    const Point<dim> place = number == first ? points.position[i] : Point<dim>();
    if (n_ranks(communicator) == 1)
      return place;
    const unsigned int owner = Utilities::MPI::min(number == first ? this_rank(communicator) : none,
                                                   communicator);
    return Utilities::MPI::broadcast(communicator, place, owner);
  }



  template <int dim>
  void renumber(DividedPoints<dim> &points, const unsigned int first, const MPI_Comm &communicator)
  {
    constexpr unsigned int n_bits = 64;
    std::vector<std::uint64_t> words(end_of_numbers(points, communicator) / n_bits + 1, 0);
    for (const unsigned int number : points.number)
      words[number / n_bits] |= std::uint64_t(1) << number % n_bits;
    if (n_ranks(communicator) > 1)
    {
      const int ierr = MPI_Allreduce(MPI_IN_PLACE, words.data(), words.size(), MPI_UINT64_T, MPI_BOR,
                                     communicator);
      AssertThrowMPI(ierr);
    }
    const auto n_set = [](const std::uint64_t word) { return std::bitset<n_bits>(word).count(); };
    std::size_t w = 0, n_before = first; // the word
    for (unsigned int &number : points.number)
    {
      for (; w < number / n_bits; ++w)
        n_before += n_set(words[w]);
      number = n_before + n_set(words[w] & ((std::uint64_t(1) << number % n_bits) - 1));
    }
  }



  template <int dim>
  std::optional<BoundingBox<dim>> bounding_box(const std::vector<Point<dim>> &points)
  {
    if (points.empty())
      return {};
    std::pair<Point<dim>, Point<dim>> corners(points[0], points[0]);
    for (const Point<dim> &p : points)
      for (unsigned int d = 0; d < dim; ++d)
      {
        corners.first[d]  = std::min(corners.first[d], p[d]);
        corners.second[d] = std::max(corners.second[d], p[d]);
      }
    return BoundingBox<dim>(corners);
  }



#define INSTANTIATE(dim)                                                                                   \
  template unsigned int end_of_numbers(const DividedPoints<dim> &, const MPI_Comm &);                      \
  template void send(DividedPoints<dim> &, const std::function<unsigned int(std::size_t)> &,               \
                     const MPI_Comm &);                                                                    \
  template void divide(DividedPoints<dim> &, const MPI_Comm &);                                            \
  template KnownPoints<dim> points_in(const std::optional<BoundingBox<dim>> &, const DividedPoints<dim> &, \
                                      const MPI_Comm &);                                                   \
  template std::vector<Point<dim>> all_points(const DividedPoints<dim> &, const MPI_Comm &);               \
  template std::optional<Point<dim>> first_of(const DividedPoints<dim> &,                                  \
                                              const std::function<bool(const Point<dim> &)> &,             \
                                              const MPI_Comm &);                                           \
  template void renumber(DividedPoints<dim> &, const unsigned int, const MPI_Comm &);                      \
  template std::optional<BoundingBox<dim>> bounding_box(const std::vector<Point<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Lahar
