#include <lahar/remeshing/delaunay.h>

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
    using Types = CGALTypes<dim>;

    std::vector<std::pair<typename Types::Triangulation::Point, unsigned int>> numbered;
    numbered.reserve(indices.size());
    for (const unsigned int i : indices)
      numbered.emplace_back(Types::point(points[i]), i);
    // Range insertion sorts the points along a space-filling curve first.
    implementation->triangulation.insert(numbered.begin(), numbered.end());
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
    {
      // Some points stand in the same place: replace each by the first one there.
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
      for (Simplex<dim> &simplex : result)
        for (unsigned int &corner : simplex)
          corner = first_there[corner];
    }
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



  std::vector<Simplex<2>> constrained_delaunay(const std::vector<Point<2>> &points,
                                               const std::vector<std::array<unsigned int, 2>> &segments,
                                               unsigned int &n_forced)
  {
    using Types = CGALTypes<2>;
    using Structure =
      CGAL::Triangulation_data_structure_2<Types::Vertex,
                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
    using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

    std::vector<std::pair<Triangulation::Point, unsigned int>> numbered;
    numbered.reserve(points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      numbered.emplace_back(Types::point(points[i]), i);
    Triangulation triangulation;
    triangulation.insert(numbered.begin(), numbered.end());

    std::vector<Triangulation::Vertex_handle> vertices(points.size());
    for (const auto &vertex : triangulation.finite_vertex_handles())
      vertices[vertex->info()] = vertex;
    n_forced = 0;
    for (const auto &[from, to] : segments)
    {
      if (vertices[from] == Triangulation::Vertex_handle() || vertices[to] == Triangulation::Vertex_handle())
        continue; // another point stands in the same place
      if (!triangulation.is_edge(vertices[from], vertices[to]))
        ++n_forced;
      try
      {
        triangulation.insert_constraint(vertices[from], vertices[to]);
      }
      catch (const Triangulation::Intersection_of_constraints_exception &)
      {
        std::ostringstream message;
        message << "the contours of two solids cross at (" << points[from] << ") m";
        throw RunError(message.str());
      }
    }

    std::vector<Simplex<2>> cells;
    if (triangulation.dimension() < 2)
      return cells;
    for (const auto &face : triangulation.finite_face_handles())
      cells.push_back({{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}});
    return cells;
  }



  template class DelaunayTriangulation<2>;
  template class DelaunayTriangulation<3>;
  template std::vector<Simplex<2>> delaunay(const std::vector<Point<2>> &);
  template std::vector<Simplex<3>> delaunay(const std::vector<Point<3>> &);
} // namespace Lahar
