// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_divided_points_h
#define lahar_geometry_divided_points_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <functional>
#include <optional>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// Points in an order, of which each rank has some. Each point is one rank's own.
  template <int dim>
  struct DividedPoints
  {
    std::vector<Point<dim>> position;
    std::vector<unsigned int> number; ///< among those of all ranks, ascending, perhaps with gaps

    std::size_t size() const
    {
      return position.size();
    }

    void append(const Point<dim> &place, const unsigned int new_number)
    {
      position.push_back(place);
      number.push_back(new_number);
    }

    /// Keep those of which @p is_kept, a function of the index, is true.
    template <typename Condition>
    void keep_if(const Condition &is_kept)
    {
      std::size_t n = 0;
      for (std::size_t i = 0; i < size(); ++i)
        if (is_kept(i))
        {
          position[n] = position[i];
          number[n++] = number[i];
        }
      position.resize(n);
      number.resize(n);
    }
  };

  /// One behind the largest number on any rank. Collective.
  template <int dim>
  unsigned int end_of_numbers(const DividedPoints<dim> &points, const MPI_Comm &communicator);

  /// Give each point to the rank that @p rank_of, a function of the index, tells. Collective.
  template <int dim>
  void send(DividedPoints<dim> &points, const std::function<unsigned int(std::size_t)> &rank_of,
            const MPI_Comm &communicator);

  /// Give each rank a part of space and the points in it, of which each has as many (RecursiveBisection). Collective.
  template <int dim>
  void divide(DividedPoints<dim> &points, const MPI_Comm &communicator);

  /// Points that a rank knows, with their owners.
  template <int dim>
  struct KnownPoints : DividedPoints<dim>
  {
    std::vector<unsigned int> owner;
  };

  /// Those of all ranks' points that lie in a box, of which each rank names its own or none. Collective.
  template <int dim>
  KnownPoints<dim> points_in(const std::optional<BoundingBox<dim>> &box, const DividedPoints<dim> &points,
                             const MPI_Comm &communicator);

  /// All ranks' points in their order, for few of them: on a body's contour, say. Collective.
  template <int dim>
  std::vector<Point<dim>> all_points(const DividedPoints<dim> &points, const MPI_Comm &communicator);

  /// Of all ranks' points the first one that fulfils @p condition. Collective.
  template <int dim>
  std::optional<Point<dim>> first_of(const DividedPoints<dim> &points,
                                     const std::function<bool(const Point<dim> &)> &condition,
                                     const MPI_Comm &communicator);

  /// Number all ranks' points without gaps from @p first on, in the same order; for this each rank has a bit for each
  /// number. Collective.
  template <int dim>
  void renumber(DividedPoints<dim> &points, const unsigned int first, const MPI_Comm &communicator);

  /// The smallest box around points, if there are any.
  template <int dim>
  std::optional<BoundingBox<dim>> bounding_box(const std::vector<Point<dim>> &points);
} // namespace Lahar

#endif
