// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/interface_faces.h>
#include <lahar/remeshing/thin_films.h>

#include <algorithm>
#include <map>

namespace Lahar
{
  namespace
  {
    /// Over h; interfaces this near to each other lose a particle, too, see ParticleSpacing.
    constexpr double thinnest = 0.18;

    struct Film
    {
      double thickness;       ///< over h
      unsigned int neighbour; ///< the cell behind the interface edge
    };

    /// The cells of films that are too thin, by number.
    std::map<unsigned int, Film> find_thin_cells(const FluidMesh<2> &mesh, const ParticleCloud<2> &cloud)
    {
      std::map<unsigned int, Film> result;
      for (const InterfaceFace<2> &face : find_interface_faces(mesh))
        for (const unsigned int side : {0, 1})
        {
          const Simplex<2> &cell  = mesh.particle_cells()[face.cells[side]];
          const auto is_of_either = [&](const unsigned int i) {
            return cloud.kind[i] == ParticleKind::fluid && (cloud.part[i] & face.fluids) == face.fluids;
          };
          if (!std::all_of(cell.begin(), cell.end(), is_of_either))
            continue;
          const double edge = cloud.position[face.corners[0]].distance(cloud.position[face.corners[1]]);
          const double h    = (cloud.spacing[cell[0]] + cloud.spacing[cell[1]] + cloud.spacing[cell[2]]) / 3.;
          const Film film{2. * signed_volume<2>(corners_of<2>(cell, cloud.position)) / (edge * h),
                          face.cells[1 - side]};
          if (!(film.thickness < thinnest))
            continue;
          const auto known = result.emplace(face.cells[side], film).first;
          if (film.thickness < known->second.thickness)
            known->second = film;
        }
      return result;
    }
  } // namespace



  void tear_thin_films(const Migration<2> &migration, FluidMesh<2> &mesh, ParticleCloud<2> &cloud)
  {
    const std::map<unsigned int, Film> films = find_thin_cells(mesh, cloud);
    std::vector<unsigned int> fluids         = mesh.cell_fluids();
    std::vector<bool> is_touched(cloud.size(), false);
    for (const auto &[cell, film] : films)
    {
      const auto behind = films.find(film.neighbour);
      if (behind != films.end() && behind->second.thickness < film.thickness)
        continue;
      fluids[cell] = mesh.fluid(film.neighbour);
      for (const unsigned int i : mesh.particle_cells()[cell])
        is_touched[i] = true;
    }
    mesh.set_cell_fluids(fluids);

    std::vector<FluidSet> around(cloud.size(), 0U);
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      for (const unsigned int i : mesh.particle_cells()[c])
        around[i] |= fluid_set(mesh.fluid(c));
    std::vector<double> parts(cloud.part.begin(), cloud.part.end());
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (is_touched[i])
        parts[i] = cloud.part[i] & around[i];
    migration.update(parts);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      cloud.part[i] = static_cast<unsigned int>(parts[i]);
  }
} // namespace Lahar
