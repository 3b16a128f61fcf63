#include <lahar/remeshing/old_domain.h>
#include <lahar/remeshing/simplex_geometry.h>

namespace Lahar
{
  template <int dim>
  OldDomain<dim>::OldDomain(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh)
    : cells_of(cloud.size())
  {
    cells.reserve(mesh.n_cells());
    for (const Simplex<dim> &simplex : mesh.particle_cells())
    {
      const auto corners = corners_of<dim>(simplex, cloud.position);
      if (!(signed_volume<dim>(corners) > 0.))
        continue;
      for (const unsigned int particle : simplex)
        cells_of[particle].push_back(cells.size());
      cells.push_back({transpose(invert(edge_matrix<dim>(corners))), corners[0]});
    }
  }



  template <int dim>
  void OldDomain<dim>::renumber(const std::vector<unsigned int> &new_index,
                                const std::vector<std::pair<unsigned int, unsigned int>> &parents,
                                const unsigned int n_particles)
  {
    std::vector<std::vector<unsigned int>> renumbered(n_particles);
    const unsigned int first_inserted = n_particles - parents.size();
    for (unsigned int i = 0; i < parents.size(); ++i)
    {
      renumbered[first_inserted + i] = cells_of[parents[i].first];
      renumbered[first_inserted + i].insert(renumbered[first_inserted + i].end(),
                                            cells_of[parents[i].second].begin(),
                                            cells_of[parents[i].second].end());
    }
    for (unsigned int i = 0; i < new_index.size(); ++i)
      if (new_index[i] != numbers::invalid_unsigned_int)
        renumbered[new_index[i]] = std::move(cells_of[i]);
    cells_of = std::move(renumbered);
  }



  template <int dim>
  bool OldDomain<dim>::contains(const Simplex<dim> &simplex, const Point<dim> &point) const
  {
    const double tolerance = 1e-10;
    for (const unsigned int particle : simplex)
      for (const unsigned int c : cells_of[particle])
      {
        const Tensor<1, dim> lambda = cells[c].to_barycentric * (point - cells[c].origin);
        double sum                  = 0.;
        bool inside                 = true;
        for (unsigned int d = 0; d < dim; ++d)
        {
          inside = inside && lambda[d] >= -tolerance;
          sum += lambda[d];
        }
        if (inside && sum <= 1. + tolerance)
          return true;
      }
    return false;
  }



  template class OldDomain<2>;
  template class OldDomain<3>;
} // namespace Lahar
