#include <deal.II/base/utilities.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/vector.h>

#include <deal.II/numerics/data_out.h>

#include <lahar/assembly/fluid_cell.h>
#include <lahar/postprocess/solid_output.h>
#include <lahar/postprocess/visualization.h>
#include <lahar/remeshing/simplex_geometry.h>
#include <lahar/utilities/atomic_file.h>

#include <iomanip>

namespace Lahar
{
  template <int dim>
  Visualization<dim>::Visualization(const std::string &directory)
    : directory(directory)
  {}



  template <int dim>
  void Visualization<dim>::write(const Snapshot<dim> &snapshot)
  {
    const std::string ending = "-" + Utilities::int_to_string(n_written++, 5) + ".vtu";
    if (snapshot.mesh.n_cells() > 0)
    {
      write_fluid(snapshot, "solution" + ending);
      records.push_back({snapshot.time, 0, "solution" + ending});
    }
    if (!snapshot.solids.empty())
    {
      const SolidOutput<dim> output(snapshot.solids);
      write_atomically(directory + "/solid" + ending, [&](std::ostream &file) { output.write_vtu(file); });
      records.push_back({snapshot.time, 1, "solid" + ending});
    }
    write_records();
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



  template <int dim>
  void Visualization<dim>::write_fluid(const Snapshot<dim> &snapshot, const std::string &file_name) const
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

    write_atomically(directory + "/" + file_name, [&](std::ostream &file) { data_out.write_vtu(file); });
  }



  template class Visualization<2>;
  template class Visualization<3>;
} // namespace Lahar
