// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/delaunay.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <lahar/utilities/exceptions.h>

#include <numeric>
#include <sstream>
#include <utility>

namespace Lahar
{
  namespace
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

    template <int dim>
    struct CGALTypes;

    template <>
    struct CGALTypes<2>
    {
      using Vertex = CGAL::Triangulation_vertex_base_with_info_2<unsigned int, Kernel>;
      using Triangulation =
        CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

      static auto finite_cells(const Triangulation &triangulation)
      {
        return triangulation.finite_face_handles();
      }

      static Kernel::Point_2 point(const Point<2> &p)
      {
        return {p[0], p[1]};
      }
    };

    template <>
    struct CGALTypes<3>
    {
      using Vertex = CGAL::Triangulation_vertex_base_with_info_3<unsigned int, Kernel>;
      using Cell   = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
      using Triangulation =
        CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

      static auto finite_cells(const Triangulation &triangulation)
      {
        return triangulation.finite_cell_handles();
      }

      static Kernel::Point_3 point(const Point<3> &p)
      {
        return {p[0], p[1], p[2]};
      }
    };

    template <int dim, typename Triangulation>
    void insert_points(const std::vector<Point<dim>> &points, const std::vector<unsigned int> &indices,
                       Triangulation &triangulation)
    {
      std::vector<std::pair<typename Triangulation::Point, unsigned int>> numbered;
      numbered.reserve(indices.size());
      for (const unsigned int i : indices)
        numbered.emplace_back(CGALTypes<dim>::point(points[i]), i);
      // Range insertion sorts the points along a space-filling curve first.
      triangulation.insert(numbered.begin(), numbered.end());
    }

    /// Some of the @p inserted points stand in the same place: replace each corner by the first one there.
    template <int dim>
    void use_first_points(const std::vector<Point<dim>> &points, const std::vector<unsigned int> &inserted,
                          std::vector<Simplex<dim>> &simplices)
    {
      const auto coordinates = [&](const unsigned int i) {
        std::array<double, dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = points[i][d];
        return x;
      };
      std::vector<unsigned int> order = inserted, first_there(points.size());
      std::sort(order.begin(), order.end(), [&](const unsigned int i, const unsigned int j) {
        return std::make_pair(coordinates(i), i) < std::make_pair(coordinates(j), j);
      });
      for (unsigned int k = 0; k < order.size(); ++k)
        first_there[order[k]] = k > 0 && coordinates(order[k]) == coordinates(order[k - 1])
                                  ? first_there[order[k - 1]]
                                  : order[k];
      for (Simplex<dim> &simplex : simplices)
        for (unsigned int &corner : simplex)
          corner = first_there[corner];
    }
  } // namespace



  template <int dim>
  struct DelaunayTriangulation<dim>::Implementation
  {
    typename CGALTypes<dim>::Triangulation triangulation;
  };



  template <int dim>
  DelaunayTriangulation<dim>::DelaunayTriangulation(const std::vector<Point<dim>> &points)
    : points(points)
    , implementation(std::make_unique<Implementation>())
  {}



  template <int dim>
  DelaunayTriangulation<dim>::~DelaunayTriangulation() = default;



  template <int dim>
  void DelaunayTriangulation<dim>::insert(const std::vector<unsigned int> &indices)
  {
    insert_points<dim>(points, indices, implementation->triangulation);
    inserted.insert(inserted.end(), indices.begin(), indices.end());
  }



  template <int dim>
  std::vector<Simplex<dim>> DelaunayTriangulation<dim>::simplices() const
  {
    const auto &triangulation = implementation->triangulation;
    std::vector<Simplex<dim>> result;
    if (triangulation.dimension() < dim)
      return result;
    for (const auto &cell : CGALTypes<dim>::finite_cells(triangulation))
    {
      Simplex<dim> corners;
      for (unsigned int c = 0; c <= dim; ++c)
        corners[c] = cell->vertex(c)->info();
      result.push_back(corners);
    }

    if (triangulation.number_of_vertices() < inserted.size())
      use_first_points<dim>(points, inserted, result);
    return result;
  }



  template <int dim>
  std::vector<Simplex<dim>> delaunay(const std::vector<Point<dim>> &points)
  {
    std::vector<unsigned int> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    DelaunayTriangulation<dim> triangulation(points);
    triangulation.insert(all);
    return triangulation.simplices();
  }



  template <>
  bool in_circumball<2>(const std::array<Point<2>, 3> &c, const Point<2> &p)
  {
    const auto point = CGALTypes<2>::point;
    return Kernel().side_of_oriented_circle_2_object()(point(c[0]), point(c[1]), point(c[2]), point(p)) !=
           CGAL::ON_NEGATIVE_SIDE;
  }

  template <>
  bool in_circumball<3>(const std::array<Point<3>, 4> &c, const Point<3> &p)
  {
    const auto point = CGALTypes<3>::point;
    return Kernel().side_of_oriented_sphere_3_object()(point(c[0]), point(c[1]), point(c[2]), point(c[3]),
                                                       point(p)) != CGAL::ON_NEGATIVE_SIDE;
  }



  struct ConstrainedDelaunay::Implementation
  {
    using Structure =
      CGAL::Triangulation_data_structure_2<CGALTypes<2>::Vertex,
                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
    using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

    Triangulation triangulation;
  };



  ConstrainedDelaunay::ConstrainedDelaunay(const std::vector<Point<2>> &points,
                                           const std::vector<std::array<unsigned int, 2>> &segments,
                                           const unsigned int n_required)
    : points(points)
    , segments(segments)
    , n_required(n_required)
    , is_forced(segments.size(), false)
    , implementation(std::make_unique<Implementation>())
  {}



  ConstrainedDelaunay::~ConstrainedDelaunay() = default;



  void ConstrainedDelaunay::insert(const std::vector<unsigned int> &indices)
  {
    insert_points<2>(points, indices, implementation->triangulation);
    if (inserted.empty())
      insert_segments();
    inserted.insert(inserted.end(), indices.begin(), indices.end());
  }



  void ConstrainedDelaunay::insert_segments()
  {
    using Triangulation          = Implementation::Triangulation;
    Triangulation &triangulation = implementation->triangulation;
    std::vector<Triangulation::Vertex_handle> vertices(points.size());
    for (const auto &vertex : triangulation.finite_vertex_handles())
      vertices[vertex->info()] = vertex;
    for (unsigned int s = 0; s < segments.size(); ++s)
    {
      const auto [from, to] = segments[s];
      if (vertices[from] == Triangulation::Vertex_handle() || vertices[to] == Triangulation::Vertex_handle())
        continue; // another point stands in the same place
      is_forced[s] = !triangulation.is_edge(vertices[from], vertices[to]);
      try
      {
        triangulation.insert_constraint(vertices[from], vertices[to]);
      }
      catch (const Triangulation::Intersection_of_constraints_exception &)
      {
        if (s >= n_required)
          continue;
        std::ostringstream message;
        message << "the contours of two solids cross at (" << points[from] << ") m";
        throw RunError(message.str());
      }
    }
  }



  std::vector<Simplex<2>> ConstrainedDelaunay::simplices() const
  {
    const auto &triangulation = implementation->triangulation;
    std::vector<Simplex<2>> result;
    if (triangulation.dimension() < 2)
      return result;
    for (const auto &face : triangulation.finite_face_handles())
      result.push_back({{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}});
    if (triangulation.number_of_vertices() < inserted.size())
      use_first_points<2>(points, inserted, result);
    return result;
  }



  template class DelaunayTriangulation<2>;
  template class DelaunayTriangulation<3>;
  template std::vector<Simplex<2>> delaunay(const std::vector<Point<2>> &);
  template std::vector<Simplex<3>> delaunay(const std::vector<Point<3>> &);
} // namespace Lahar
