// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  /// The largest speed of the particles in the mesh, m/s, if it is asked for.
  template <int dim>
  class LargestSpeed : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_text("Column", "", "Name of the column; none without a name.");
    }

    void parse_parameters(Parameters &prm) override
    {
      name = prm.get("Column");
    }

    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override
    {
      if (name.empty())
        return;
      double speed = 0.;
      for (const unsigned int particle : snapshot.mesh.particles())
        speed = std::max(speed, snapshot.cloud.velocity[particle].norm());
      speed = Utilities::MPI::max(speed, snapshot.communicator());
      add_to_column(statistics, name + " (m/s)", speed);
    }

  private:
    std::string name;
  };



  static const Factory<Postprocessor<2>>::Registration<LargestSpeed<2>>
    largest_speed_2d("Largest speed", "The largest speed of the particles.");
  static const Factory<Postprocessor<3>>::Registration<LargestSpeed<3>>
    largest_speed_3d("Largest speed", "The largest speed of the particles.");
} // namespace Lahar
