// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/vector.hpp>

#include <lahar/particles/first_owner.h>
#include <lahar/remeshing/migration.h>
#include <lahar/utilities/send_arrays.h>

#include <algorithm>
#include <limits>
#include <map>

namespace Lahar
{
  namespace
  {
    /// A rank may have this times the mean work before space is divided anew.
    constexpr double largest_share = 1.05;
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
  void Migration<dim>::find_boxes(const ParticleCloud<dim> &cloud, const std::vector<unsigned int> &owners)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(mpi_communicator);
    const double nothing       = -std::numeric_limits<double>::max();
    std::vector<double> bounds(n_ranks * 2 * dim, nothing); // negative lower and upper ones
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
        for (unsigned int d = 0; d < dim; ++d)
        {
          double *bound = &bounds[(owners[i] * dim + d) * 2];
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



  namespace
  {
    /// Particles and cells for other ranks, or from them, by rank.
    template <int dim>
    struct Parcels
    {
      std::map<unsigned int, std::vector<double>> particles; ///< records
      std::map<unsigned int, std::vector<unsigned int>>
        cells; ///< places of the corners among these, and the fluid
      std::map<unsigned int, std::vector<std::uint64_t>> keys; ///< of cells with values, see CellTable
      std::map<unsigned int, std::vector<double>> values;

      /// For rank @p r: the particles that @p goes is true for, with their new owners, and @p cells.
      void pack(const unsigned int r, const ParticleCloud<dim> &cloud, const std::vector<bool> &goes,
                const std::vector<unsigned int> &new_owner, const FluidMesh<dim> &mesh,
                const std::vector<unsigned int> &cells_of_mesh)
      {
        const std::size_t n = std::count(goes.begin(), goes.end(), true);
        if (n == 0)
          return;
        std::vector<unsigned int> place(cloud.size());
        particles[r].reserve(n * cloud.record_size());
        for (unsigned int i = 0, next = 0; i < cloud.size(); ++i)
          if (goes[i])
          {
            place[i] = next++;
            cloud.append_record(i, particles[r]);
            particles[r].back() = new_owner[i];
          }
        cells[r].reserve(cells_of_mesh.size() * (dim + 2));
        for (const unsigned int c : cells_of_mesh)
        {
          for (const unsigned int i : mesh.particle_cells()[c])
            cells[r].push_back(place[i]);
          cells[r].push_back(mesh.fluid(c));
        }
      }

      /// Replace what is for others by what comes from them, one array after the other.
      void send(const MPI_Comm &communicator)
      {
        particles = send_arrays(particles, communicator);
        cells     = send_arrays(cells, communicator);
        keys      = send_arrays(keys, communicator);
        values    = send_arrays(values, communicator);
      }
    };
  } // namespace



  template <int dim>
  void Migration<dim>::migrate(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh, const double distance,
                               const unsigned int n_shared, CellTable<dim> *values, const bool keeps_owners)
  {
    if (is_alone())
    {
      mesh.find_boundary_faces(cloud);
      return;
    }
    region_distance = distance;
    if (!keeps_owners)
      divide_space(cloud, mesh);
    std::vector<unsigned int> new_owner = cloud.owner;
    for (unsigned int i = 0; i < cloud.size() && !keeps_owners; ++i)
      new_owner[i] = parts.rank_of(cloud.position[i]);
    find_boxes(cloud, new_owner);

    Parcels<dim> parcels;
    std::vector<bool> is_left(cloud.size(), true); // what is for this rank stays where it is
    std::vector<unsigned int> staying_cells;
    std::vector<std::uint64_t> staying_keys;
    std::vector<double> staying_values;
    for (const unsigned int r : ranks_around(cloud))
    {
      const bool is_here = r == cloud.rank;
      std::vector<bool> goes(cloud.size(), false);
      std::vector<unsigned int> cells;
      for (unsigned int i = 0; i < cloud.size(); ++i)
        goes[i] = cloud.is_own(i) && is_near(r, cloud.position[i]);
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        if (const Simplex<dim> &cell = mesh.particle_cells()[c];
            cloud.is_own(cell) && std::any_of(cell.begin(), cell.end(), [&](const unsigned int i) {
              return is_near(r, cloud.position[i]);
            }))
        {
          cells.push_back(c);
          for (const unsigned int i : cell)
            goes[i] = true;
          if (values != nullptr)
            if (const auto key = CellTable<dim>::key(cell, cloud); const auto *value = values->find(key))
              CellTable<dim>::append(key, *value, is_here ? staying_keys : parcels.keys[r],
                                     is_here ? staying_values : parcels.values[r]);
        }
      if (is_here)
      {
        is_left = std::move(goes);
        is_left.flip();
        staying_cells = std::move(cells);
      }
      else
        parcels.pack(r, cloud, goes, new_owner, mesh, cells);
    }
    // Of the shared particles this rank has its own copy at least.
    std::vector<double> copies;
    for (unsigned int i = 0; i < n_shared; ++i)
      if (is_left[i])
      {
        cloud.append_record(i, copies);
        copies.back() = new_owner[i];
      }
    const std::vector<std::uint64_t> old_number = cloud.number;
    cloud.owner                                 = std::move(new_owner);
    cloud.remove(is_left);
    parcels.send(mpi_communicator);

    // A particle comes from its owner and from those of its cells, always the same.
    std::map<unsigned int, std::vector<std::uint64_t>> number;
    std::vector<std::vector<double>> records;
    const unsigned int record_size = cloud.record_size();
    for (auto &[sender, particles] : parcels.particles)
    {
      for (std::size_t end = record_size; end <= particles.size(); end += record_size)
        number[sender].push_back(static_cast<std::uint64_t>(particles[end - 2]));
      records.push_back(std::move(particles));
    }
    records.push_back(std::move(copies));
    cloud.add(std::move(records));

    std::vector<Simplex<dim>> cells;
    std::vector<unsigned int> fluids;
    std::size_t n_cells = staying_cells.size();
    for (const auto &[sender, corners] : parcels.cells)
      n_cells += corners.size() / (dim + 2);
    cells.reserve(n_cells);
    fluids.reserve(n_cells);
    for (const unsigned int c : staying_cells)
    {
      cells.push_back(mesh.particle_cells()[c]);
      for (unsigned int &corner : cells.back())
        corner = cloud.find(old_number[corner]);
      fluids.push_back(mesh.fluid(c));
    }
    for (auto &[sender, corners] : parcels.cells)
    {
      for (auto corner = corners.begin(); corner != corners.end(); corner += dim + 2)
      {
        cells.emplace_back();
        for (unsigned int c = 0; c <= dim; ++c)
          cells.back()[c] = cloud.find(number[sender][corner[c]]);
        fluids.push_back(corner[dim + 1]);
      }
      std::vector<unsigned int>().swap(corners);
    }
    mesh.reinit(cloud, std::move(cells), fluids);
    reinit(cloud);
    if (values == nullptr)
      return;
    values->clear();
    values->add_all(staying_keys, staying_values);
    for (const auto &[sender, keys] : parcels.keys)
      values->add_all(keys, parcels.values[sender]);
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
