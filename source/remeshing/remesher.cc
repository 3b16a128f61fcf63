#include <lahar/remeshing/remesher.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  void Remesher<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Remeshing");
    AlphaShape<dim>::declare_parameters(prm);
    ParticleSpacing<dim>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  void Remesher<dim>::parse_parameters(Parameters &prm)
  {
    prm.enter_subsection("Remeshing");
    alpha_shape.parse_parameters(prm);
    particle_spacing.parse_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  void Remesher<dim>::create_mesh(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                  const std::vector<bool> &wet, FluidMesh<dim> &mesh) const
  {
    std::vector<Simplex<dim>> cells;
    for (const Simplex<dim> &simplex : delaunay<dim>(cloud.position))
      if (std::all_of(simplex.begin(), simplex.end(),
                      [&](const unsigned int particle) { return wet[particle]; }) &&
          alpha_shape.accepts_plain(simplex, cloud, walls))
        cells.push_back(simplex);
    mesh.reinit(cloud, cells);
  }



  template <int dim>
  bool Remesher<dim>::remesh(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const double time_step,
                             FluidMesh<dim> &mesh) const
  {
    OldDomain<dim> old_domain(cloud, mesh);
    particle_spacing.adapt(cloud, mesh, old_domain);

    std::vector<Simplex<dim>> cells;
    for (const Simplex<dim> &simplex : delaunay<dim>(cloud.position))
      if (alpha_shape.accepts(simplex, cloud, walls, old_domain, time_step))
        cells.push_back(simplex);
    return mesh.reinit(cloud, cells);
  }



  template class Remesher<2>;
  template class Remesher<3>;
} // namespace Lahar
