// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_old_domain_h
#define lahar_remeshing_old_domain_h

#include <deal.II/base/array_view.h>

#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <optional>
#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * The domain of the fluid before a remeshing: the cells of the last mesh where the flow has carried them.
   *
   * It keeps coordinates, so it outlives the removal of particles.
   */
  template <int dim>
  class OldDomain
  {
  public:
    OldDomain(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh);

    /**
     * Follow a change of the particles.
     *
     * @param new_index for each old particle its new index or numbers::invalid_unsigned_int.
     * @param parents old indices of the parents of the inserted particles, which stand at the end.
     */
    void renumber(const std::vector<unsigned int> &new_index,
                  const std::vector<std::pair<unsigned int, unsigned int>> &parents,
                  const unsigned int n_particles);

    /// Whether the particle was a vertex of the last mesh (an inserted one: its parents).
    bool was_wet(const unsigned int particle) const
    {
      return seeds[particle].first != numbers::invalid_unsigned_int &&
             cells_of(seeds[particle].first).size() > 0;
    }

    /// Whether the edges that its corners share with the last mesh join them all: then the simplex lies in a hollow of
    /// one surface; else it bridges a gap between two.
    bool joins(const Simplex<dim> &simplex) const;

    /**
     * Whether the simplex of the given particles was fluid: it is one of the old cells, or its centroid lies in one of
     * those around its corners or in one of the cells around these.
     */
    bool contains(const Simplex<dim> &simplex, const Point<dim> &centroid) const
    {
      return find_cell(simplex, centroid) != numbers::invalid_unsigned_int;
    }

    /// The number of the fluid there; none if it was no fluid.
    std::optional<unsigned int> fluid_at(const Simplex<dim> &simplex, const Point<dim> &centroid) const;

    /**
     * Whether the way from a fluid corner of the simplex to the @p centroid leaves the old domain through a face between
     * corners that are all walls' or solids': the hollow behind it, in an edge or corner where walls meet, was no fluid for
     * lack of a fluid corner only. For simplices that neither pass through a wall nor have a corner that was not wet.
     */
    bool leads_into_hollow(const Simplex<dim> &simplex, const Point<dim> &centroid,
                           const ParticleCloud<dim> &cloud) const;

    /// The present index of a particle of the last mesh; of a removed one a number beyond all present particles.
    unsigned int present(const unsigned int old) const
    {
      return new_index[old];
    }

    /// The old indices of the parents of an inserted particle; of another one its own, twice.
    std::pair<unsigned int, unsigned int> parents(const unsigned int particle) const
    {
      return seeds[particle];
    }

    /// A cell of the last mesh in the numbering of the present particles.
    struct OldCell
    {
      Simplex<dim> corners; ///< removed particles have numbers of their own beyond all others
      double volume;
      bool own; ///< by ParticleCloud::is_own()
    };

    /// The cells of the last mesh in their order.
    std::vector<OldCell> renumbered_cells() const;

    /// The present particles that had a cell together with @p particle, a present one or a corner of an OldCell.
    std::vector<unsigned int> old_neighbours(const unsigned int particle) const;

  private:
    struct Cell
    {
      Simplex<dim> corners; ///< old indices
      double volume;
      unsigned int fluid;
      bool own;
    };

    /// The cell that the simplex is, its corners in canonical() order, which renumbering keeps; invalid if there is none.
    unsigned int same_cell(const Simplex<dim> &simplex) const;
    /// The cell that contains() finds; invalid if there is none.
    unsigned int find_cell(const Simplex<dim> &simplex, const Point<dim> &centroid) const;
    bool is_inside(const unsigned int cell, const Point<dim> &point) const;
    bool share_cell(const unsigned int a, const unsigned int b) const;

    /// The cells around a particle of the last mesh.
    ArrayView<const unsigned int> cells_of(const unsigned int old) const
    {
      return {around.data() + first_around[old], first_around[old + 1] - first_around[old]};
    }

    std::vector<Cell> cells;
    std::vector<Point<dim>> position;                       ///< by old index
    std::vector<unsigned int> around;                       ///< the cells around one particle after the other
    std::vector<unsigned int> first_around;                 ///< by old index, and the end
    std::vector<std::array<Point<dim>, dim>> closed_faces;  ///< without a fluid corner
    std::vector<std::vector<unsigned int>> closed_faces_of; ///< by old index
    std::vector<std::pair<unsigned int, unsigned int>>
      seeds;                             ///< by new index: old index (twice) or the parents'
    std::vector<unsigned int> new_index; ///< by old index; of a removed particle one beyond all others
  };
} // namespace Lahar

#endif
