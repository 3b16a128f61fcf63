// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/cell_fluid.h>
#include <lahar/remeshing/interface_segments.h>
#include <lahar/remeshing/local_delaunay.h>
#include <lahar/remeshing/remesher.h>
#include <lahar/remeshing/solid_interior.h>
#include <lahar/remeshing/thin_films.h>
#include <lahar/remeshing/wall_segments.h>
#include <lahar/remeshing/wall_sides.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  void Remesher<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Remeshing");
    prm.declare_bool("Keep volume", true,
                     "Whether particles of the free surface move so that remeshing changes no volume.");
    AlphaShape<dim>::declare_parameters(prm);
    ParticleSpacing<dim>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  void Remesher<dim>::parse_parameters(Parameters &prm)
  {
    prm.enter_subsection("Remeshing");
    if (prm.get("Keep volume") != "true" && prm.get("Keep volume") != "false")
      prm.throw_wrong_value("Keep volume", "true|false");
    keep_volume = prm.get("Keep volume") == "true";
    alpha_shape.parse_parameters(prm);
    particle_spacing.parse_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  double Remesher<dim>::region_distance(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                                        const double longest_other_edge, const MPI_Comm &communicator) const
  {
    double largest_spacing = 0., longest_edge_square = 0.;
    for (const double h : cloud.spacing)
      largest_spacing = std::max(largest_spacing, h);
    for (const Simplex<dim> &cell : mesh.particle_cells())
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = 0; b < a; ++b)
          longest_edge_square = std::max(longest_edge_square,
                                         cloud.position[cell[a]].distance_square(cloud.position[cell[b]]));
    const double reach        = Utilities::MPI::max(alpha_shape.reach() * largest_spacing, communicator),
                 longest_edge = Utilities::MPI::max(std::sqrt(longest_edge_square), communicator);
    return std::max(reach + 2. * longest_edge, 2. * std::max(reach, longest_other_edge) + 0.5 * longest_edge);
  }



  template <int dim>
  std::vector<Simplex<dim>>
  Remesher<dim>::own_candidates(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                const std::vector<Facet> &solid_facets, const Interfaces &interfaces,
                                const Migration<dim> &migration, unsigned int &n_forced) const
  {
    std::vector<bool> own(cloud.size(), false);
    double largest_spacing = 0.;
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      largest_spacing = std::max(largest_spacing, cloud.spacing[i]);
      own[i]          = cloud.is_own(i) && cloud.kind[i] == ParticleKind::fluid;
    }
    const double reach          = alpha_shape.reach() * largest_spacing;
    const auto is_own_candidate = [&](const Simplex<dim> &simplex) {
      return std::any_of(simplex.begin(), simplex.end(),
                         [&](const unsigned int i) { return cloud.kind[i] == ParticleKind::fluid; }) &&
             cloud.is_own(simplex) && alpha_shape.is_candidate(simplex, cloud);
    };

    n_forced = 0;
    if constexpr (dim == 2)
    {
      std::vector<Facet> segments = solid_facets;
      for (const Facet &segment : find_wall_segments(cloud, walls, 2. * reach))
        segments.push_back(segment);
      const unsigned int n_required = segments.size();
      for (const Facet &segment : interfaces(reach, segments))
        segments.push_back(segment);
      // All ranks take the same way: each waits for what the others ask of it.
      if (migration.is_alone() ? !segments.empty()
                               : Utilities::MPI::max(segments.size(), migration.communicator()) > 0)
      {
        std::vector<bool> forced;
        const auto candidates = local_constrained_delaunay({cloud, own, reach, is_own_candidate, migration},
                                                           segments, n_required, forced);
        for (unsigned int f = 0; f < solid_facets.size(); ++f)
          n_forced += (forced[f] && cloud.is_own(solid_facets[f][0]));
        return candidates;
      }
    }
    auto candidates = local_delaunay<dim>(cloud, own, reach, is_own_candidate, migration);
    if constexpr (dim == 3)
    {
      part_sides_of_walls(cloud, walls, reach, is_own_candidate, candidates);
      const SolidInterior<dim> inside(solid_facets, cloud);
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                      [&](const Simplex<dim> &simplex) {
                                        return inside.holds_edge_of(simplex, cloud);
                                      }),
                       candidates.end());
    }
    return candidates;
  }



  template <int dim>
  void Remesher<dim>::create_mesh(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                  const std::vector<Facet> &solid_facets, const Region &region,
                                  const Migration<dim> &migration, FluidMesh<dim> &mesh) const
  {
    unsigned int n_forced;
    std::vector<Simplex<dim>> cells;
    const Interfaces none = [](const double, const std::vector<Facet> &) { return std::vector<Facet>(); };
    for (const Simplex<dim> &simplex : own_candidates(cloud, walls, solid_facets, none, migration, n_forced))
      if (region(simplex, cloud) && alpha_shape.accepts_first(simplex, cloud, walls))
        cells.push_back(simplex);
    mesh.reinit(cloud, cells);
  }



  template <int dim>
  bool Remesher<dim>::adapt_first_particles(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                            const FluidMesh<dim> &mesh, Migration<dim> &migration) const
  {
    if (dim == 2)
      return false;
    OldDomain<dim> old_domain(cloud, mesh);
    return adapt_spacing(cloud, walls, mesh, old_domain, migration);
  }



  template <int dim>
  bool Remesher<dim>::adapt_spacing(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                    const FluidMesh<dim> &mesh, OldDomain<dim> &old_domain,
                                    Migration<dim> &migration) const
  {
    const bool changed = particle_spacing.adapt(cloud, walls, mesh, old_domain, migration);
    if (n_fluids > 1 && !migration.is_alone())
    {
      // A copy's cells may be incomplete at the rim of this rank's region.
      std::vector<double> parts(cloud.part.begin(), cloud.part.end());
      migration.update(parts);
      for (unsigned int i = 0; i < cloud.size(); ++i)
        cloud.part[i] = static_cast<unsigned int>(parts[i]);
    }
    return changed;
  }



  template <int dim>
  typename Remesher<dim>::OutsideVolumes Remesher<dim>::passed_on(const OutsideVolumes &before,
                                                                  const ParticleCloud<dim> &cloud,
                                                                  const FluidMesh<dim> &mesh) const
  {
    constexpr double smallest_change = 1e-10; // over h^dim; less is rounding
    OutsideVolumes result;
    if (!before.empty())
      for (const auto &[number, volume] : find_outside(cloud, mesh))
        if (const auto old = before.find(number); old != before.end())
          if (std::abs(volume - old->second) >
              smallest_change * std::pow(cloud.spacing[cloud.find(number)], dim))
            result[number] = volume - old->second;
    return result;
  }



  template <int dim>
  typename Remesher<dim>::Report Remesher<dim>::remesh(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                                       const std::vector<Facet> &solid_facets,
                                                       const double time_step, FluidMesh<dim> &mesh,
                                                       Migration<dim> &migration) const
  {
    Report report;
    if constexpr (dim == 2)
      if (n_fluids > 1)
        tear_thin_films(migration, mesh, cloud);
    OldDomain<dim> old_domain(cloud, mesh);
    const auto outside = find_outside ? find_outside(cloud, mesh) : OutsideVolumes();
    const auto faces   = dim == 2 ? find_interface_faces(mesh) : std::vector<InterfaceFace<dim>>();
    adapt_spacing(cloud, walls, mesh, old_domain, migration);
    const Interfaces interfaces = [&](const double reach, const std::vector<Facet> &segments) {
      if constexpr (dim == 2)
        if (!faces.empty())
          return find_interface_segments(faces, old_domain, cloud, reach, segments);
      return std::vector<Facet>();
    };

    std::vector<typename Migration<dim>::MarkedCell> own_cells;
    for (const Simplex<dim> &simplex :
         own_candidates(cloud, walls, solid_facets, interfaces, migration, report.n_forced))
    {
      const auto verdict = alpha_shape.judge(simplex, cloud, walls, old_domain, time_step);
      if (verdict != AlphaShape<dim>::Verdict::no_fluid)
        own_cells.push_back(
          {simplex, verdict == AlphaShape<dim>::Verdict::becomes_fluid,
           fluid_of_cell<dim>(simplex, cloud, [&] {
             return old_domain.fluid_at(simplex, centroid<dim>(corners_of<dim>(simplex, cloud.position)));
           })});
    }
    std::vector<Simplex<dim>> cells;
    std::vector<unsigned int> fluids;
    std::vector<bool> arriving(cloud.size(), false);
    for (const auto &[cell, is_new, fluid] : migration.collect_cells(cloud, own_cells))
    {
      cells.push_back(cell);
      fluids.push_back(fluid);
      if (is_new)
        for (const unsigned int particle : cell)
          arriving[particle] = true;
    }
    report.changed = mesh.reinit(cloud, cells, fluids);
    if (!migration.is_alone())
      report.changed = Utilities::MPI::max(report.changed ? 1U : 0U, migration.communicator()) == 1U;
    if (keep_volume && (report.changed || VolumeCorrection<dim>::is_any_owed(cloud, migration)))
      VolumeCorrection<dim>::apply(old_domain, passed_on(outside, cloud, mesh), walls, mesh, cloud,
                                   migration);
    for (const unsigned int particle : mesh.particles())
      report.arrives.push_back(arriving[particle]);
    return report;
  }



  template class Remesher<2>;
  template class Remesher<3>;
} // namespace Lahar
