// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_postprocessor_h
#define lahar_postprocess_postprocessor_h

#include <deal.II/base/table_handler.h>

#include <lahar/geometry/walls.h>
#include <lahar/material/materials.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/postprocess/time_means.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>
#include <lahar/solid/solids.h>

#include <memory>
#include <vector>

namespace Lahar
{
  /**
   * The state after a step, as postprocessors see it.
   *
   * On several ranks cloud and mesh are what this rank knows. Sums run over what is its own (ParticleCloud::is_own(), of
   * particles and of cells), and then over the ranks; all evaluations are collective.
   */
  template <int dim>
  struct Snapshot
  {
    const ParticleCloud<dim> &cloud;
    const FluidMesh<dim> &mesh;
    const Materials &materials;
    const Tensor<1, dim> &gravity;
    const Solids<dim> &solids;
    const Walls<dim> &walls;
    const Migration<dim> &migration;
    TimeMeans &means; ///< since the last snapshot that was due
    double time                       = 0.;
    const CellTable<dim> *multipliers = nullptr; ///< Λ of an exact yield stress, see PlasticMultipliers
    /// By boundary: mean force of the fluid on what stands behind an outlet, N; empty where nothing does.
    const std::vector<Tensor<1, dim>> *outlet_forces = nullptr;

    /// The law of a cell of the mesh.
    const FluidLaw &law(const unsigned int cell) const
    {
      return materials.law(mesh.fluid(cell));
    }

    const MPI_Comm &communicator() const
    {
      return migration.communicator();
    }

    double sum_of_ranks(const double value) const
    {
      return Utilities::MPI::sum(value, communicator());
    }
  };

  /**
   * Adds columns to the line that each step writes to the statistics.
   *
   * A model of this kind registers itself with Factory<Postprocessor<dim>>; its parameters stand in the subsection of
   * its name in "Postprocess". Every model is there in every run; without entries it adds no columns.
   */
  template <int dim>
  class Postprocessor
  {
  public:
    virtual ~Postprocessor() = default;

    /// Read the model's own subsection. Not called for a model without entries.
    virtual void parse_parameters(Parameters & /*prm*/) {}

    /// Called once, when particles, walls and solids are where the run begins.
    virtual void initialize(const Snapshot<dim> & /*start*/) {}

    /// Add this step's values to @p statistics, the same columns in every step.
    virtual void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const = 0;

    static void declare_all(Parameters &prm);
    static std::vector<std::unique_ptr<Postprocessor>> create_all(Parameters &prm);
  };

  /// Add the columns '@p what x (N)' … of a step's mean @p force (N), the same on all ranks, and 'mean @p what x (N)' … of
  /// its mean since the last snapshot that was due, both behind @p whose.
  template <int dim>
  void add_force_columns(TableHandler &statistics, const Snapshot<dim> &snapshot, const std::string &whose,
                         const std::string &what, const Tensor<1, dim> &force);

  /// Add one number to a column that is printed with nine digits.
  void add_to_column(TableHandler &statistics, const std::string &column, const double value);
} // namespace Lahar

#endif
