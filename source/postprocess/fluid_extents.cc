#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  /**
   * How far the fluid reaches: largest or smallest coordinate of the fluid particles in the mesh, or the difference of
   * the two, m. Isolated particles do not count.
   */
  template <int dim>
  class FluidExtents : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_entry(
        "Extents", "front: max x, height: max y", Patterns::Anything(),
        "Columns '<name> (m)' and what they hold, 'name: max|min|extent x|y|z', separated by commas. "
        "'extent' is the largest less the smallest coordinate.");
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
      unsigned int direction;
    };

    std::vector<Extent> extents;
  };



  template <int dim>
  void FluidExtents<dim>::parse_parameters(Parameters &prm)
  {
    const std::string allowed = std::string("'name: max|min|extent ") + (dim == 2 ? "x|y" : "x|y|z") +
                                "', separated by commas, every name once";
    for (const std::string &text : split_list(prm.get("Extents"), ','))
    {
      const auto name_and_rule            = split_list(text, ':');
      const std::vector<std::string> rule = name_and_rule.size() == 2 ? split_list(name_and_rule[1], ' ')
                                                                      : name_and_rule;
      const std::size_t direction         = rule.size() == 2 && rule[1].size() == 1
                                              ? std::string("xyz").substr(0, dim).find(rule[1])
                                              : std::string::npos;
      if (name_and_rule.size() != 2 || name_and_rule[0].empty() || direction == std::string::npos ||
          (rule[0] != "max" && rule[0] != "min" && rule[0] != "extent") ||
          std::any_of(extents.begin(), extents.end(),
                      [&](const Extent &e) { return e.name == name_and_rule[0]; }))
        prm.throw_wrong_value("Extents", allowed);
      extents.push_back({name_and_rule[0],
                         rule[0] == "max" ? Kind::max : (rule[0] == "min" ? Kind::min : Kind::extent),
                         static_cast<unsigned int>(direction)});
    }
  }



  template <int dim>
  void FluidExtents<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    Point<dim> lower, upper;
    bool any = false;
    for (const unsigned int particle : snapshot.mesh.particles())
      if (snapshot.cloud.kind[particle] == ParticleKind::fluid)
        for (unsigned int d = 0; d < dim; ++d)
        {
          const double x = snapshot.cloud.position[particle][d];
          lower[d]       = any ? std::min(lower[d], x) : x;
          upper[d]       = any ? std::max(upper[d], x) : x;
          any            = any || d == dim - 1;
        }
    for (const Extent &extent : extents)
    {
      const unsigned int d = extent.direction;
      add_to_column(statistics, extent.name + " (m)",
                    extent.kind == Kind::max ? upper[d]
                                             : (extent.kind == Kind::min ? lower[d] : upper[d] - lower[d]));
    }
  }



  static const Factory<Postprocessor<2>>::Registration<FluidExtents<2>> fluid_extents_2d("Fluid extents");
  static const Factory<Postprocessor<3>>::Registration<FluidExtents<3>> fluid_extents_3d("Fluid extents");
} // namespace Lahar
