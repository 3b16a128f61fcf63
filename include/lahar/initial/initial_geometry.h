// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_initial_initial_geometry_h
#define lahar_initial_initial_geometry_h

#include <lahar/boundary/inlets.h>
#include <lahar/boundary/outlets.h>
#include <lahar/boundary/solid_contour.h>
#include <lahar/boundary/wall_separation.h>
#include <lahar/boundary/wall_step.h>
#include <lahar/geometry/divided_points.h>
#include <lahar/geometry/initial_region.h>
#include <lahar/geometry/narrow_gap.h>
#include <lahar/initial/boundary.h>
#include <lahar/initial/fluid.h>
#include <lahar/material/materials.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/utilities/case_structure.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The fluids of a case at the start, and its rigid boundaries.
   *
   * Fluids are bodies (FluidShape), boundaries walls (BoundaryShape). Bodies are filled with particles at the mesh
   * size; what lies within 0.1 h of a wall is put onto it, a hair off it on the body's side (contact_offset). Sharp
   * edges of walls to which fluid sticks carry particles (points_on_sharp_edges()). What lies within 0.1 h of a solid
   * or of a wall that carries particles all over touches it: no fluid particle stands there, the wall's particles are
   * the fluid's boundary, whatever the distance of the fluid's own points is. Where a body touches such a wall, the
   * wall's particles are the body's: in the plane its corners, in space all its points on the wall; so a level surface
   * meets the wall at its height. Of a mesh of the plane these are the ends of the rows of its edges along the wall.
   * Where a wall passes along a solid's contour, it has no particles; the first ones beside the solid stand at their
   * usual distance from it.
   */
  template <int dim>
  class InitialGeometry
  {
  public:
    /// Declare 'Largest number of particles' and the subsections "Fluids" and "Boundaries".
    static void declare_parameters(Parameters &prm, const CaseStructure &structure);

    /// Read them. @throws InputError for a wrong value, an unknown file, too many fluids or, unless there are solids, if
    /// there is no fluid.
    void parse_parameters(Parameters &prm, const CaseStructure &structure);

    bool has_fluid() const
    {
      return !bodies.empty();
    }

    /**
     * Fill @p walls and, after the solids' particles that are there already, @p cloud with spacing @p h (m). Fluid has its
     * initial velocity. Each rank gets those that are first its own (first_owner()); the particles and their numbers
     * are the same for any number of ranks. Collective.
     * @throws InputError if a body is smaller than @p h, if there would be too many particles, if bodies,
     * walls and solids overlap.
     */
    void create(const MeshSize<dim> &h, const SolidContour<dim> &solids, ParticleCloud<dim> &cloud,
                Walls<dim> &walls, const MPI_Comm &communicator = MPI_COMM_SELF) const;

    /// Whether a simplex of the particles that create() made belongs to the bodies (InitialRegion), or to the gap below
    /// 0.1 h between one of them and a wall or solid. Valid as long as this object.
    std::function<bool(const Simplex<dim> &, const ParticleCloud<dim> &)> region() const;

    /// The laws of the fluids, which this object has; of water, if there are none. Named fluids whose laws have the same
    /// entries are one fluid.
    Materials materials() const;

    /// The same laws, for what they choose step by step; none if there are no fluids.
    std::vector<FluidLaw *> laws();

    /// The names of each of them, joined by "and".
    std::vector<std::string> fluid_names() const;

    /// Put particles of several fluids, which the first mesh has got between its fluids, onto these fluids' contours, where
    /// they are near.
    void put_on_interfaces(ParticleCloud<dim> &cloud) const;

    /// The fluids of the cells of the first mesh of the particles that create() made, where there are several fluids.
    std::vector<unsigned int> cell_fluids(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud) const;

    const std::vector<Boundary<dim>> &all_boundaries() const
    {
      return boundaries;
    }

    /// The laws of the boundaries' surfaces, in their order.
    std::vector<const SurfaceLaw *> surface_laws() const;

    /// By boundary: the normal tension that it bears before fluid leaves it, Pa; none where fluid does not.
    TensileStrengths tensile_strengths() const;

    bool any_boundary_moves() const;

    /// What comes in through each boundary.
    std::vector<typename Inlets<dim>::Source> inflows() const;

    /// Where fluid leaves. @throws InputError
    Outlets<dim> outlets() const;

    /// The walls that create() makes, as they are at @p time (s). @throws RunError if a motion is not finite then.
    Walls<dim> walls_at(const double time) const;

    /// The walls in a step that begins at @p time with @p walls, which must outlive the result. @throws RunError as above.
    WallStep<dim> wall_step(const Walls<dim> &walls, const double time, const double time_step) const;

    /// How messages call the wall that facet @p facet of create()'s walls belongs to.
    std::string wall_name(unsigned int facet) const;

    /// The narrowest gap between walls and @p solids with fewer than @p most mesh sizes across.
    std::optional<NarrowGap<dim>> narrow_gap(const MeshSize<dim> &h, const SolidContour<dim> &solids,
                                             const double most) const;

    /// Of all bodies (area in 2D).
    double fluid_volume() const
    {
      return InitialRegion<dim>(bodies).volume();
    }

    /// What is odd about the boundaries at the spacing @p h (m), see Boundary::warnings().
    std::vector<std::string> warnings(const double h) const;

  private:
    /// The points of each body, of which each rank has those in its part of space.
    using Fillings = std::vector<DividedPoints<dim>>;

    /// Add the axis of rotational symmetry to the boundaries, see make_axis(). @throws InputError for fluid at x < 0
    void add_axis(Parameters &prm);
    /// The first particles in the order of their numbers.
    struct Seeds
    {
      // The solids', the walls' and those at the bodies' corners, which all ranks have: of fluid the part is the number of
      // its body.
      std::vector<Point<dim>> position;
      std::vector<ParticleKind> kind;
      std::vector<unsigned int> part;
      DividedPoints<dim> inside;        ///< the bodies'
      std::vector<unsigned int> behind; ///< by body: one behind its last number inside

      /// One of those that all ranks have.
      void append(const Point<dim> &place, const ParticleKind new_kind, const unsigned int new_part)
      {
        position.push_back(place);
        kind.push_back(new_kind);
        part.push_back(new_part);
      }

      /// Keep those that stand, and number them without gaps; the first @p n_solid ones stay. Collective.
      void keep(const std::vector<bool> &stands, const std::vector<bool> &stands_inside,
                const unsigned int n_solid, const MPI_Comm &communicator);

      /// Of a number of those inside.
      unsigned int body(const unsigned int number) const
      {
        return std::upper_bound(behind.begin(), behind.end(), number) - behind.begin();
      }
    };

    /// Behind those of the solids, which @p cloud has; and fill @p walls.
    Seeds place_seeds(const MeshSize<dim> &h, const SolidContour<dim> &solids,
                      const ParticleCloud<dim> &cloud, Walls<dim> &walls, const MPI_Comm &communicator) const;

    /// The points of all bodies; of those inside none is so near to another fluid that an interface would not be Delaunay.
    Fillings fill_bodies(const MeshSize<dim> &h, const MPI_Comm &communicator) const;

    /// Where fluids touch each other, and no wall is between, their particles belong to all of them.
    void mark_interfaces(const Walls<dim> &walls, ParticleCloud<dim> &cloud) const;

    /// The number, among those of different laws, of the fluid that comes in. @throws InputError if there is none of that name.
    unsigned int fluid_number(const Inflow &inflow) const;

    void check_body_sizes(const double h) const;
    void check_number_of_particles(const MeshSize<dim> &mesh_size) const;
    void check_overlaps(const Fillings &fillings, const double h, const MPI_Comm &communicator) const;
    /// @throws InputError if fluid comes in inside a rigid body, or twice in one place.
    void check_inflows(const double h) const;
    /// @throws InputError if the fluid touches two boundaries that stand in one place.
    void check_common_faces(const Fillings &fillings, const double h, const MPI_Comm &communicator) const;
    void check_solids(const Fillings &fillings, const SolidContour<dim> &solids, const double h,
                      const MPI_Comm &communicator) const;

    /// Points where bodies and solids touch @p wall.
    std::vector<Point<dim>> contacts(const WallShape<dim> &wall, const Fillings &fillings,
                                     const SolidContour<dim> &solids, const MeshSize<dim> &h,
                                     const MPI_Comm &communicator) const;

    /// Fill @p walls. @return the particles of those without slip, and the numbers of their boundaries.
    std::vector<std::pair<Point<dim>, unsigned int>>
    create_walls(const MeshSize<dim> &h, const Fillings &fillings, const SolidContour<dim> &solids,
                 Walls<dim> &walls, const MPI_Comm &communicator) const;

    std::vector<Fluid<dim>> fluids;
    std::vector<Boundary<dim>> boundaries;
    typename FluidShape<dim>::Bodies bodies; ///< of all fluids
    std::vector<unsigned int> fluid_of;      ///< by body
    std::vector<unsigned int> material_of;   ///< by named fluid: its number among those of different laws

    /// The number of different laws.
    unsigned int n_materials() const
    {
      return material_of.empty() ? 0 : 1 + *std::max_element(material_of.begin(), material_of.end());
    }

    /// Of a body, among the different laws.
    unsigned int material(const unsigned int body) const
    {
      return material_of[fluid_of[body]];
    }

    std::vector<WallShape<dim>> wall_shapes; ///< of all boundaries
    unsigned int max_particles = 0;
  };
} // namespace Lahar

#endif
