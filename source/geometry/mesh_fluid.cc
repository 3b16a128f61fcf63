// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/mesh_body.h>
#include <lahar/geometry/mesh_entries.h>
#include <lahar/utilities/factory.h>

#include <map>
#include <sstream>

namespace Lahar
{
  /// Physical groups of a gmsh file, all together one body: the mesh gives the shape, not the particles.
  template <int dim>
  class MeshFluid : public FluidShape<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      declare_mesh_entries(
        prm, std::string(dim == 2 ? "surfaces" : "volumes") +
               " that are fluid. The mesh gives the shape, 'Mesh size' the distance of particles");
    }

    void parse_parameters(Parameters &prm) override;

    typename FluidShape<dim>::Bodies bodies(const std::string &name) const override
    {
      typename FluidShape<dim>::Bodies result;
      result.push_back(std::make_unique<MeshBody<dim>>(name, nodes, simplices));
      return result;
    }

    void check_scale(const double h) const override;

  private:
    std::vector<Point<dim>> nodes;
    std::vector<Simplex<dim>> simplices;
    double scale = 1.;
    std::string scale_path;
    std::map<std::string, double> mean_edges; ///< of the groups, by what messages call them, m
  };



  template <int dim>
  void MeshFluid<dim>::parse_parameters(Parameters &prm)
  {
    const MeshEntries entries(prm);
    scale      = entries.scale;
    scale_path = entries.scale_path;
    const GmshFile<dim> file(entries.file_name, scale, entries.element_size);
    for (const std::string &group : entries.groups)
    {
      std::vector<Point<dim>> of_group;
      std::vector<Simplex<dim>> cells;
      file.cells_of(group, of_group, cells);
      for (Simplex<dim> &cell : cells)
        for (unsigned int &corner : cell)
          corner += nodes.size();
      simplices.insert(simplices.end(), cells.begin(), cells.end());
      nodes.insert(nodes.end(), of_group.begin(), of_group.end());
      mean_edges["group '" + group + "' of " + entries.file_name] = file.mean_edge(group);
    }
  }



  template <int dim>
  void MeshFluid<dim>::check_scale(const double h) const
  {
    constexpr double largest = 100.;
    for (const auto &[group, edge] : mean_edges)
      if (!(edge < largest * h && edge > h / largest))
      {
        std::ostringstream message;
        message << "Parameter '" << scale_path << "' is " << scale << ", with which the edges of " << group
                << " have a mean length of " << edge << " m; 'Mesh size' is " << h
                << " m. Allowed: a scale that makes metres of the file's unit (1e-3 for mm), and edges about "
                   "as long as 'Mesh size'.";
        throw InputError(message.str());
      }
  }



  static const Factory<FluidShape<2>>::Registration<MeshFluid<2>> mesh_fluid_2d("mesh",
                                                                                "Surfaces of a gmsh file.");
  static const Factory<FluidShape<3>>::Registration<MeshFluid<3>> mesh_fluid_3d("mesh",
                                                                                "Volumes of a gmsh file.");
} // namespace Lahar
