// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/vector.hpp>

#include <lahar/boundary/inlets.h>
#include <lahar/boundary/slip_condition.h>
#include <lahar/geometry/simplex_geometry.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// No particle that comes in moves by more than this times its spacing in a step: none would be left out.
    constexpr double largest_movement = 0.9;
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
  std::vector<double> Inlets<dim>::means(const double time, const double length) const
  {
    std::vector<double> result;
    for (const Inlet &inlet : inlets)
      try
      {
        result.push_back(inlet.source.law->mean(time, length));
      }
      catch (const RunError &error)
      {
        throw RunError("boundary '" + inlet.source.name + "': " + error.what());
      }
    return result;
  }



  template <int dim>
  void Inlets<dim>::constrain(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh, const double time,
                              const double length, std::vector<NodeConstraint<dim>> &constraints) const
  {
    if (!any())
      return;
    const std::vector<double> mean = means(time, length);
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      if (const unsigned int i = mesh.particle(v); comes_in(i, cloud))
      {
        const Inlet &from       = inlet(i, cloud);
        constraints[v]          = NodeConstraint<dim>();
        constraints[v].n_fixed  = dim;
        constraints[v].moves    = true;
        constraints[v].velocity = mean[&from - inlets.data()] * from.factor[from.home(cloud.position[i])] *
                                  from.direction;
      }
  }



  template <int dim>
  void Inlets<dim>::carry(const std::vector<Point<dim>> &old_position, const double time, const double length,
                          ParticleCloud<dim> &cloud) const
  {
    if (!any())
      return;
    const std::vector<double> mean = means(time, length);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (comes_in(i, cloud))
      {
        const Inlet &from = inlet(i, cloud);
        cloud.velocity[i] = mean[&from - inlets.data()] * from.factor[from.home(old_position[i])] *
                            from.direction;
        cloud.position[i] = old_position[i] + length * cloud.velocity[i];
      }
  }



  template <int dim>
  double Inlets<dim>::volume(const double time, const double length) const
  {
    const std::vector<double> mean = means(time, length);
    double sum                     = 0.;
    for (unsigned int n = 0; n < inlets.size(); ++n)
      for (unsigned int k = 0; k < inlets[n].homes.size(); ++k)
        sum += length * mean[n] * inlets[n].area[k] * inlets[n].factor[k];
    return sum;
  }



  template <int dim>
  double Inlets<dim>::layer_volume(const ParticleCloud<dim> &cloud) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < cloud.size() && any(); ++i)
      if (cloud.is_own(i) && comes_in(i, cloud))
      {
        const Inlet &from = inlet(i, cloud);
        sum += from.area[from.home(cloud.position[i])] * from.travel(cloud.position[i]);
      }
    return sum;
  }



  template <int dim>
  double Inlets<dim>::fastest(const double time, const double length) const
  {
    const std::vector<double> mean = means(time, length);
    double result                  = 0.;
    for (unsigned int n = 0; n < inlets.size(); ++n)
      for (unsigned int k = 0; k < inlets[n].homes.size(); ++k)
        result = std::max(result, mean[n] * inlets[n].factor[k] / inlets[n].spacing[k]);
    return result;
  }



  template <int dim>
  void Inlets<dim>::check_movement(const double time, const double length) const
  {
    if (const double movement = fastest(time, length) * length; movement > largest_movement)
    {
      std::ostringstream message;
      message << "inflow moves by " << movement << " times the spacing, " << largest_movement
              << " is allowed";
      throw RunError(message.str());
    }
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
      if (walls.facets()[facet].slip && std::abs(walls.signed_distance(facet, position)) < tolerance &&
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
      const auto of_ranks = Utilities::MPI::all_gather(communicator, numbers_of_all);
      numbers_of_all.clear();
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
      cloud.slip_facets[n]              = touched_facets(walls, place, cloud.spacing[i]);
      cloud.number[n]                   = first_number +
                        (std::lower_bound(numbers_of_all.begin(), numbers_of_all.end(), cloud.number[i]) -
                         numbers_of_all.begin());
      for (const unsigned int f : faces_of[i])
      {
        Simplex<dim> cell;
        std::copy(faces[f].corners.begin(), faces[f].corners.end(), cell.begin());
        cell[dim] = n;
        if (signed_volume<dim>(corners_of<dim>(cell, cloud.position)) < 0.)
          std::swap(cell[0], cell[1]);
        cells.push_back(cell);
        std::replace(faces[f].corners.begin(), faces[f].corners.end(), i, n);
      }
      cloud.kind[i]     = ParticleKind::fluid;
      cloud.part[i]     = from.source.fluid;
      cloud.reaction[i] = Tensor<1, dim>();
      if (faces_of[i].empty())
        cloud.owed_volume[i] -= from.area[k] * cloud.spacing[i];
    }
    cloud.next_number = first_number + numbers_of_all.size();
    mesh.reinit(cloud, cells);
    const WallStep<dim> standing(walls);
    SlipCondition<dim>(standing).initialize(cloud);
    return numbers_of_all.size();
  }



  template class Inlets<2>;
  template class Inlets<3>;
} // namespace Lahar
