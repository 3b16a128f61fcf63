// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_solid_solids_h
#define lahar_solid_solids_h

#include <lahar/geometry/mesh_size.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/solid/solid_body.h>
#include <lahar/solid/solid_mesh.h>
#include <lahar/solid/solid_state.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * All solids of a case: their bodies, the mesh that they share, and their state.
   *
   * Node i of the contour is particle i of the cloud: the solids' particles come first in it and are never removed.
   */
  template <int dim>
  class Solids
  {
  public:
    /// Declare subsection "Solids" with bodies of these names. @throws InputError if a name is that of an entry.
    static void declare_parameters(Parameters &prm, const std::vector<std::string> &names);

    /// @throws InputError
    void parse_parameters(Parameters &prm, const std::vector<std::string> &names);

    /**
     * Make mesh and state at @p time (s). @param mesh_size the fluid's; a box takes the smallest one in it.
     * @throws InputError if there would be too many nodes, if a part of the contour that is named holds nothing, if
     * elements do not fit together (a node of the contour on a face of another element), if solids touch.
     * @return warnings for the user: coarse contours, and solids on which nothing acts. @p is_loaded: there is fluid or
     * gravity.
     */
    std::vector<std::string> create(const MeshSize<dim> &mesh_size, const double time, const bool is_loaded);

    /// Append the contour's particles to an empty cloud, slick ones of the bodies that are @p slick. Their spacing is the
    /// longest edge of the contour at them, or the mesh size if that is larger.
    void append_particles(const MeshSize<dim> &mesh_size, const std::vector<bool> &slick,
                          ParticleCloud<dim> &cloud) const;

    bool empty() const
    {
      return bodies.empty();
    }

    const SolidMesh<dim> &mesh() const
    {
      return *solid_mesh;
    }

    const std::vector<SolidBody<dim>> &all_bodies() const
    {
      return bodies;
    }

    const SolidLaw &law(const unsigned int body) const
    {
      return *bodies[body].law;
    }

    const SolidState<dim> &state() const
    {
      return present;
    }

    /// Whether the velocity of a node is prescribed.
    bool is_fixed(const unsigned int node) const
    {
      return clamped[node] || driven[node];
    }

    /// The prescribed velocity of a node at @p time.
    Tensor<1, dim> prescribed_velocity(const unsigned int node, const double time) const;

    /// The loads' force on each node at @p time, N (N/m in 2D): ∫ N_I T over the undeformed contour. Empty without
    /// loads.
    std::vector<Tensor<1, dim>> external_forces(const double time) const;

    /// Take a new state.
    void accept(const SolidState<dim> &state)
    {
      present = state;
    }

    /// Give the particles of the contour position and velocity of their nodes. Where @p in_mesh (by particle) says that
    /// no fluid touches them, they have no pressure and the solid's acceleration.
    void move_particles(const std::vector<bool> &in_mesh, ParticleCloud<dim> &cloud) const;

    /// The longest distance of two nodes of one cell at present, m; zero without solids.
    double longest_edge() const;

    /// Newmark's γ of the solids.
    double newmark_gamma() const
    {
      return gamma;
    }

    /// How far the feet of solids that stand on a ground lie off it between their nodes, m: about the most at the
    /// middles of facets and their edges.
    double unevenness() const
    {
      return uneven;
    }

  private:
    void check_contour() const;

    /// Find where nodes are in the drawing, whose mesh has these vertices.
    void find_drawn(const std::vector<Point<dim>> &vertices);
    void find_unevenness();

    /// The middle of a face in the drawing.
    Point<dim> drawn_middle(const typename DoFHandler<dim>::active_cell_iterator &cell,
                            const unsigned int face) const;

    std::vector<SolidBody<dim>> bodies;
    unsigned int degree = 2;
    double gamma        = 0.5;

    std::unique_ptr<SolidMesh<dim>> solid_mesh;
    SolidState<dim> present;
    std::vector<bool> clamped, driven;
    double tolerance       = 0.; ///< for nodes that touch, m
    double place_tolerance = 0.; ///< for parts of the contour in boxes, m
    bool any_loads         = false;
    unsigned int max_nodes = 0;
    std::vector<Point<dim>> drawn; ///< by node: its undeformed place before it was raised, see SolidBody
    double uneven = 0.;            ///< m
  };
} // namespace Lahar

#endif
