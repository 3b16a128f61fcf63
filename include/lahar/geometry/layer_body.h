// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_layer_body_h
#define lahar_geometry_layer_body_h

#include <lahar/geometry/mesh_body.h>

#include <array>
#include <vector>

namespace Lahar
{
  /// A point of the ground and the depth of fluid above it, m, measured upwards.
  struct GroundPoint
  {
    Point<3> place;
    double depth = 0.;
  };

  /// A triangle of the ground, counterclockwise seen from above, on which depth is linear.
  using GroundPiece = std::array<GroundPoint, 3>;

  /// The part of @p piece, as triangles, on which the linear function with these @p values at its corners is positive.
  /// Values within @p tolerance of zero are zero.
  std::vector<GroundPiece> positive_part(const GroundPiece &piece, const std::array<double, 3> &values,
                                         const double tolerance);

  /**
   * A layer of fluid on triangulated ground: prisms with vertical edges, sharp where depth falls to zero.
   *
   * Its particles stand above each other: the ground's plan is filled at the distance h, measured along the ground, with
   * a particle on the ground and, where there is room for it, one on the surface above each point. The inside is filled as
   * that of other bodies.
   */
  class LayerBody : public MeshBody<3>
  {
  public:
    /// @param pieces of the ground, all counterclockwise; some depth must be above zero.
    LayerBody(const std::string &name, const std::vector<GroundPiece> &pieces);

    double roughness() const override;
    DividedPoints<3> fill(const MeshSize<3> &h, const MPI_Comm &communicator) const override;

    /// The largest depth.
    double depth() const;

  private:
    /// The pieces with their corners numbered, each once.
    struct Ground
    {
      explicit Ground(const std::vector<GroundPiece> &pieces);

      std::vector<Point<3>> prism_nodes() const;
      std::vector<Simplex<3>> prisms() const;

      std::vector<GroundPoint> nodes;
      std::vector<Point<2>> plan; ///< of the nodes
      std::vector<Simplex<2>> triangles;
    };

    LayerBody(const std::string &name, const Ground &ground);

    /// The ground under a point of the plan, up to rounding.
    GroundPoint at(const Point<2> &point) const;

    Ground ground;
    MeshBody<2> plan;
    double slope = 1.; ///< area of the ground over that of its plan, the root of it
    RTree<std::pair<BoundingBox<2>, unsigned int>> triangle_tree;
  };
} // namespace Lahar

#endif
