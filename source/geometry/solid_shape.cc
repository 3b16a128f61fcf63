// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/solid_shape.h>
#include <lahar/remeshing/simplex_geometry.h>

#include <cmath>

namespace Lahar
{
  template <int dim>
  void SolidShape<dim>::declare_parameters(Parameters &prm)
  {
    prm.declare_entry("Box", "", Patterns::Anything(),
                      std::string("The solid as a box with the opposite corners ") +
                        (dim == 2 ? "'x, y : x, y'" : "'x, y, z : x, y, z'") + ". Lengths in m.");
    prm.declare_entry(
      "Elements", "", Patterns::Anything(),
      std::string("Numbers of elements along ") + (dim == 2 ? "x and y" : "x, y and z") +
        " of a box, 1 to 10000, separated by commas; empty: as many as the mesh size asks for.");
    prm.declare_file(
      "Mesh file",
      "A gmsh file (.msh) with the solid's mesh, instead of a box; its name is relative to the parameter file "
      "that gives it (on the command line: to the working directory). Elements of second order count as "
      "straight ones.");
    prm.declare_entry("Mesh scale", "1", Patterns::Anything(),
                      "Factor for the mesh file's coordinates, above zero: 1e-3 for a mesh in mm.");
    prm.declare_entry("Group", "", Patterns::Anything(),
                      std::string("The mesh file's physical ") + (dim == 2 ? "surface" : "volume") +
                        " that is the solid, by its name or its tag.");
  }



  template <int dim>
  void SolidShape<dim>::parse_parameters(Parameters &prm)
  {
    const bool has_box = !prm.get("Box").empty(), has_file = !prm.get("Mesh file").empty();
    if (has_box == has_file)
      throw InputError("'" + prm.path("Box") + "' and '" + prm.path("Mesh file") + "' are " +
                       (has_box ? "both given" : "both empty") + ". Allowed: one of them.");
    if (has_file)
    {
      parse_mesh_file(prm);
      return;
    }

    const std::vector<Box<dim>> boxes = parse_boxes<dim>(prm, "Box");
    const std::string allowed         = "two opposite corners that differ in every coordinate";
    if (boxes.size() != 1)
      prm.throw_wrong_value("Box", allowed);
    lower = boxes[0].lower;
    upper = boxes[0].upper;
    for (unsigned int d = 0; d < dim; ++d)
      if (!(upper[d] > lower[d]))
        prm.throw_wrong_value("Box", allowed);
    const std::vector<std::string> numbers = split_list(prm.get("Elements"), ',');
    if (!numbers.empty())
      for (unsigned int d = 0; d < dim; ++d)
      {
        int n = 0;
        try
        {
          n = numbers.size() == dim ? Utilities::string_to_int(numbers[d]) : 0;
        }
        catch (const ExceptionBase &)
        {}
        if (n < 1 || n > 10000)
          prm.throw_wrong_value("Elements", std::to_string(dim) + " whole numbers from 1 to 10000");
        n_elements[d] = n;
      }
  }



  template <int dim>
  Box<dim> SolidShape<dim>::box() const
  {
    return file_vertices.empty() ? Box<dim>(lower, upper) : box_around(file_vertices);
  }



  template <int dim>
  void SolidShape<dim>::parse_mesh_file(Parameters &prm)
  {
    const GmshFile<dim> file(prm.get("Mesh file"), prm.get_positive("Mesh scale"));
    // A name with a comma may stand in quotes, as in a list.
    const std::string text = prm.get("Group");
    const bool is_quoted   = text.size() > 1 && text.front() == '"' && text.back() == '"';
    std::vector<Simplex<dim>> simplices;
    file.cells_of(is_quoted ? text.substr(1, text.size() - 2) : text, file_vertices, simplices);
    for (Simplex<dim> simplex : simplices)
    {
      if (signed_volume<dim>(corners_of<dim>(simplex, file_vertices)) < 0.)
        std::swap(simplex[1], simplex[2]);
      file_cells.emplace_back(dim + 1);
      std::copy(simplex.begin(), simplex.end(), file_cells.back().vertices.begin());
    }
  }



  namespace
  {
    /// Divide rectangle (i, j) into triangles of corner numbers; @p vertex gives the number of a lattice point.
    template <typename Vertex>
    void divide(const std::array<unsigned int, 2> &ij, const Vertex &vertex,
                std::vector<std::array<unsigned int, 3>> &triangles)
    {
      const auto [i, j]    = ij;
      const unsigned int a = vertex({{i, j}}), b = vertex({{i + 1, j}}), c = vertex({{i + 1, j + 1}}),
                         d = vertex({{i, j + 1}});
      if ((i + j) % 2 == 0)
        triangles.insert(triangles.end(), {{{a, b, c}}, {{a, c, d}}});
      else
        triangles.insert(triangles.end(), {{{a, b, d}}, {{b, c, d}}});
    }

    /// Divide cuboid (i, j, k) into five tetrahedra, mirrored from one to the next so that their faces match.
    template <typename Vertex>
    void divide(const std::array<unsigned int, 3> &ijk, const Vertex &vertex,
                std::vector<std::array<unsigned int, 4>> &tetrahedra)
    {
      const unsigned int mirrored = (ijk[0] + ijk[1] + ijk[2]) % 2;
      const auto corner           = [&](const unsigned int x, const unsigned int y, const unsigned int z) {
        return vertex({{ijk[0] + (x ^ mirrored), ijk[1] + y, ijk[2] + z}});
      };
      // The inner one has the corners whose coordinates have an even sum, the others cut off the odd corners.
      const unsigned int even[4] = {corner(0, 0, 0), corner(1, 1, 0), corner(1, 0, 1), corner(0, 1, 1)};
      const unsigned int odd[4]  = {corner(1, 1, 1), corner(0, 0, 1), corner(0, 1, 0), corner(1, 0, 0)};
      tetrahedra.push_back({{even[0], even[1], even[2], even[3]}});
      for (unsigned int o = 0; o < 4; ++o)
      {
        std::array<unsigned int, 4> cell = {{odd[o], 0, 0, 0}};
        for (unsigned int e = 0, n = 1; e < 4; ++e)
          if (e != o)
            cell[n++] = even[e];
        tetrahedra.push_back(cell);
      }
    }
  } // namespace



  template <int dim>
  double SolidShape<dim>::n_elements_along(const unsigned int d, const double size) const
  {
    return n_elements[d] > 0 ? n_elements[d] : std::max(1., std::round((upper[d] - lower[d]) / size));
  }



  template <int dim>
  double SolidShape<dim>::estimate_size(const double size, const unsigned int degree) const
  {
    if (!file_cells.empty())
      return degree == 1 ? file_vertices.size() : file_vertices.size() + 1.5 * file_cells.size();
    double n = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      n *= degree * n_elements_along(d, size) + 1.;
    return n;
  }



  template <int dim>
  void SolidShape<dim>::append(const double size, const unsigned int body, std::vector<Point<dim>> &vertices,
                               std::vector<CellData<dim>> &cells) const
  {
    const unsigned int first = vertices.size();
    if (!file_cells.empty())
    {
      vertices.insert(vertices.end(), file_vertices.begin(), file_vertices.end());
      for (CellData<dim> cell : file_cells)
      {
        for (unsigned int &vertex : cell.vertices)
          vertex += first;
        cell.material_id = body;
        cells.push_back(cell);
      }
      return;
    }

    std::array<unsigned int, dim> n;
    unsigned int n_vertices = 1, n_boxes = 1;
    for (unsigned int d = 0; d < dim; ++d)
    {
      n[d] = n_elements_along(d, size);
      n_vertices *= n[d] + 1;
      n_boxes *= n[d];
    }
    const auto at = [](unsigned int number, const std::array<unsigned int, dim> &counts) {
      std::array<unsigned int, dim> place;
      for (unsigned int d = 0; d < dim; ++d)
      {
        place[d] = number % counts[d];
        number /= counts[d];
      }
      return place;
    };
    std::array<unsigned int, dim> n_points = n;
    for (unsigned int &count : n_points)
      ++count;
    for (unsigned int v = 0; v < n_vertices; ++v)
    {
      const auto place = at(v, n_points);
      Point<dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = lower[d] + (upper[d] - lower[d]) * place[d] / n[d];
      vertices.push_back(point);
    }

    std::vector<Simplex<dim>> simplices;
    const auto vertex = [&](const std::array<unsigned int, dim> &place) {
      unsigned int number = 0;
      for (unsigned int d = dim; d-- > 0;)
        number = number * n_points[d] + place[d];
      return first + number;
    };
    for (unsigned int b = 0; b < n_boxes; ++b)
      divide(at(b, n), vertex, simplices);
    for (Simplex<dim> simplex : simplices)
    {
      if (signed_volume<dim>(corners_of<dim>(simplex, vertices)) < 0.)
        std::swap(simplex[0], simplex[1]);
      CellData<dim> cell(dim + 1);
      std::copy(simplex.begin(), simplex.end(), cell.vertices.begin());
      cell.material_id = body;
      cells.push_back(cell);
    }
  }



  template class SolidShape<2>;
  template class SolidShape<3>;
} // namespace Lahar
