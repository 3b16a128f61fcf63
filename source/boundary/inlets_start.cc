// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/inlets.h>

#include <algorithm>
#include <sstream>

namespace Lahar
{
  namespace
  {
    template <int dim>
    Point<3> in_space(const Point<dim> &point)
    {
      Point<3> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = point[d];
      return result;
    }

    template <int dim>
    std::string to_text(const Point<dim> &point)
    {
      std::ostringstream text;
      text << '(' << point << ") m";
      return text.str();
    }

    template <int dim>
    double facet_size(const WallFacet<dim> &facet)
    {
      return facet.corners[0].distance(facet.corners[1]);
    }
  } // namespace



  template <int dim>
  void Inlets<dim>::start(const std::vector<Source> &sources, const Walls<dim> &walls,
                          ParticleCloud<dim> &cloud, const MPI_Comm &communicator)
  {
    inlet_of.assign(sources.size(), numbers::invalid_unsigned_int);
    for (unsigned int b = 0; b < sources.size(); ++b)
    {
      if (sources[b].law == nullptr)
        continue;
      inlet_of[b] = inlets.size();
      inlets.emplace_back();
      Inlet &inlet       = inlets.back();
      inlet.source       = sources[b];
      unsigned int first = numbers::invalid_unsigned_int;
      for (unsigned int f = 0; f < walls.facets().size(); ++f)
        if (walls.facets()[f].boundary == b)
        {
          if (first == numbers::invalid_unsigned_int)
          {
            first           = f;
            inlet.direction = walls.normal(f);
          }
          for (const Point<dim> &corner : walls.facets()[f].corners)
            if (const double distance = walls.signed_distance(first, corner);
                std::abs(distance) > 1e-6 * facet_size(walls.facets()[first]))
            {
              std::ostringstream message;
              message << "Boundary '" << inlet.source.name
                      << "' lets fluid in, but is not plane: its corner at " << to_text(corner) << " is "
                      << std::abs(distance)
                      << " m off the plane of its first part. Allowed: a plane boundary.";
              throw InputError(message.str());
            }
        }
      std::vector<Point<dim>> places;
      std::vector<double> spacings;
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (cloud.kind[i] == ParticleKind::wall && cloud.part[i] == b)
        {
          places.push_back(cloud.position[i]);
          spacings.push_back(cloud.spacing[i]);
          cloud.contact_facets[i] = touched_facets(walls, cloud.position[i], cloud.spacing[i]);
        }
      const auto all_spacings = Utilities::MPI::all_gather(communicator, spacings);
      unsigned int rank       = 0;
      for (const std::vector<Point<dim>> &of_rank : Utilities::MPI::all_gather(communicator, places))
      {
        const std::vector<double> &spacings_of_rank = all_spacings[rank++];
        for (unsigned int k = 0; k < of_rank.size(); ++k)
        {
          inlet.homes.push_back(of_rank[k]);
          inlet.places.insert(of_rank[k]);
          inlet.spacing.push_back(spacings_of_rank[k]);
          const std::array<int, dim> touched = touched_facets(walls, of_rank[k], spacings_of_rank[k]);
          // What lies on a wall to which fluid sticks stays there, and what lies on one that does not lead along the inflow:
          // the rim of a hole in it.
          const bool at_rim = std::any_of(touched.begin(), touched.end(), [&](const int facet) {
            return facet != ParticleCloud<dim>::no_facet &&
                   (walls.facets()[facet].sticks || std::abs(walls.normal(facet) * inlet.direction) > 1e-3);
          });
          inlet.factor.push_back(at_rim ? 0. : inlet.source.law->profile(in_space<dim>(of_rank[k])));
        }
      }
      if (inlet.homes.empty())
        throw InputError(
          "Boundary '" + inlet.source.name +
          "' lets fluid in, but has no particle: other walls take its place. Allowed: a boundary longer "
          "than the mesh size between other walls.");
    }
  }



  template <int dim>
  void Inlets<dim>::find_shares(const Walls<dim> &walls, const ParticleCloud<dim> &cloud,
                                const FluidMesh<dim> &mesh, const MPI_Comm &communicator)
  {
    if (!any())
      return;
    // What the faces give to the homes, and how many faces have the fluid on the one and on the other side.
    std::vector<std::vector<double>> shares;
    for (const Inlet &inlet : inlets)
      shares.emplace_back(inlet.homes.size() + 2, 0.);
    const std::vector<double> own = own_shares(cloud, mesh);
    for (const Face &face : find_faces(cloud, mesh))
      for (const unsigned int i : face.corners)
        if (cloud.is_own(i) && comes_in(i, cloud))
        {
          const Inlet &from          = inlet(i, cloud);
          std::vector<double> &share = shares[&from - inlets.data()];
          share[from.homes.size() + (from.travel(cloud.position[face.inner]) > 0. ? 0 : 1)] += 1.;
          share[from.home(cloud.position[i])] = own[i];
        }
    for (unsigned int n = 0; n < inlets.size(); ++n)
    {
      Inlet &inlet               = inlets[n];
      std::vector<double> &share = shares[n];
      Utilities::MPI::sum(share, communicator, share);
      const double n_above = share[inlet.homes.size()], n_below = share[inlet.homes.size() + 1];
      share.resize(inlet.homes.size());
      const std::string boundary = "Boundary '" + inlet.source.name + "' lets fluid in, but ";
      if (n_above > 0. && n_below > 0.)
        throw InputError(boundary + "fluid stands on both of its sides, seen by " +
                         std::to_string(int(n_above)) + " and " + std::to_string(int(n_below)) +
                         " faces of cells. Allowed: fluid on one side.");
      for (unsigned int k = 0; k < share.size(); ++k)
        if (share[k] == 0.)
          throw InputError(
            boundary + "no fluid touches it at " + to_text(inlet.homes[k]) +
            " at the start. Allowed: a boundary that fluid touches all over, as a layer of three mesh "
            "sizes does that stands before it.");
      if (n_below > 0.)
        inlet.direction *= -1.;
      inlet.area  = share;
      double mean = 0.;
      for (unsigned int k = 0; k < share.size(); ++k)
        mean += share[k] * inlet.factor[k];
      if (!(mean > 0.))
        throw InputError("Parameter '" + inlet.source.law->path("Profile") +
                         "' is zero all over the boundary. Allowed: a function above zero somewhere on it.");
    }
    check_space(walls);
  }



  template <int dim>
  void Inlets<dim>::check_space(const Walls<dim> &walls) const
  {
    for (const Inlet &inlet : inlets)
      for (unsigned int k = 0; k < inlet.homes.size(); ++k)
      {
        const Tensor<1, dim> way = inlet.spacing[k] * inlet.direction;
        for (const unsigned int f :
             walls.crossed(inlet.homes[k] + 1e-2 * way, inlet.homes[k] + way, 1e-3 * inlet.spacing[k], 0.))
          if (const unsigned int b = walls.facets()[f].boundary;
              inlet_of[b] != static_cast<unsigned int>(&inlet - inlets.data()))
          {
            std::ostringstream message;
            message << "Boundary '" << inlet.source.name << "' lets fluid in at " << to_text(inlet.homes[k])
                    << ", but boundary '" << walls.boundary_names()[b] << "' stands less than a mesh size, "
                    << inlet.spacing[k]
                    << " m, before it. Allowed: walls farther away, or along the way of the fluid.";
            throw InputError(message.str());
          }
      }
  }



  template void Inlets<2>::start(const std::vector<Source> &, const Walls<2> &, ParticleCloud<2> &,
                                 const MPI_Comm &);
  template void Inlets<3>::start(const std::vector<Source> &, const Walls<3> &, ParticleCloud<3> &,
                                 const MPI_Comm &);
  template void Inlets<2>::find_shares(const Walls<2> &, const ParticleCloud<2> &, const FluidMesh<2> &,
                                       const MPI_Comm &);
  template void Inlets<3>::find_shares(const Walls<3> &, const ParticleCloud<3> &, const FluidMesh<3> &,
                                       const MPI_Comm &);
  template void Inlets<2>::check_space(const Walls<2> &) const;
  template void Inlets<3>::check_space(const Walls<3> &) const;
} // namespace Lahar
