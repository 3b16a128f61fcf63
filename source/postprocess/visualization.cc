#include <deal.II/base/utilities.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/vector.h>

#include <deal.II/numerics/data_out.h>

#include <lahar/assembly/fluid_cell.h>
#include <lahar/postprocess/solid_output.h>
#include <lahar/postprocess/visualization.h>
#include <lahar/remeshing/simplex_geometry.h>
#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/ranks.h>

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace Lahar
{
  template <int dim>
  Visualization<dim>::Visualization(const std::string &directory, const MPI_Comm &communicator)
    : directory(directory)
    , communicator(communicator)
  {}



  template <int dim>
  void Visualization<dim>::write(const Snapshot<dim> &snapshot)
  {
    const std::string number = "-" + Utilities::int_to_string(n_written++, 5);
    if (snapshot.mesh.n_cells() > 0)
      records.push_back({snapshot.time, 0, write_fluid(snapshot, "solution" + number)});
    if (!snapshot.solids.empty())
      records.push_back({snapshot.time, 1, "solid" + number + ".vtu"});
    on_first_rank(communicator, [&] {
      if (!snapshot.solids.empty())
      {
        const SolidOutput<dim> output(snapshot.solids);
        write_atomically(directory + "/" + records.back().file_name,
                         [&](std::ostream &file) { output.write_vtu(file); });
      }
      write_records();
    });
  }



  template <int dim>
  void Visualization<dim>::write_records() const
  {
    write_atomically(directory + "/solution.pvd", [&](std::ostream &file) {
      file << "<?xml version=\"1.0\"?>\n"
              "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n"
           << std::setprecision(12);
      for (const Record &record : records)
        file << "<DataSet timestep=\"" << record.time << "\" group=\"\" part=\"" << record.part
             << "\" file=\"" << record.file_name << "\"/>\n";
      file << "</Collection>\n</VTKFile>\n";
    });
  }



  namespace
  {
    std::string piece_name(const std::string &name, const unsigned int piece, const unsigned int n_pieces)
    {
      return name + (n_pieces > 1 ? "." + std::to_string(piece) : "") + ".vtu";
    }
  } // namespace



  template <int dim>
  std::string Visualization<dim>::write_fluid(const Snapshot<dim> &snapshot, const std::string &name) const
  {
    const unsigned int n_cells  = snapshot.mesh.n_cells(),
                       n_pieces = std::min(Utilities::MPI::n_mpi_processes(communicator), n_cells),
                       piece    = Utilities::MPI::this_mpi_process(communicator);
    std::string list;
    on_all_ranks(communicator, [&] {
      if (n_pieces == 1 && piece == 0)
        write_piece(snapshot, name, n_pieces);
      else if (n_pieces > 1 && piece < n_pieces)
      {
        const auto first_of = [&](const std::size_t i) { return i * n_cells / n_pieces; };
        std::vector<unsigned int> cells(first_of(piece + 1) - first_of(piece)), vertices;
        std::iota(cells.begin(), cells.end(), first_of(piece));
        for (const unsigned int c : cells)
          vertices.insert(vertices.end(), snapshot.mesh.cells()[c].begin(), snapshot.mesh.cells()[c].end());
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        FluidMesh<dim> part;
        part.reinit_part(snapshot.mesh, vertices, cells);
        list = write_piece({snapshot.cloud, part, snapshot.law, snapshot.gravity, snapshot.wall_forces,
                            snapshot.solids, snapshot.solid_forces, snapshot.time},
                           name, n_pieces);
      }
    });
    if (n_pieces > 1)
      on_first_rank(communicator, [&] {
        write_atomically(directory + "/" + name + ".pvtu", [&](std::ostream &file) { file << list; });
      });
    return name + (n_pieces == 1 ? ".vtu" : ".pvtu");
  }



  template <int dim>
  std::string Visualization<dim>::write_piece(const Snapshot<dim> &snapshot, const std::string &name,
                                              const unsigned int n_pieces) const
  {
    const FluidMesh<dim> &mesh      = snapshot.mesh;
    const ParticleCloud<dim> &cloud = snapshot.cloud;
    const unsigned int n            = mesh.n_vertices();

    const FESystem<dim> velocity_fe(FE_SimplexP<dim>(1), dim);
    DoFHandler<dim> velocity_dofs(mesh.triangulation());
    velocity_dofs.distribute_dofs(velocity_fe);
    Vector<double> velocity(velocity_dofs.n_dofs());
    for (const auto &cell : velocity_dofs.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
          velocity[cell->vertex_dof_index(v, d)] = cloud.velocity[mesh.particle(cell->vertex_index(v))][d];

    Vector<double> pressure(n), kind(n);
    for (unsigned int v = 0; v < n; ++v)
    {
      const unsigned int particle = mesh.particle(v);
      pressure[v]                 = cloud.pressure[particle];
      kind[v]                     = static_cast<double>(cloud.kind[particle]);
    }

    Vector<double> strain_rate(mesh.n_cells()), viscosity(mesh.n_cells()), yielded(mesh.n_cells());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      FluidCell<dim> cell;
      for (unsigned int I = 0; I <= dim; ++I)
        cell.velocity[I] = cloud.velocity[mesh.particle_cells()[c][I]];
      cell.reinit(corners_of<dim>(mesh.particle_cells()[c], cloud.position), false);
      strain_rate[c] = cell.strain_rate;
      viscosity[c]   = snapshot.law.effective_viscosity(cell.strain_rate).value;
      yielded[c]     = snapshot.law.is_yielded(cell.strain_rate);
    }

    DataOut<dim> data_out;
    data_out.attach_dof_handler(mesh.dof_handler());
    data_out.add_data_vector(velocity_dofs, velocity, std::vector<std::string>(dim, "velocity"),
                             std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                               dim, DataComponentInterpretation::component_is_part_of_vector));
    data_out.add_data_vector(pressure, "pressure", DataOut<dim>::type_dof_data);
    data_out.add_data_vector(kind, "particle_kind", DataOut<dim>::type_dof_data);
    data_out.add_data_vector(strain_rate, "strain_rate", DataOut<dim>::type_cell_data);
    data_out.add_data_vector(viscosity, "effective_viscosity", DataOut<dim>::type_cell_data);
    data_out.add_data_vector(yielded, "yielded", DataOut<dim>::type_cell_data);
    data_out.build_patches(mesh.mapping());

    const unsigned int piece = Utilities::MPI::this_mpi_process(communicator);
    write_atomically(directory + "/" + piece_name(name, piece, n_pieces),
                     [&](std::ostream &file) { data_out.write_vtu(file); });
    std::vector<std::string> names;
    for (unsigned int p = 0; p < n_pieces; ++p)
      names.push_back(piece_name(name, p, n_pieces));
    std::ostringstream list;
    data_out.write_pvtu_record(list, names);
    return list.str();
  }



  template class Visualization<2>;
  template class Visualization<3>;
} // namespace Lahar
