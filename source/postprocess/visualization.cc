// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/utilities.h>

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/vector.h>

#include <deal.II/numerics/data_out.h>

#include <lahar/postprocess/solid_output.h>
#include <lahar/postprocess/visualization.h>
#include <lahar/postprocess/wall_output.h>
#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/ranks.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <list>
#include <sstream>

namespace Lahar
{
  namespace
  {
    const std::string walls_file = "walls.vtu";

    /// Vectors by vertex or by cell as degrees of freedom of linear simplices.
    template <int dim>
    Vector<double> to_dofs(const Vector<double> &vectors, const bool of_vertices, const DoFHandler<dim> &dofs)
    {
      const FiniteElement<dim> &fe = dofs.get_fe();
      Vector<double> result(dofs.n_dofs());
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      for (const auto &cell : dofs.active_cell_iterators())
      {
        cell->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
        {
          const auto [component, corner] = fe.system_to_component_index(i);
          const unsigned int place = of_vertices ? cell->vertex_index(corner) : cell->active_cell_index();
          result[indices[i]]       = vectors[dim * place + component];
        }
      }
      return result;
    }
  } // namespace



  template <int dim>
  Visualization<dim>::Visualization(const std::string &directory, const MPI_Comm &communicator)
    : directory(directory)
    , communicator(communicator)
  {}



  template <int dim>
  std::string Visualization<dim>::write(const Snapshot<dim> &snapshot,
                                        const typename OutputField<dim>::List &fields)
  {
    const std::string number = "-" + Utilities::int_to_string(n_written++, 5);
    if (const std::string fluid_file = write_fluid(snapshot, fields, "solution" + number);
        !fluid_file.empty())
      records.push_back({snapshot.time, 0, fluid_file});
    if (!snapshot.solids.empty())
      records.push_back({snapshot.time, 1, "solid" + number + ".vtu"});
    const bool walls_move = any_moves(snapshot.walls);
    if (has_walls)
      records.push_back({snapshot.time, 2, walls_move ? "walls" + number + ".vtu" : walls_file});
    std::string news;
    on_first_rank(communicator, [&] {
      if (!snapshot.solids.empty())
      {
        const SolidOutput<dim> output(snapshot.solids);
        write_atomically(directory + "/solid" + number + ".vtu",
                         [&](std::ostream &file) { output.write_vtu(file); });
      }
      if (walls_move)
        write_atomically(directory + "/walls" + number + ".vtu",
                         [&](std::ostream &file) { write_walls_vtu(snapshot.walls, file); });
      news = write_records();
    });
    return news;
  }



  template <int dim>
  void Visualization<dim>::write_walls(const Walls<dim> &walls)
  {
    has_walls = !walls.facets().empty();
    if (has_walls && !any_moves(walls))
      on_first_rank(communicator, [&] {
        write_atomically(directory + "/" + walls_file,
                         [&](std::ostream &file) { write_walls_vtu(walls, file); });
      });
  }



  template <int dim>
  std::string Visualization<dim>::write_records()
  {
    std::vector<std::string> removed;
    for (const Record &record : records)
    {
      std::error_code error;
      if (std::filesystem::exists(directory + "/" + record.file_name, error))
        missing.erase(record.file_name);
      else if (missing.insert(record.file_name).second)
        removed.push_back(record.file_name);
    }
    write_atomically(directory + "/solution.pvd", [&](std::ostream &file) {
      file << "<?xml version=\"1.0\"?>\n"
              "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n"
           << std::setprecision(12);
      for (const Record &record : records)
        if (missing.count(record.file_name) == 0)
          file << "<DataSet timestep=\"" << record.time << "\" group=\"\" part=\"" << record.part
               << "\" file=\"" << record.file_name << "\"/>\n";
      file << "</Collection>\n</VTKFile>\n";
    });
    if (removed.empty())
      return "";
    return "Warning: " + std::to_string(removed.size()) + " of the snapshots so far, '" + directory + "/" +
           removed.front() + "' first, are not there any more. 'solution.pvd' leaves them out.";
  }



  template <int dim>
  std::string Visualization<dim>::write_fluid(const Snapshot<dim> &snapshot,
                                              const typename OutputField<dim>::List &fields,
                                              const std::string &name) const
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator),
                       rank    = Utilities::MPI::this_mpi_process(communicator);
    // Each rank writes its own cells, if it has some.
    const std::vector<unsigned int> cells   = snapshot.mesh.own_cells(snapshot.cloud);
    const std::vector<unsigned int> n_cells = Utilities::MPI::all_gather<unsigned int>(communicator,
                                                                                       cells.size());
    std::vector<std::string> pieces;
    std::string own_piece, list;
    for (unsigned int r = 0; r < n_ranks; ++r)
      if (n_cells[r] > 0)
      {
        pieces.push_back(name + (n_ranks > 1 ? "." + std::to_string(r) : "") + ".vtu");
        if (r == rank)
          own_piece = pieces.back();
      }
    if (pieces.empty())
      return "";
    on_all_ranks(communicator, [&] {
      if (cells.empty())
        return;
      if (n_ranks == 1)
      {
        write_piece(snapshot, fields, own_piece, pieces);
        return;
      }
      std::vector<unsigned int> vertices;
      for (const unsigned int c : cells)
        vertices.insert(vertices.end(), snapshot.mesh.cells()[c].begin(), snapshot.mesh.cells()[c].end());
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      FluidMesh<dim> part;
      part.reinit_part(snapshot.mesh, vertices, cells);
      list = write_piece({snapshot.cloud, part, snapshot.materials, snapshot.gravity, snapshot.solids,
                          snapshot.walls, snapshot.migration, snapshot.means, snapshot.time,
                          snapshot.multipliers},
                         fields, own_piece, pieces);
    });
    if (n_ranks == 1)
      return pieces[0];
    // Any rank with cells knows the list.
    const std::string file_name = name + ".pvtu";
    list                        = Utilities::MPI::broadcast(communicator, list,
                                                            std::find_if(n_cells.begin(), n_cells.end(),
                                                                         [](const unsigned int n) { return n > 0; }) -
                                                              n_cells.begin());
    on_first_rank(communicator, [&] {
      write_atomically(directory + "/" + file_name, [&](std::ostream &file) { file << list; });
    });
    return file_name;
  }



  template <int dim>
  std::string Visualization<dim>::write_piece(const Snapshot<dim> &snapshot,
                                              const typename OutputField<dim>::List &fields,
                                              const std::string &file_name,
                                              const std::vector<std::string> &pieces) const
  {
    const FluidMesh<dim> &mesh = snapshot.mesh;
    // A vector is a function of linear simplices, continuous ones for values of vertices.
    const FESystem<dim> vertex_fe(FE_SimplexP<dim>(1), dim), cell_fe(FE_SimplexDGP<dim>(1), dim);
    DoFHandler<dim> vertex_dofs(mesh.triangulation()), cell_dofs(mesh.triangulation());
    std::list<Vector<double>> all_values; // data_out refers to them
    DataOut<dim> data_out;
    data_out.attach_dof_handler(mesh.dof_handler());
    for (const auto &[field_name, field] : fields)
    {
      if (!field->is_there(snapshot))
        continue;
      const bool of_vertices       = field->place() == OutputField<dim>::Place::vertices;
      const Vector<double> &values = all_values.emplace_back(field->evaluate(snapshot));
      AssertDimension(values.size(),
                      field->n_components() * (of_vertices ? mesh.n_vertices() : mesh.n_cells()));
      if (field->n_components() == 1)
      {
        data_out.add_data_vector(values, field_name,
                                 of_vertices ? DataOut<dim>::type_dof_data : DataOut<dim>::type_cell_data);
        continue;
      }
      AssertDimension(field->n_components(), dim);
      DoFHandler<dim> &dofs = of_vertices ? vertex_dofs : cell_dofs;
      if (!dofs.has_active_dofs())
        dofs.distribute_dofs(of_vertices ? vertex_fe : cell_fe);
      data_out.add_data_vector(dofs, all_values.emplace_back(to_dofs(values, of_vertices, dofs)),
                               std::vector<std::string>(dim, field_name),
                               std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                                 dim, DataComponentInterpretation::component_is_part_of_vector));
    }
    data_out.build_patches(mesh.mapping());

    write_atomically(directory + "/" + file_name, [&](std::ostream &file) { data_out.write_vtu(file); });
    std::ostringstream list;
    data_out.write_pvtu_record(list, pieces);
    return list.str();
  }



  template class Visualization<2>;
  template class Visualization<3>;
} // namespace Lahar
