#include <lahar/remeshing/remesher.h>
#include <lahar/remeshing/volume_correction.h>

#include <algorithm>

namespace Lahar
{
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
    template <int dim>
    std::vector<Simplex<dim>> triangulate(const std::vector<Point<dim>> &points,
                                          const std::vector<std::array<unsigned int, dim>> &solid_facets,
                                          unsigned int &n_forced)
    {
      n_forced = 0;
      if constexpr (dim == 2)
        if (!solid_facets.empty())
          return constrained_delaunay(points, solid_facets, n_forced);
      return delaunay<dim>(points);
    }
  } // namespace



  template <int dim>
  void Remesher<dim>::create_mesh(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                  const std::vector<Facet> &solid_facets, const std::vector<bool> &wet,
                                  FluidMesh<dim> &mesh) const
  {
    unsigned int n_forced;
    std::vector<Simplex<dim>> cells;
    for (const Simplex<dim> &simplex : triangulate<dim>(cloud.position, solid_facets, n_forced))
      if (std::all_of(simplex.begin(), simplex.end(),
                      [&](const unsigned int particle) { return wet[particle]; }) &&
          alpha_shape.accepts_plain(simplex, cloud, walls))
        cells.push_back(simplex);
    mesh.reinit(cloud, cells);
  }



  template <int dim>
  typename Remesher<dim>::Report Remesher<dim>::remesh(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                                       const std::vector<Facet> &solid_facets,
                                                       const double time_step, FluidMesh<dim> &mesh) const
  {
    Report report;
    OldDomain<dim> old_domain(cloud, mesh);
    particle_spacing.adapt(cloud, walls, mesh, old_domain);

    std::vector<Simplex<dim>> cells;
    std::vector<bool> arriving(cloud.size(), false);
    for (const Simplex<dim> &simplex : triangulate<dim>(cloud.position, solid_facets, report.n_forced))
    {
      const auto verdict = alpha_shape.judge(simplex, cloud, walls, old_domain, time_step);
      if (verdict != AlphaShape<dim>::Verdict::no_fluid)
        cells.push_back(simplex);
      if (verdict == AlphaShape<dim>::Verdict::becomes_fluid)
        for (const unsigned int particle : simplex)
          arriving[particle] = true;
    }
    report.changed = mesh.reinit(cloud, cells);
    if (keep_volume && report.changed)
      VolumeCorrection<dim>::apply(old_domain, walls, mesh, cloud);
    for (const unsigned int particle : mesh.particles())
      report.arrives.push_back(arriving[particle]);
    return report;
  }



  template class Remesher<2>;
  template class Remesher<3>;
} // namespace Lahar
