// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/box.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/remeshing/connected_parts.h>
#include <lahar/utilities/factory.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Lahar
{
  /**
   * How far the fluid reaches in some directions e: largest or smallest x·e of the fluid particles in the mesh, or the
   * difference of the two, m. Isolated particles do not count, nor those of small parts of the fluid, nor, for an
   * extent with a box, those outside it; nan where none is left.
   */
  template <int dim>
  class FluidExtents : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list(
        "Extents", dim == 2 ? "front: max x, height: max y" : "front: max x, height: max z", ',',
        "Columns '<name> (m)' and what they hold, 'name: max|min|extent x|y|z', separated by commas. "
        "'extent' is the largest less the smallest coordinate. In place of a coordinate there may be the "
        "angle in degrees, counted from x towards y, of a direction in the plane of x and y.");
      const std::string point = dim == 2 ? "x, y" : "x, y, z";
      prm.declare_list("Boxes", "", ';',
                       "Boxes to which extents are limited, 'name: " + point + " : " + point +
                         "' by two opposite corners in m, separated by ';'. The name is that of an extent; "
                         "only particles in its box count.");
      prm.declare_count(
        "Smallest part", "1",
        "Parts of the fluid with fewer cells than this do not count, 1 to 1e9: a drop of a single "
        "cell thrown ahead would be the front.",
        1, 1000000000);
    }

    void parse_parameters(Parameters &prm) override;
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;

  private:
    enum class Kind
    {
      min,
      max,
      extent
    };

    struct Extent
    {
      std::string name;
      Kind kind;
      Tensor<1, dim> direction;
      Box<dim> box; ///< the whole space without a limit
    };

    static Box<dim> whole_space();

    /// By vertex: whether it is a fluid particle of a part that is large enough.
    std::vector<bool> counted(const Snapshot<dim> &snapshot) const;

    /// The direction that @p text names; zero if it names none.
    static Tensor<1, dim> direction_of(const std::string &text);

    std::vector<Extent> extents;
    unsigned int smallest_part = 1; ///< number of cells
  };



  template <int dim>
  Box<dim> FluidExtents<dim>::whole_space()
  {
    Box<dim> box({}, {});
    for (unsigned int d = 0; d < dim; ++d)
    {
      box.lower[d] = std::numeric_limits<double>::lowest();
      box.upper[d] = std::numeric_limits<double>::max();
    }
    return box;
  }



  template <int dim>
  Tensor<1, dim> FluidExtents<dim>::direction_of(const std::string &text)
  {
    Tensor<1, dim> direction;
    const std::size_t d = text.size() == 1 ? std::string("xyz").substr(0, dim).find(text) : std::string::npos;
    if (d != std::string::npos)
      direction[d] = 1.;
    else
      try
      {
        const double angle = to_number(text) * numbers::PI / 180.;
        direction[0]       = std::cos(angle);
        direction[1]       = std::sin(angle);
      }
      catch (const std::invalid_argument &)
      {}
    return direction;
  }



  template <int dim>
  void FluidExtents<dim>::parse_parameters(Parameters &prm)
  {
    const std::string allowed = std::string("'name: max|min|extent ") + (dim == 2 ? "x|y" : "x|y|z") +
                                "|angle', separated by commas, every name once";
    for (const std::string &text : split_list(prm.get("Extents"), ','))
    {
      const auto name_and_rule            = split_list(text, ':');
      const std::vector<std::string> rule = name_and_rule.size() == 2 ? split_list(name_and_rule[1], ' ')
                                                                      : name_and_rule;
      const Tensor<1, dim> direction      = rule.size() == 2 ? direction_of(rule[1]) : Tensor<1, dim>();
      if (name_and_rule.size() != 2 || name_and_rule[0].empty() || !(direction.norm() > 0.) ||
          (rule[0] != "max" && rule[0] != "min" && rule[0] != "extent") ||
          std::any_of(extents.begin(), extents.end(),
                      [&](const Extent &e) { return e.name == name_and_rule[0]; }))
        prm.throw_wrong_value("Extents", allowed);
      extents.push_back({name_and_rule[0],
                         rule[0] == "max" ? Kind::max : (rule[0] == "min" ? Kind::min : Kind::extent),
                         direction, whole_space()});
    }
    for (const auto &[name, corners] : parse_named_points<dim>(prm, "Boxes", 2))
    {
      const auto extent = std::find_if(extents.begin(), extents.end(),
                                       [&, &name = name](const Extent &e) { return e.name == name; });
      if (extent == extents.end())
        prm.throw_wrong_value("Boxes", "boxes with the names of 'Extents' (there is no '" + name + "')");
      extent->box = Box<dim>(corners[0], corners[1]);
    }
    smallest_part = prm.get_count("Smallest part", 1, 1000000000);
  }



  template <int dim>
  std::vector<bool> FluidExtents<dim>::counted(const Snapshot<dim> &snapshot) const
  {
    const ParticleCloud<dim> &cloud = snapshot.cloud;
    ConnectedParts<dim> parts(cloud.size());
    std::vector<double> n_cells(cloud.size(), 0.);
    for (const Simplex<dim> &cell : snapshot.mesh.particle_cells())
    {
      for (unsigned int I = 1; I <= dim; ++I)
        parts.join(cell[0], cell[I]);
      if (cloud.is_own(cell))
        ++n_cells[cell[0]];
    }
    parts.connect(cloud, snapshot.migration);
    n_cells = parts.sum(n_cells, snapshot.migration);

    std::vector<bool> result;
    for (const unsigned int i : snapshot.mesh.particles())
      result.push_back(n_cells[i] >= smallest_part && cloud.kind[i] == ParticleKind::fluid &&
                       cloud.is_own(i));
    return result;
  }



  template <int dim>
  void FluidExtents<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    if (extents.empty())
      return;
    constexpr double nothing       = -std::numeric_limits<double>::max();
    const std::vector<bool> counts = counted(snapshot);
    for (const Extent &extent : extents)
    {
      double bounds[2] = {nothing, nothing}; // negative lower and upper one
      for (unsigned int v = 0; v < counts.size(); ++v)
      {
        const Point<dim> &position = snapshot.cloud.position[snapshot.mesh.particle(v)];
        if (!counts[v] || !extent.box.contains(position, 0.))
          continue;
        const double x = extent.direction * position;
        bounds[0]      = std::max(bounds[0], -x);
        bounds[1]      = std::max(bounds[1], x);
      }
      Utilities::MPI::max(ArrayView<const double>(bounds, 2), snapshot.communicator(),
                          ArrayView<double>(bounds, 2));
      double value = extent.kind == Kind::max   ? bounds[1]
                     : extent.kind == Kind::min ? -bounds[0]
                                                : bounds[0] + bounds[1];
      if (bounds[1] == nothing)
        value = std::numeric_limits<double>::quiet_NaN();
      add_to_column(statistics, extent.name + " (m)", value);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<FluidExtents<2>>
    fluid_extents_2d("Fluid extents", "How far the fluid reaches.");
  static const Factory<Postprocessor<3>>::Registration<FluidExtents<3>>
    fluid_extents_3d("Fluid extents", "How far the fluid reaches.");
} // namespace Lahar
