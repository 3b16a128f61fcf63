#include <lahar/remeshing/delaunay.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <lahar/utilities/exceptions.h>

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
  std::vector<Simplex<dim>> delaunay(const std::vector<Point<dim>> &points)
  {
    using Types = CGALTypes<dim>;

    std::vector<std::pair<typename Types::Triangulation::Point, unsigned int>> numbered;
    numbered.reserve(points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      numbered.emplace_back(Types::point(points[i]), i);

    // Range insertion sorts the points along a space-filling curve first.
    typename Types::Triangulation triangulation;
    triangulation.insert(numbered.begin(), numbered.end());

    std::vector<Simplex<dim>> cells;
    if (triangulation.dimension() < dim)
      return cells;
    for (const auto &cell : Types::finite_cells(triangulation))
    {
      Simplex<dim> corners;
      for (unsigned int c = 0; c <= dim; ++c)
        corners[c] = cell->vertex(c)->info();
      cells.push_back(corners);
    }
    return cells;
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



  template std::vector<Simplex<2>> delaunay(const std::vector<Point<2>> &);
  template std::vector<Simplex<3>> delaunay(const std::vector<Point<3>> &);
} // namespace Lahar
