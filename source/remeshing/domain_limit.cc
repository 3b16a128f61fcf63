// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/domain_limit.h>

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
    const std::vector<bool> outside = find_outside(cloud);
    unsigned int n_own_outside      = 0;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      n_own_outside += (outside[i] && cloud.is_own(i));
    if (std::find(outside.begin(), outside.end(), true) == outside.end())
      return 0;

    std::vector<Simplex<dim>> cells;
    for (const Simplex<dim> &cell : mesh.particle_cells())
      if (std::none_of(cell.begin(), cell.end(), [&](const unsigned int i) { return outside[i]; }))
        cells.push_back(cell);
    const std::vector<unsigned int> new_index = cloud.remove(outside);
    for (Simplex<dim> &cell : cells)
      for (unsigned int &corner : cell)
        corner = new_index[corner];
    mesh.reinit(cloud, cells);
    return n_own_outside;
  }



  template class DomainLimit<2>;
  template class DomainLimit<3>;
} // namespace Lahar
