// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/vector.hpp>

#include <lahar/particles/first_owner.h>
#include <lahar/remeshing/migration.h>

#include <algorithm>
#include <limits>
#include <map>

namespace Lahar
{
  namespace
  {
    /// A rank may have this times the mean work before space is divided anew.
    constexpr double largest_share = 1.05;

    /// What one rank tells another: particles, cells by the numbers of their corners and of their fluids, and values of
    /// cells.
    struct Parcel
    {
      std::vector<double> particles;
      std::vector<std::uint64_t> cells;
      std::vector<std::uint64_t> keys; ///< see CellTable
      std::vector<double> values;

      template <typename Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &particles &cells &keys &values;
      }
    };
  } // namespace



  template <int dim>
  Migration<dim>::Migration(const MPI_Comm &communicator)
    : mpi_communicator(communicator)
    , parts(communicator)
    , exchange(communicator)
  {}



  template <int dim>
  bool Migration<dim>::is_alone() const
  {
    return !Utilities::MPI::job_supports_mpi() || Utilities::MPI::n_mpi_processes(mpi_communicator) == 1;
  }



  template <int dim>
  void Migration<dim>::divide_space(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh)
  {
    std::vector<Point<dim>> points;
    std::vector<double> work(cloud.size(), 1.), weights;
    for (const Simplex<dim> &cell : mesh.particle_cells())
      for (const unsigned int i : cell)
        work[i] += 1.;
    std::vector<double> shares(Utilities::MPI::n_mpi_processes(mpi_communicator), 0.);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
      {
        points.push_back(cloud.position[i]);
        weights.push_back(work[i]);
        shares[parts.rank_of(cloud.position[i])] += work[i];
      }
    Utilities::MPI::sum(shares, mpi_communicator, shares);
    double all = 0.;
    for (const double share : shares)
      all += share;
    if (*std::max_element(shares.begin(), shares.end()) > largest_share * all / shares.size())
      parts.divide(points, weights);
  }



  template <int dim>
  void Migration<dim>::find_boxes(const ParticleCloud<dim> &cloud)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(mpi_communicator);
    const double nothing       = -std::numeric_limits<double>::max();
    std::vector<double> bounds(n_ranks * 2 * dim, nothing); // negative lower and upper ones
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
        for (unsigned int d = 0; d < dim; ++d)
        {
          double *bound = &bounds[(parts.rank_of(cloud.position[i]) * dim + d) * 2];
          bound[0]      = std::max(bound[0], -cloud.position[i][d]);
          bound[1]      = std::max(bound[1], cloud.position[i][d]);
        }
    Utilities::MPI::max(bounds, mpi_communicator, bounds);
    all_boxes.assign(n_ranks, {});
    for (unsigned int r = 0; r < n_ranks; ++r)
      if (const double *bound = &bounds[r * 2 * dim]; bound[0] != nothing)
      {
        std::pair<Point<dim>, Point<dim>> corners;
        for (unsigned int d = 0; d < dim; ++d)
        {
          corners.first[d]  = -bound[2 * d];
          corners.second[d] = bound[2 * d + 1];
        }
        all_boxes[r].emplace_back(corners);
      }
  }



  template <int dim>
  bool Migration<dim>::is_near(const unsigned int rank, const Point<dim> &point) const
  {
    for (const BoundingBox<dim> &box : all_boxes[rank])
    {
      bool near = true;
      for (unsigned int d = 0; d < dim && near; ++d)
        near = point[d] >= box.lower_bound(d) - region_distance &&
               point[d] <= box.upper_bound(d) + region_distance;
      if (near)
        return true;
    }
    return false;
  }



  template <int dim>
  std::vector<unsigned int> Migration<dim>::ranks_around(const ParticleCloud<dim> &cloud) const
  {
    std::vector<unsigned int> ranks;
    if (cloud.size() == 0)
      return ranks;
    const BoundingBox<dim> here(cloud.position);
    for (unsigned int r = 0; r < all_boxes.size(); ++r)
      for (const BoundingBox<dim> &box : all_boxes[r])
      {
        bool near = true;
        for (unsigned int d = 0; d < dim; ++d)
          near = near && here.lower_bound(d) <= box.upper_bound(d) + region_distance &&
                 here.upper_bound(d) >= box.lower_bound(d) - region_distance;
        if (near)
          ranks.push_back(r);
      }
    return ranks;
  }



  template <int dim>
  void Migration<dim>::migrate(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh, const double distance,
                               const unsigned int n_shared, CellTable<dim> *values, const bool may_divide)
  {
    if (is_alone())
    {
      mesh.find_boundary_faces(cloud);
      return;
    }
    region_distance = distance;
    if (may_divide)
      divide_space(cloud, mesh);
    find_boxes(cloud);

    const unsigned int rank = cloud.rank;
    std::vector<unsigned int> new_owner(cloud.size());
    for (unsigned int i = 0; i < cloud.size(); ++i)
      new_owner[i] = parts.rank_of(cloud.position[i]);

    std::map<unsigned int, Parcel> parcels;
    parcels[rank];
    for (const unsigned int r : ranks_around(cloud))
    {
      Parcel parcel;
      std::vector<bool> goes(cloud.size(), false);
      for (unsigned int i = 0; i < cloud.size(); ++i)
        goes[i] = cloud.is_own(i) && is_near(r, cloud.position[i]);
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        if (const Simplex<dim> &cell = mesh.particle_cells()[c];
            cloud.is_own(cell) && std::any_of(cell.begin(), cell.end(), [&](const unsigned int i) {
              return is_near(r, cloud.position[i]);
            }))
        {
          for (const unsigned int i : cell)
          {
            goes[i] = true;
            parcel.cells.push_back(cloud.number[i]);
          }
          parcel.cells.push_back(mesh.fluid(c));
          if (values != nullptr)
            if (const auto key = CellTable<dim>::key(cell, cloud); const auto *value = values->find(key))
              CellTable<dim>::append(key, *value, parcel.keys, parcel.values);
        }
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (goes[i])
        {
          cloud.append_record(i, parcel.particles);
          parcel.particles.back() = new_owner[i];
        }
      if (!parcel.particles.empty())
        parcels[r] = std::move(parcel);
    }
    const Parcel kept = std::move(parcels[rank]);
    parcels.erase(rank);
    auto received = Utilities::MPI::some_to_some(mpi_communicator, parcels);
    parcels.clear();
    received[rank] = kept;

    // All that came; a particle comes from its owner and from those of its cells, always the same. Of the shared ones
    // this rank has its own copy at least.
    std::vector<double> records;
    for (const auto &[sender, parcel] : received)
      records.insert(records.end(), parcel.particles.begin(), parcel.particles.end());
    for (unsigned int i = 0; i < n_shared; ++i)
    {
      cloud.append_record(i, records);
      records.back() = new_owner[i];
    }
    cloud.reinit(records);

    std::vector<Simplex<dim>> cells;
    std::vector<unsigned int> fluids;
    for (const auto &[sender, parcel] : received)
      for (auto number = parcel.cells.begin(); number != parcel.cells.end(); number += dim + 2)
      {
        cells.emplace_back();
        for (unsigned int c = 0; c <= dim; ++c)
          cells.back()[c] = cloud.find(number[c]);
        fluids.push_back(number[dim + 1]);
      }
    mesh.reinit(cloud, cells, fluids);
    reinit(cloud);
    if (values == nullptr)
      return;
    values->clear();
    for (const auto &[sender, parcel] : received)
      values->add_all(parcel.keys, parcel.values);
    values->sort();
  }



  template <int dim>
  void Migration<dim>::distribute(ParticleCloud<dim> &cloud, const double distance,
                                  const unsigned int n_shared)
  {
    if (is_alone())
      return;
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(mpi_communicator);
    cloud.rank                 = Utilities::MPI::this_mpi_process(mpi_communicator);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      cloud.owner[i] = first_owner(cloud.number[i], cloud.next_number, n_ranks);
    FluidMesh<dim> no_mesh;
    migrate(cloud, no_mesh, distance, n_shared);
  }



  template <int dim>
  void Migration<dim>::reinit(const ParticleCloud<dim> &cloud)
  {
    if (is_alone())
      return;
    std::vector<unsigned int> copies, owners;
    std::vector<std::uint64_t> numbers;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (!cloud.is_own(i))
      {
        copies.push_back(i);
        owners.push_back(cloud.owner[i]);
        numbers.push_back(cloud.number[i]);
      }
    exchange.reinit(copies, owners, numbers, [&](const std::uint64_t number) {
      const unsigned int i = cloud.find(number);
      AssertThrow(i < cloud.size() && cloud.is_own(i),
                  ExcMessage("A rank has a copy of a particle whose owner does not have it."));
      return i;
    });
  }



  template <int dim>
  void Migration<dim>::update(ParticleCloud<dim> &cloud) const
  {
    if (is_alone())
      return;
    std::vector<double> records;
    records.reserve(cloud.size() * cloud.record_size());
    for (unsigned int i = 0; i < cloud.size(); ++i)
      cloud.append_record(i, records);
    exchange.update(records.data(), cloud.record_size());
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (!cloud.is_own(i))
        cloud.set(i, &records[i * cloud.record_size()]);
  }



  template <int dim>
  std::vector<typename Migration<dim>::MarkedCell>
  Migration<dim>::collect_cells(const ParticleCloud<dim> &cloud, const std::vector<MarkedCell> &own) const
  {
    if (is_alone())
      return own;
    std::map<unsigned int, std::vector<std::uint64_t>> sent;
    for (const unsigned int r : ranks_around(cloud))
      if (r != cloud.rank)
        for (const auto &[cell, is_new, fluid] : own)
          if (std::any_of(cell.begin(), cell.end(),
                          [&](const unsigned int i) { return is_near(r, cloud.position[i]); }))
          {
            for (const unsigned int i : cell)
              sent[r].push_back(cloud.number[i]);
            sent[r].push_back(2 * fluid + (is_new ? 1 : 0));
          }
    std::vector<MarkedCell> result = own;
    for (const auto &[sender, numbers] : Utilities::MPI::some_to_some(mpi_communicator, sent))
      for (auto number = numbers.begin(); number != numbers.end(); number += dim + 2)
      {
        MarkedCell cell{{}, number[dim + 1] % 2 == 1, static_cast<unsigned int>(number[dim + 1] / 2)};
        for (unsigned int c = 0; c <= dim; ++c)
          cell.corners[c] = cloud.find(number[c]);
        if (std::all_of(cell.corners.begin(), cell.corners.end(),
                        [&](const unsigned int i) { return i < cloud.size(); }))
          result.push_back(cell);
      }
    return result;
  }



  template class Migration<2>;
  template class Migration<3>;
} // namespace Lahar
