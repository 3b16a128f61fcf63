// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/domain_limit.h>
#include <lahar/remeshing/drop_particles.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  void DomainLimit<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Remeshing");
    prm.declare_list(
      "Domain", "", ':',
      "Box, as two opposite corners 'x, y : x, y' (three coordinates in space): fluid particles that "
      "leave it are dropped with their cells and counted. Empty: no limits.");
    prm.leave_subsection();
  }



  template <int dim>
  void DomainLimit<dim>::parse_parameters(Parameters &prm)
  {
    prm.enter_subsection("Remeshing");
    boxes = parse_boxes<dim>(prm, "Domain");
    if (boxes.size() > 1)
      prm.throw_wrong_value("Domain", "one box or nothing");
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<bool> DomainLimit<dim>::find_outside(const ParticleCloud<dim> &cloud) const
  {
    std::vector<bool> outside(cloud.size(), false);
    for (unsigned int i = 0; i < cloud.size() && is_set(); ++i)
      outside[i] = cloud.kind[i] == ParticleKind::fluid && !boxes[0].contains(cloud.position[i], 0.);
    return outside;
  }



  template <int dim>
  void DomainLimit<dim>::check_initial(Parameters &prm, const ParticleCloud<dim> &cloud) const
  {
    const std::vector<bool> outside = find_outside(cloud);
    if (std::find(outside.begin(), outside.end(), true) == outside.end())
      return;
    prm.enter_subsection("Remeshing");
    prm.throw_wrong_value("Domain", "a box that holds all fluid at the start");
  }



  template <int dim>
  unsigned int DomainLimit<dim>::drop_outside(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh) const
  {
    return drop_particles(find_outside(cloud), cloud, mesh);
  }



  template class DomainLimit<2>;
  template class DomainLimit<3>;
} // namespace Lahar
