// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/solid_shape.h>
#include <lahar/utilities/factory.h>

#include <array>
#include <cmath>

namespace Lahar
{
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



  /**
   * A box of n_x × n_y (× n_z) rectangles with two triangles in each, whose diagonals alternate (five tetrahedra in 3D).
   */
  template <int dim>
  class BoxSolid : public SolidShape<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list("Corners", "", ':',
                       std::string("Two opposite corners ") +
                         (dim == 2 ? "'x, y : x, y'" : "'x, y, z : x, y, z'") + ". Lengths in m.");
      prm.declare_list("Elements", "", ',',
                       std::string("Numbers of elements along ") + (dim == 2 ? "x and y" : "x, y and z") +
                         ", 1 to 10000, separated by commas; empty: as many as the mesh size asks for.");
    }

    void parse_parameters(Parameters &prm) override;

    Box<dim> box() const override
    {
      return Box<dim>(lower, upper);
    }

    double estimate_size(const double size, const unsigned int degree) const override
    {
      double n = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        n *= degree * n_elements_along(d, size) + 1.;
      return n;
    }

    void append(const double size, const unsigned int body, std::vector<Point<dim>> &vertices,
                std::vector<CellData<dim>> &cells) const override;

  private:
    /// Number of elements along direction @p d.
    double n_elements_along(const unsigned int d, const double size) const
    {
      return n_elements[d] > 0 ? n_elements[d] : std::max(1., std::round((upper[d] - lower[d]) / size));
    }

    Point<dim> lower, upper;
    std::array<unsigned int, dim> n_elements = {}; ///< 0: from the size
  };



  template <int dim>
  void BoxSolid<dim>::parse_parameters(Parameters &prm)
  {
    const std::vector<Box<dim>> boxes = parse_boxes<dim>(prm, "Corners");
    const std::string allowed         = "two opposite corners that differ in every coordinate";
    if (boxes.size() != 1)
      prm.throw_wrong_value("Corners", allowed);
    lower = boxes[0].lower;
    upper = boxes[0].upper;
    for (unsigned int d = 0; d < dim; ++d)
      if (!(upper[d] > lower[d]))
        prm.throw_wrong_value("Corners", allowed);
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
  void BoxSolid<dim>::append(const double size, const unsigned int body, std::vector<Point<dim>> &vertices,
                             std::vector<CellData<dim>> &cells) const
  {
    const unsigned int first = vertices.size();
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



  static const Factory<SolidShape<2>>::Registration<BoxSolid<2>> box_solid_2d("box",
                                                                              "A rectangle of triangles.");
  static const Factory<SolidShape<3>>::Registration<BoxSolid<3>> box_solid_3d("box",
                                                                              "A cuboid of tetrahedra.");
} // namespace Lahar
