// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/boundary_shape.h>
#include <lahar/geometry/surface_file.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The triangles of a drawing, all one wall.
  class SurfaceBoundary : public BoundaryShape<3>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_file("File", "A surface: STL (text or binary), OBJ, PLY or OFF; the ending says which.");
      prm.declare_positive("Scale", "1",
                           "Factor for the file's coordinates, above zero: 1e-3 for a drawing in mm.");
      prm.declare_vector(
        "Origin", "0, 0, 0", 3,
        "Point 'x, y, z' of the scaled drawing that is the origin of the case: it is subtracted.");
      prm.declare_positive(
        "Spacing", "0",
        "Length in m of the edges of new triangles that take the place of the file's; sharp edges, "
        "above 30°, and rims keep their places. 0: the file's triangles.");
    }

    void parse_parameters(Parameters &prm) override
    {
      const std::string file = prm.get("File");
      if (file.empty())
        prm.throw_wrong_value("File", "the name of an STL, OBJ, PLY or OFF file");
      path = prm.path("Scale");
      const SurfaceFile surface(file, prm.get_positive("Scale"), prm.get_positive("Spacing", true),
                                prm.path("Spacing"));
      const Tensor<1, 3> origin = prm.get_vector<3>("Origin");
      remarks                   = surface.remarks();
      shape.mesh_facets         = surface.triangles();
      for (auto &triangle : shape.mesh_facets)
        for (Point<3> &corner : triangle)
          corner -= origin;
    }

    std::vector<WallShape<3>> walls() const override
    {
      return {shape};
    }

    std::vector<std::string> check_scale(const std::string &, const double) const override
    {
      return remarks;
    }

    std::string scale_path() const override
    {
      return path;
    }

  private:
    WallShape<3> shape;
    std::vector<std::string> remarks;
    std::string path;
  };



  static const Factory<BoundaryShape<3>>::Registration<SurfaceBoundary>
    surface("surface", "The surface of a drawing: STL, OBJ, PLY.");
} // namespace Lahar
