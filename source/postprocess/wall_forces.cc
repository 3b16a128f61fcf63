#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

#include <stdexcept>

namespace Lahar
{
  /**
   * Force of the fluid on the walls inside a box, N (N/m in 2D): the sum of the reactions of the discrete momentum
   * equation at the wall's particles and, for slip walls, at the particles that slide on it.
   */
  template <int dim>
  class WallForces : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_entry("Boxes", "", Patterns::Anything(),
                        "Boxes in m, 'name: x, y : x, y' by two opposite corners, separated by ';'. Columns "
                        "'<name> force x (N)' ...: the force on the walls inside the box.");
    }

    void parse_parameters(Parameters &prm) override;
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;

  private:
    struct Box
    {
      std::string name;
      Point<dim> lower, upper;
    };

    std::vector<Box> boxes;
  };



  template <int dim>
  void WallForces<dim>::parse_parameters(Parameters &prm)
  {
    const std::string allowed = dim == 2 ? "'name: x, y : x, y' separated by ';'"
                                         : "'name: x, y, z : x, y, z' separated by ';'";
    for (const std::string &text : split_list(prm.get("Boxes"), ';'))
    {
      const auto parts = split_list(text, ':');
      if (parts.size() != 3 || parts[0].empty())
        prm.throw_wrong_value("Boxes", allowed);
      Box box{parts[0], {}, {}};
      const auto first = split_list(parts[1], ','), second = split_list(parts[2], ',');
      if (first.size() != dim || second.size() != dim)
        prm.throw_wrong_value("Boxes", allowed);
      try
      {
        for (unsigned int d = 0; d < dim; ++d)
        {
          box.lower[d] = std::min(to_number(first[d]), to_number(second[d]));
          box.upper[d] = std::max(to_number(first[d]), to_number(second[d]));
        }
      }
      catch (const std::invalid_argument &)
      {
        prm.throw_wrong_value("Boxes", allowed);
      }
      boxes.push_back(box);
    }
  }



  template <int dim>
  void WallForces<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    for (const Box &box : boxes)
    {
      Tensor<1, dim> force;
      for (unsigned int v = 0; v < snapshot.wall_forces.size(); ++v)
      {
        const unsigned int particle = snapshot.mesh.particle(v);
        bool inside                 = snapshot.cloud.kind[particle] == ParticleKind::wall ||
                      snapshot.cloud.on_slip_wall(particle);
        for (unsigned int d = 0; d < dim; ++d)
          inside = inside && snapshot.cloud.position[particle][d] >= box.lower[d] &&
                   snapshot.cloud.position[particle][d] <= box.upper[d];
        if (inside)
          force -= snapshot.wall_forces[v];
      }
      for (unsigned int d = 0; d < dim; ++d)
        add_to_column(statistics, box.name + " force " + "xyz"[d] + " (N)", force[d]);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<WallForces<2>> wall_forces_2d("Wall forces");
  static const Factory<Postprocessor<3>>::Registration<WallForces<3>> wall_forces_3d("Wall forces");
} // namespace Lahar
