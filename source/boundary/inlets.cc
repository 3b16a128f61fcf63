// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/vector.hpp>

#include <lahar/boundary/inlets.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/particles/fluid_set.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

namespace Lahar
{
  namespace
  {
    /// No particle that comes in moves farther than this times its spacing in a step: none would be left out.
    constexpr double largest_movement = 0.9;

    /// Of a face, on a plane with the unit normal @p normal.
    template <int dim>
    double projected_area(const std::array<unsigned int, dim> &face, const ParticleCloud<dim> &cloud,
                          const Tensor<1, dim> &normal)
    {
      const std::vector<Point<dim>> &x = cloud.position;
      if constexpr (dim == 2)
        return std::abs(cross_product_2d(x[face[1]] - x[face[0]]) * normal);
      else
        return 0.5 * std::abs(cross_product_3d(x[face[1]] - x[face[0]], x[face[2]] - x[face[0]]) * normal);
    }
  } // namespace



  template <int dim>
  unsigned int Inlets<dim>::Inlet::home(const Point<dim> &position) const
  {
    const Point<dim> foot   = position - travel(position) * direction;
    unsigned int nearest    = 0;
    double nearest_distance = std::numeric_limits<double>::max();
    for (double reach = 1e-3 * spacing[0]; nearest_distance == std::numeric_limits<double>::max();
         reach *= 10.)
      for (const unsigned int k : places.near(foot, reach))
        if (const double distance = homes[k].distance(foot); distance < nearest_distance)
        {
          nearest          = k;
          nearest_distance = distance;
        }
    return nearest;
  }



  template <int dim>
  double Inlets<dim>::mean(const Inlet &inlet, const double time, const double step_length)
  {
    try
    {
      return inlet.source.law->mean(time, step_length);
    }
    catch (const RunError &error)
    {
      throw RunError("boundary '" + inlet.source.name + "': " + error.what());
    }
  }



  template <int dim>
  std::vector<double> Inlets<dim>::own_shares(const ParticleCloud<dim> &cloud,
                                              const FluidMesh<dim> &mesh) const
  {
    std::vector<double> result(cloud.size(), 0.);
    for (const Face &face : find_faces(cloud, mesh))
      for (const unsigned int i : face.corners)
        if (cloud.is_own(i) && comes_in(i, cloud))
          result[i] += projected_area<dim>(face.corners, cloud, inlet(i, cloud).direction) / dim;
    // Without a face it becomes a drop.
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (result[i] == 0. && cloud.is_own(i) && comes_in(i, cloud))
      {
        const Inlet &from = inlet(i, cloud);
        if (!from.area.empty())
          result[i] = from.area[from.home(cloud.position[i])];
      }
    return result;
  }



  template <int dim>
  void Inlets<dim>::start_step(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                               const MPI_Comm &communicator, const double time, const double new_length)
  {
    length = new_length;
    flux   = 0.;
    if (!any())
      return;
    std::vector<double> sums(inlets.size(), 0.); // Σ A φ
    const std::vector<double> shares = own_shares(cloud, mesh);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i) && comes_in(i, cloud))
      {
        const Inlet &from = inlet(i, cloud);
        sums[&from - inlets.data()] += shares[i] * from.factor[from.home(cloud.position[i])];
      }
    Utilities::MPI::sum(sums, communicator, sums);
    for (unsigned int n = 0; n < inlets.size(); ++n)
    {
      Inlet &from = inlets[n];
      from.speed  = mean(from, time, length);
      if (from.source.law->is_discharge())
        from.speed /= sums[n];
      from.flux = from.speed * sums[n];
      flux += from.flux;
      for (unsigned int k = 0; k < from.homes.size(); ++k)
        if (const double movement = length * from.speed * from.factor[k] / from.spacing[k];
            movement > largest_movement)
        {
          std::ostringstream message;
          message << "boundary '" << from.source.name << "': inflow moves by " << movement
                  << " times the spacing, " << largest_movement << " is allowed";
          throw RunError(message.str());
        }
    }
  }



  template <int dim>
  void Inlets<dim>::constrain(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                              std::vector<NodeConstraint<dim>> &constraints) const
  {
    for (unsigned int v = 0; v < mesh.n_vertices() && any(); ++v)
      if (const unsigned int i = mesh.particle(v); comes_in(i, cloud))
      {
        const Inlet &from       = inlet(i, cloud);
        constraints[v]          = NodeConstraint<dim>();
        constraints[v].n_fixed  = dim;
        constraints[v].moves    = true;
        constraints[v].velocity = from.speed * from.factor[from.home(cloud.position[i])] * from.direction;
      }
  }



  template <int dim>
  void Inlets<dim>::carry(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud) const
  {
    for (unsigned int i = 0; i < cloud.size() && any(); ++i)
      if (comes_in(i, cloud))
      {
        const Inlet &from = inlet(i, cloud);
        cloud.velocity[i] = from.speed * from.factor[from.home(old_position[i])] * from.direction;
        cloud.position[i] = old_position[i] + length * cloud.velocity[i];
      }
  }



  template <int dim>
  std::map<std::uint64_t, double> Inlets<dim>::layers(const ParticleCloud<dim> &cloud,
                                                      const FluidMesh<dim> &mesh) const
  {
    std::map<std::uint64_t, double> result;
    if (!any())
      return result;
    const std::vector<double> shares = own_shares(cloud, mesh);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (shares[i] > 0.)
        result[cloud.number[i]] = shares[i] * inlet(i, cloud).travel(cloud.position[i]);
    return result;
  }



  template <int dim>
  double Inlets<dim>::layer_volume(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh) const
  {
    double sum = 0.;
    for (const auto &[number, volume] : layers(cloud, mesh))
      sum += volume;
    return sum;
  }



  template <int dim>
  double Inlets<dim>::layer_volume(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                                   const unsigned int fluid) const
  {
    double sum = 0.;
    for (const auto &[number, volume] : layers(cloud, mesh))
      if (inlet(cloud.find(number), cloud).source.fluid == fluid)
        sum += volume;
    return sum;
  }



  template <int dim>
  double Inlets<dim>::volume(const unsigned int fluid) const
  {
    double sum = 0.;
    for (const Inlet &from : inlets)
      if (from.source.fluid == fluid)
        sum += length * from.flux;
    return sum;
  }



  template <int dim>
  double Inlets<dim>::fastest(const double time, const double step_length) const
  {
    double result = 0.;
    for (const Inlet &from : inlets)
    {
      double whole = 0., largest = 0.;
      for (unsigned int k = 0; k < from.homes.size(); ++k)
      {
        whole += from.area[k] * from.factor[k];
        largest = std::max(largest, from.factor[k] / from.spacing[k]);
      }
      result = std::max(result, mean(from, time, step_length) * largest /
                                  (from.source.law->is_discharge() ? whole : 1.));
    }
    return result;
  }



  template <int dim>
  std::vector<typename Inlets<dim>::Face> Inlets<dim>::find_faces(const ParticleCloud<dim> &cloud,
                                                                  const FluidMesh<dim> &mesh) const
  {
    std::vector<Face> result;
    for (const BoundaryFace &boundary_face : mesh.boundary_faces())
    {
      const Simplex<dim> &cell = mesh.particle_cells()[boundary_face.cell];
      Face face;
      face.inner     = cell[boundary_face.opposite];
      bool has_fluid = false, has_inflow = false;
      for (unsigned int c = 0, n = 0; c <= dim; ++c)
        if (c != boundary_face.opposite)
        {
          face.corners[n++] = cell[c];
          has_fluid         = has_fluid || cloud.kind[cell[c]] == ParticleKind::fluid;
          has_inflow        = has_inflow || comes_in(cell[c], cloud);
        }
      if (has_inflow && !has_fluid)
        result.push_back(face);
    }
    return result;
  }



  template <int dim>
  std::array<int, dim> Inlets<dim>::touched_facets(const Walls<dim> &walls, const Point<dim> &position,
                                                   const double spacing)
  {
    constexpr double parallel = 1e-3;
    std::array<int, dim> result;
    result.fill(ParticleCloud<dim>::no_facet);
    unsigned int n         = 0;
    const double tolerance = 1e-3 * spacing;
    for (const unsigned int facet : walls.near(position, tolerance))
      if (walls.facets()[facet].lands && std::abs(walls.signed_distance(facet, position)) < tolerance &&
          walls.is_above(facet, position, tolerance) && n < dim)
      {
        const bool adds = std::none_of(result.begin(), result.begin() + n, [&](const int other) {
          return std::abs(walls.normal(facet) * walls.normal(other)) > 1. - parallel;
        });
        if (adds)
          result[n++] = facet;
      }
    std::sort(result.begin(), result.end(), std::greater<int>());
    return result;
  }



  template <int dim>
  void Inlets<dim>::put_beside_walls(const unsigned int particle, const unsigned int inner,
                                     const Walls<dim> &walls, ParticleCloud<dim> &cloud)
  {
    // Along all facets at once: their normals are independent of each other. The inner particle may lie on a wall itself.
    for (unsigned int round = 0; round < 2 * dim; ++round)
      for (const int facet : cloud.contact_facets[particle])
        if (facet != ParticleCloud<dim>::no_facet)
        {
          const double side = walls.signed_distance(facet, cloud.position[inner]) < 0. ? -1. : 1.;
          cloud.position[particle] += (side * contact_offset * cloud.spacing[particle] -
                                       walls.signed_distance(facet, cloud.position[particle])) *
                                      walls.normal(facet);
        }
  }



  template <int dim>
  unsigned int Inlets<dim>::renew(const Walls<dim> &walls, const MPI_Comm &communicator,
                                  ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh) const
  {
    if (!any())
      return 0;
    std::vector<unsigned int> renewed;
    std::vector<std::uint64_t> numbers_of_all;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (comes_in(i, cloud) && inlet(i, cloud).travel(cloud.position[i]) >= cloud.spacing[i])
      {
        renewed.push_back(i);
        if (cloud.is_own(i))
          numbers_of_all.push_back(cloud.number[i]);
      }
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
    {
      const auto of_ranks = Utilities::MPI::all_gather(communicator, std::exchange(numbers_of_all, {}));
      for (const auto &of_rank : of_ranks)
        numbers_of_all.insert(numbers_of_all.end(), of_rank.begin(), of_rank.end());
      std::sort(numbers_of_all.begin(), numbers_of_all.end());
    }
    if (numbers_of_all.empty())
      return 0;

    std::vector<Face> faces = find_faces(cloud, mesh);
    std::vector<std::vector<unsigned int>> faces_of(cloud.size());
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (const unsigned int i : faces[f].corners)
        faces_of[i].push_back(f);
    std::vector<Simplex<dim>> cells  = mesh.particle_cells();
    std::vector<unsigned int> fluids = mesh.cell_fluids();
    fluids.resize(cells.size(), 0);
    const std::uint64_t first_number = cloud.next_number;
    for (const unsigned int i : renewed)
    {
      const Inlet &from      = inlet(i, cloud);
      const unsigned int k   = from.home(cloud.position[i]);
      const double travel    = from.travel(cloud.position[i]) - cloud.spacing[i];
      const Point<dim> place = from.homes[k] + travel * from.direction;
      const unsigned int n   = cloud.append(place, ParticleKind::wall, cloud.spacing[i], cloud.part[i]);
      cloud.velocity[n]      = cloud.velocity[i];
      cloud.acceleration[n]  = cloud.acceleration[i];
      cloud.algorithmic_acceleration[n] = cloud.algorithmic_acceleration[i];
      cloud.pressure[n]                 = cloud.pressure[i];
      cloud.pressure_rate[n]            = cloud.pressure_rate[i];
      cloud.owner[n]                    = cloud.owner[i];
      cloud.contact_facets[n]           = touched_facets(walls, place, cloud.spacing[i]);
      cloud.number[n]                   = first_number +
                        (std::lower_bound(numbers_of_all.begin(), numbers_of_all.end(), cloud.number[i]) -
                         numbers_of_all.begin());
      double share = 0.;
      for (const unsigned int f : faces_of[i])
      {
        share += projected_area<dim>(faces[f].corners, cloud, from.direction);
        Simplex<dim> cell;
        std::copy(faces[f].corners.begin(), faces[f].corners.end(), cell.begin());
        cell[dim] = n;
        if (signed_volume<dim>(corners_of<dim>(cell, cloud.position)) < 0.)
          std::swap(cell[0], cell[1]);
        cells.push_back(cell);
        fluids.push_back(from.source.fluid);
        std::replace(faces[f].corners.begin(), faces[f].corners.end(), i, n);
      }
      cloud.kind[i]     = ParticleKind::fluid;
      cloud.part[i]     = fluid_set(from.source.fluid);
      cloud.reaction[n] = std::exchange(cloud.reaction[i], Tensor<1, dim>());
      // The layer behind it is not in the new cells; faces along the direction have no share of it.
      if (share == 0.)
        cloud.owed_volume[i] -= from.area[k] * cloud.spacing[i];
      if (!faces_of[i].empty())
        put_beside_walls(i, faces[faces_of[i][0]].inner, walls, cloud);
    }
    cloud.next_number = first_number + numbers_of_all.size();
    mesh.reinit(cloud, cells, fluids);
    return numbers_of_all.size();
  }



  template class Inlets<2>;
  template class Inlets<3>;
} // namespace Lahar
