#include <lahar/remeshing/local_delaunay.h>
#include <lahar/remeshing/point_tree.h>
#include <lahar/remeshing/remesher.h>
#include <lahar/remeshing/volume_correction.h>

#include <algorithm>
#include <numeric>

namespace Lahar
{
  template <int dim>
  Remesher<dim>::Remesher(const MPI_Comm &communicator)
    : communicator(communicator)
  {}



  template <int dim>
  void Remesher<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Remeshing");
    prm.declare_entry(
      "Keep volume", "true", Patterns::Anything(),
      "Whether particles of the free surface move so that remeshing changes no volume: true or "
      "false.");
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



  namespace
  {
    /// A program that has not initialised MPI, as tests may be, is alone.
    bool is_alone(const MPI_Comm &communicator)
    {
      return !Utilities::MPI::job_supports_mpi() || Utilities::MPI::n_mpi_processes(communicator) == 1;
    }

    /// The simplices of all ranks, one rank's after the other's.
    template <int dim>
    std::vector<Simplex<dim>> gather(const std::vector<Simplex<dim>> &own, const MPI_Comm &communicator)
    {
      if (is_alone(communicator))
        return own;
      const int n_own = own.size() * (dim + 1);
      std::vector<int> counts(Utilities::MPI::n_mpi_processes(communicator)), offsets(counts.size(), 0);
      int ierr = MPI_Allgather(&n_own, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
      AssertThrowMPI(ierr);
      std::partial_sum(counts.begin(), counts.end() - 1, offsets.begin() + 1);
      std::vector<Simplex<dim>> all((offsets.back() + counts.back()) / (dim + 1));
      ierr = MPI_Allgatherv(own.data(), n_own, MPI_UNSIGNED, all.data(), counts.data(), offsets.data(),
                            MPI_UNSIGNED, communicator);
      AssertThrowMPI(ierr);
      return all;
    }
  } // namespace



  template <int dim>
  std::vector<Simplex<dim>> Remesher<dim>::own_candidates(const ParticleCloud<dim> &cloud,
                                                          const std::vector<Facet> &solid_facets,
                                                          unsigned int &n_forced) const
  {
    std::vector<unsigned int> fluid;
    double largest_spacing = 0.;
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      largest_spacing = std::max(largest_spacing, cloud.spacing[i]);
      if (cloud.kind[i] == ParticleKind::fluid)
        fluid.push_back(i);
    }
    const unsigned int n_ranks = is_alone(communicator) ? 1 : Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = n_ranks == 1 ? 0 : Utilities::MPI::this_mpi_process(communicator);
    const std::vector<unsigned int> ranks = share_points(cloud.position, fluid, n_ranks);
    std::vector<bool> own(cloud.size(), false);
    for (const unsigned int i : fluid)
      own[i] = ranks[i] == rank;
    const auto is_own_candidate = [&](const Simplex<dim> &simplex) {
      unsigned int first_fluid = numbers::invalid_unsigned_int;
      for (const unsigned int i : simplex)
        if (cloud.kind[i] == ParticleKind::fluid)
          first_fluid = std::min(first_fluid, i);
      return first_fluid < cloud.size() && own[first_fluid] && alpha_shape.is_candidate(simplex, cloud);
    };

    n_forced = 0;
    if constexpr (dim == 2)
      if (!solid_facets.empty())
      {
        std::vector<Simplex<2>> candidates;
        for (const Simplex<2> &simplex : constrained_delaunay(cloud.position, solid_facets, n_forced))
          if (is_own_candidate(canonical<2>(simplex)))
            candidates.push_back(canonical<2>(simplex));
        return candidates;
      }
    return local_delaunay<dim>(cloud.position, own, alpha_shape.reach() * largest_spacing, is_own_candidate);
  }



  template <int dim>
  void Remesher<dim>::create_mesh(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                  const std::vector<Facet> &solid_facets, const std::vector<bool> &wet,
                                  FluidMesh<dim> &mesh) const
  {
    unsigned int n_forced;
    std::vector<Simplex<dim>> cells;
    for (const Simplex<dim> &simplex : own_candidates(cloud, solid_facets, n_forced))
      if (std::all_of(simplex.begin(), simplex.end(),
                      [&](const unsigned int particle) { return wet[particle]; }) &&
          alpha_shape.accepts_plain(simplex, cloud, walls))
        cells.push_back(simplex);
    mesh.reinit(cloud, gather<dim>(cells, communicator));
  }



  template <int dim>
  typename Remesher<dim>::Report Remesher<dim>::remesh(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                                       const std::vector<Facet> &solid_facets,
                                                       const double time_step, FluidMesh<dim> &mesh) const
  {
    Report report;
    OldDomain<dim> old_domain(cloud, mesh);
    particle_spacing.adapt(cloud, walls, mesh, old_domain);

    std::vector<Simplex<dim>> cells, new_cells;
    for (const Simplex<dim> &simplex : own_candidates(cloud, solid_facets, report.n_forced))
    {
      const auto verdict = alpha_shape.judge(simplex, cloud, walls, old_domain, time_step);
      if (verdict != AlphaShape<dim>::Verdict::no_fluid)
        cells.push_back(simplex);
      if (verdict == AlphaShape<dim>::Verdict::becomes_fluid)
        new_cells.push_back(simplex);
    }
    std::vector<bool> arriving(cloud.size(), false);
    for (const Simplex<dim> &simplex : gather<dim>(new_cells, communicator))
      for (const unsigned int particle : simplex)
        arriving[particle] = true;
    report.changed = mesh.reinit(cloud, gather<dim>(cells, communicator));
    if (keep_volume && report.changed)
      VolumeCorrection<dim>::apply(old_domain, walls, mesh, cloud);
    for (const unsigned int particle : mesh.particles())
      report.arrives.push_back(arriving[particle]);
    return report;
  }



  template class Remesher<2>;
  template class Remesher<3>;
} // namespace Lahar
