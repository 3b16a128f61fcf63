// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_output_field_h
#define lahar_postprocess_output_field_h

#include <deal.II/lac/vector.h>

#include <lahar/assembly/cell_flow.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/postprocess/postprocessor.h>

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * A field of the fluid in the files for ParaView, see Visualization: one number or one vector by vertex of the mesh or
   * by cell.
   *
   * A model of this kind registers itself with Factory<OutputField<dim>>, under the name that the field has in the files.
   * All are written unless "Postprocess/Fields" names some; the entries of one stand in the subsection of its name in
   * "Postprocess".
   */
  template <int dim>
  class OutputField
  {
  public:
    /// What has a value each.
    enum class Place
    {
      vertices,
      cells
    };

    /// Fields by name, as they follow each other in the files.
    using List = std::vector<std::pair<std::string, std::unique_ptr<OutputField>>>;

    virtual ~OutputField() = default;

    virtual void parse_parameters(Parameters & /*prm*/) {}

    virtual Place place() const = 0;

    /// 1, or dim for a vector.
    virtual unsigned int n_components() const
    {
      return 1;
    }

    /// In the files fields follow each other by this number, those of the same one by name.
    virtual unsigned int position() const
    {
      return std::numeric_limits<unsigned int>::max();
    }

    /// Whether the case has such a field; without, it is not in the files. The same on all ranks.
    virtual bool is_there(const Snapshot<dim> & /*snapshot*/) const
    {
      return true;
    }

    /// The values of the vertices or cells of the snapshot's mesh in its order, the components of one side by side.
    virtual Vector<double> evaluate(const Snapshot<dim> &snapshot) const = 0;

    static void declare_all(Parameters &prm);

    /// The fields that are to be written. @throws InputError if one is not known.
    static List create_all(Parameters &prm);
  };

  /// Call @p action with number and CellFlow of every cell of the snapshot's mesh.
  template <int dim, typename Action>
  void for_each_cell(const Snapshot<dim> &snapshot, const Action &action)
  {
    const auto &cells = snapshot.mesh.particle_cells();
    for (unsigned int c = 0; c < cells.size(); ++c)
    {
      const CellFlow<dim> cell(corners_of<dim>(cells[c], snapshot.cloud.position), cells[c],
                               snapshot.cloud.velocity, snapshot.cloud.pressure);
      action(c, cell);
    }
  }
} // namespace Lahar

#endif
