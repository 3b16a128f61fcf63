// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/cell_flow.h>
#include <lahar/assembly/fluid_structure.h>
#include <lahar/particles/fluid_set.h>

namespace Lahar
{
  namespace
  {
    /// Call @p action with the number, the Thixotropy and the particles' λ of each thixotropic fluid.
    template <int dim, typename Action>
    void for_each_structure(const Materials &materials, ParticleCloud<dim> &cloud, const Action &action)
    {
      for (unsigned int fluid = 0; fluid < cloud.structure.size(); ++fluid)
        if (const Thixotropy &law = materials.law(fluid).thixotropy(); law.is_there())
          action(fluid, law, cloud.structure[fluid]);
    }

    /// A sum and how much it is the sum of.
    struct Mean
    {
      double sum = 0., weight = 0.;

      void add(const double value, const double its_weight = 1.)
      {
        sum += its_weight * value;
        weight += its_weight;
      }

      double value(const double otherwise) const
      {
        return weight > 0. ? sum / weight : otherwise;
      }
    };

    /// The mean over a cell's corners that have a λ.
    template <int dim>
    Mean mean_of_corners(const Simplex<dim> &cell, const std::vector<double> &structure)
    {
      Mean mean;
      for (const unsigned int i : cell)
        if (structure[i] >= 0.)
          mean.add(structure[i]);
      return mean;
    }
  } // namespace



  template <int dim>
  void FluidStructure<dim>::prepare(const Materials &materials, ParticleCloud<dim> &cloud)
  {
    if (materials.any_thixotropic())
      cloud.structure.assign(materials.n_fluids(),
                             std::vector<double>(cloud.size(), ParticleCloud<dim>::no_structure));
  }



  template <int dim>
  void FluidStructure<dim>::refresh(const std::uint64_t first_number, const Materials &materials,
                                    ParticleCloud<dim> &cloud)
  {
    for_each_structure(materials, cloud,
                       [&](const unsigned int, const Thixotropy &law, std::vector<double> &structure) {
                         for (unsigned int i = 0; i < cloud.size(); ++i)
                           if (cloud.number[i] >= first_number)
                             structure[i] = law.initial_structure();
                       });
  }



  template <int dim>
  void FluidStructure<dim>::complete(const FluidMesh<dim> &mesh, const Materials &materials,
                                     const Migration<dim> &migration, ParticleCloud<dim> &cloud)
  {
    for_each_structure(materials, cloud,
                       [&](const unsigned int fluid, const Thixotropy &law, std::vector<double> &structure) {
                         const auto belongs = [&](const unsigned int i) {
                           return cloud.kind[i] == ParticleKind::fluid &&
                                  (cloud.part[i] & fluid_set(fluid)) != 0U;
                         };
                         for (unsigned int i = 0; i < cloud.size(); ++i)
                           if (belongs(i) && structure[i] < 0.)
                             structure[i] = law.initial_structure();
                         std::vector<bool> has_cell(cloud.size(), false);
                         std::vector<Mean> means(cloud.size());
                         for (unsigned int c = 0; c < mesh.n_cells(); ++c)
                           if (mesh.fluid(c) == fluid)
                           {
                             const Mean mean = mean_of_corners<dim>(mesh.particle_cells()[c], structure);
                             for (const unsigned int i : mesh.particle_cells()[c])
                             {
                               has_cell[i] = true;
                               means[i].sum += mean.sum;
                               means[i].weight += mean.weight;
                             }
                           }
                         for (unsigned int i = 0; i < cloud.size(); ++i)
                           if (!has_cell[i] && !belongs(i))
                             structure[i] = ParticleCloud<dim>::no_structure;
                           else if (structure[i] < 0.)
                             structure[i] = means[i].value(law.initial_structure());
                         migration.update(structure);
                       });
  }



  template <int dim>
  void FluidStructure<dim>::advance(const FluidMesh<dim> &mesh, const Materials &materials,
                                    const double time_step, const Migration<dim> &migration,
                                    ParticleCloud<dim> &cloud)
  {
    if (cloud.structure.empty())
      return;
    std::vector<double> rates, volumes; // by cell
    for (const Simplex<dim> &corners : mesh.particle_cells())
    {
      const CellFlow<dim> cell(corners_of<dim>(corners, cloud.position), corners, cloud.velocity,
                               cloud.pressure);
      rates.push_back(cell.strain_rate());
      volumes.push_back(std::max(0., cell.volume()));
    }
    for_each_structure(materials, cloud,
                       [&](const unsigned int fluid, const Thixotropy &law, std::vector<double> &structure) {
                         std::vector<Mean> rate(cloud.size());
                         for (unsigned int c = 0; c < mesh.n_cells(); ++c)
                           if (mesh.fluid(c) == fluid)
                             for (const unsigned int i : mesh.particle_cells()[c])
                               rate[i].add(rates[c], volumes[c]);
                         for (unsigned int i = 0; i < cloud.size(); ++i)
                           if (structure[i] >= 0.)
                             structure[i] = law.after(structure[i], rate[i].value(0.), time_step);
                         migration.update(structure);
                       });
  }



  template <int dim>
  std::vector<double> FluidStructure<dim>::of_cells(const FluidMesh<dim> &mesh, const Materials &materials,
                                                    const ParticleCloud<dim> &cloud)
  {
    if (cloud.structure.empty())
      return {};
    std::vector<double> result(mesh.n_cells(), 0.);
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      if (const Thixotropy &law = materials.law(mesh.fluid(c)).thixotropy(); law.is_there())
        result[c] = mean_of_corners<dim>(mesh.particle_cells()[c], cloud.structure[mesh.fluid(c)])
                      .value(law.initial_structure());
    return result;
  }



  template struct FluidStructure<2>;
  template struct FluidStructure<3>;
} // namespace Lahar
