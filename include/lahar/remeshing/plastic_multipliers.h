// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_plastic_multipliers_h
#define lahar_remeshing_plastic_multipliers_h

#include <lahar/remeshing/cell_table.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>

#include <vector>

namespace Lahar
{
  /**
   * The multipliers Λ of an exact yield stress (ExactPlasticStress) from step to step.
   *
   * Any Λ with |Λ| ≤ 1 leads to the same velocities, a good one at once: a cell that remeshing keeps keeps its own, so that
   * fluid that stands stays in equilibrium to the last digit. A cell that remeshing makes gets the mean over its
   * corners that were there before, each of which has the mean of its old cells of the same fluid weighted by their
   * volumes; |Λ| ≤ 1 holds for means, too. Cells of other fluids, whose Λ are stresses over another yield stress, say
   * nothing, and the cell starts from zero where there are no others.
   *
   * A rank has those of the cells that it knows; those of its own cells are right, and go with them (Migration).
   */
  template <int dim>
  class PlasticMultipliers
  {
  public:
    using Value = SymmetricTensor<2, dim>;

    /// By cell of the mesh; empty where there are none.
    const std::vector<Value> &values() const
    {
      return of_cells;
    }

    /// The same by the cells' particles.
    CellTable<dim> &table()
    {
      return by_particles;
    }

    /// Take over those of the cells of @p mesh.
    void set(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud, std::vector<Value> values);

    /// Note the particles' means of each of @p n_fluids fluids before remeshing. Collective.
    void spread(const FluidMesh<dim> &mesh, const unsigned int n_fluids, const ParticleCloud<dim> &cloud,
                const Migration<dim> &migration);

    /// Find those of the cells that @p mesh has now.
    void follow(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud);

  private:
    /// Whether the cell was of another fluid before remeshing.
    bool is_of_other(const typename CellTable<dim>::Key &key, const unsigned int fluid) const;

    std::vector<Value> of_cells;
    CellTable<dim> by_particles;
    std::vector<std::vector<std::pair<std::uint64_t, Value>>>
      means; ///< by fluid, and by particles' numbers, ascending
    std::vector<std::pair<typename CellTable<dim>::Key, unsigned int>>
      old_fluids; ///< of the cells before remeshing, where there are several; ascending
  };
} // namespace Lahar

#endif
