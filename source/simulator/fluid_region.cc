// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/fluid_region.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/vector.hpp>

namespace Lahar
{
  template <int dim>
  std::pair<unsigned int, unsigned int>
  FluidRegion<dim>::n_particles_and_cells(const MPI_Comm &communicator) const
  {
    unsigned int n_own = 0;
    for (unsigned int i = 0; i < particles.size(); ++i)
      n_own += particles.is_own(i);
    const unsigned int n_cells = mesh.own_cells(particles).size();
    return {Utilities::MPI::sum(n_own, communicator), Utilities::MPI::sum(n_cells, communicator)};
  }



  template <int dim>
  void FluidRegion<dim>::save(boost::archive::binary_oarchive &archive) const
  {
    std::vector<bool> is_saved(particles.size(), false);
    std::vector<std::uint64_t> cells, keys;
    std::vector<double> values;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      if (const Simplex<dim> &cell = mesh.particle_cells()[c]; particles.is_own(cell))
      {
        for (const unsigned int i : cell)
        {
          is_saved[i] = true;
          cells.push_back(particles.number[i]);
        }
        cells.push_back(mesh.fluid(c));
        if (!multipliers.values().empty())
          CellTable<dim>::append(CellTable<dim>::key(cell, particles), multipliers.values()[c], keys, values);
      }
    std::vector<double> records;
    for (unsigned int i = 0; i < particles.size(); ++i)
      if (is_saved[i] || particles.is_own(i))
        particles.append_record(i, records);
    archive << records << cells << keys << values;
  }



  template <int dim>
  void FluidRegion<dim>::load(boost::archive::binary_iarchive &archive, const unsigned int n_ranks,
                              Pieces &pieces)
  {
    std::vector<double> records, values;
    std::vector<std::uint64_t> cells, keys;
    archive >> records >> cells >> keys >> values;
    multipliers.table().add_all(keys, values);
    // A rank's piece was read by this one.
    for (std::size_t owner = particles.record_size() - 1; owner < records.size();
         owner += particles.record_size())
      records[owner] = static_cast<unsigned int>(records[owner]) % n_ranks;
    pieces.records.insert(pieces.records.end(), records.begin(), records.end());
    pieces.cells.insert(pieces.cells.end(), cells.begin(), cells.end());
  }



  template <int dim>
  void FluidRegion<dim>::reinit(Pieces pieces, const Solids<dim> &solids, const unsigned int n_ranks)
  {
    for (unsigned int i = 0; i < solids.mesh().n_contour_nodes(); ++i)
    {
      particles.position[i] = solids.state().position[i];
      particles.velocity[i] = solids.state().velocity[i];
      particles.append_record(i, pieces.records);
      pieces.records.back() = n_ranks;
    }
    particles.reinit(pieces.records);
    std::vector<Simplex<dim>> cells;
    std::vector<unsigned int> fluids;
    for (auto number = pieces.cells.begin(); number != pieces.cells.end(); number += dim + 2)
    {
      cells.emplace_back();
      for (unsigned int c = 0; c <= dim; ++c)
        cells.back()[c] = particles.find(number[c]);
      fluids.push_back(number[dim + 1]);
    }
    mesh.reinit(particles, cells, fluids);
    multipliers.table().sort();
  }



  template <int dim>
  void FluidRegion<dim>::tell_owners(const unsigned int n, const MPI_Comm &communicator)
  {
    std::vector<unsigned int> owners(n, 0);
    for (unsigned int i = 0; i < n; ++i)
      owners[i] = particles.is_own(i) ? particles.rank : 0;
    Utilities::MPI::max(owners, communicator, owners);
    std::copy(owners.begin(), owners.end(), particles.owner.begin());
  }



  template struct FluidRegion<2>;
  template struct FluidRegion<3>;
} // namespace Lahar
