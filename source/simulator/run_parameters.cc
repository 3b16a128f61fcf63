// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/simulator/run_parameters.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  void RunParameters::declare_parameters(Parameters &prm)
  {
    prm.declare_choice("Dimension", "2", "2|3", "Space dimension: 2, see 'Geometry', or 3.");
    prm.declare_choice(
      "Geometry", "plane", "plane|rotational symmetry",
      "What two dimensions stand for. plane: plane strain, all extensive quantities per metre of depth. rotational "
      "symmetry: x is the distance r from the axis x = 0 and y the height z, without flow round the axis; volumes, "
      "masses, energies and forces are those of the whole body. In three dimensions 'plane' has no meaning.");
    prm.declare_file_list("Plugins",
                          "Shared libraries with further models, separated by ';', see doc/extending.md.");
    prm.declare_names(
      "Fluids", "Names of the fluids, separated by ','; each has a subsection of its name in 'Fluids'.");
    prm.declare_names(
      "Boundaries",
      "Names of the boundaries, separated by ','; each has a subsection of its name in 'Boundaries'.");
    prm.declare_names(
      "Solids", "Names of the solids, separated by ','; each has a subsection of its name in 'Solids'.");
    prm.declare_text("Output directory", "output",
                     "Directory for everything that the run writes; it is created if need be.");
    prm.declare_number("Start time", "0", "Time at the start in s.");
    prm.declare_number("End time", "1", "Time at the end in s, after the start.");
    prm.declare_positive("Time step", "1e-3", "Time step in s, above zero.");
    prm.declare_positive(
      "Minimum time step", "0",
      "A step that fails is repeated in halves down to this length in s, then the run stops; 0 means a "
      "sixty-fourth of the time step.");
    prm.declare_positive(
      "Maximum time step", "0",
      "Where the flow is slow, steps become longer than the time step, up to this length in s, so far as "
      "no particle of the mesh moves by more than a tenth of its spacing; 0 means the time step.");
    prm.declare_positive(
      "Largest movement", "2",
      "How far particles of the mesh may move in a step, in units of their spacing, above zero. "
      "Where they are faster, the step is halved; if they accelerate to twice as much within a "
      "step, it is repeated in halves.");
    prm.declare_positive(
      "Mesh size", "0.01",
      "Distance of neighbouring particles in m, above zero and at most the size of every body.");
    prm.declare_positive("Output interval", "0.01",
                         "Time between the snapshots for ParaView in s, zero or above; 0 writes every step.");
    prm.enter_subsection("Checkpoint");
    prm.declare_count("Steps between", "0",
                      "Write a checkpoint whenever this number of time steps is done; 0: steps do not count.",
                      0, 1000000000);
    prm.declare_positive(
      "Minutes between", "1",
      "Write a checkpoint whenever this wall time in minutes has passed, and a hundred times what the last one took; 0: "
      "it does not count. There is one at the end of a run, too, and when a signal stops it.");
    prm.leave_subsection();
  }



  void RunParameters::parse_parameters(Parameters &prm)
  {
    if (prm.get("Dimension") != "2" && prm.get("Dimension") != "3")
      prm.throw_wrong_value("Dimension", "2|3");
    if (prm.get("Geometry") != "plane" && prm.get("Geometry") != "rotational symmetry")
      prm.throw_wrong_value("Geometry", "plane|rotational symmetry");
    Symmetry::set_rotational(prm.get("Geometry") == "rotational symmetry");
    if (Symmetry::is_rotational() && prm.get("Dimension") != "2")
      prm.throw_wrong_value("Geometry", "plane, as 'Dimension' is 3");
    output_directory = prm.get("Output directory");
    if (output_directory.empty())
      prm.throw_wrong_value("Output directory", "the name of a directory");
    start_time = prm.get_number("Start time");
    end_time   = prm.get_number("End time");
    if (!(end_time > start_time))
      prm.throw_wrong_value("End time", "a time after 'Start time', which is " + prm.get("Start time"));
    time_step         = prm.get_positive("Time step");
    minimum_time_step = prm.get_positive("Minimum time step", true);
    if (minimum_time_step > time_step)
      prm.throw_wrong_value("Minimum time step", "at most 'Time step', which is " + prm.get("Time step"));
    if (minimum_time_step == 0.)
      minimum_time_step = time_step / 64.;
    maximum_time_step = prm.get_positive("Maximum time step", true);
    if (maximum_time_step == 0.)
      maximum_time_step = time_step;
    if (maximum_time_step < time_step)
      prm.throw_wrong_value("Maximum time step",
                            "0 or at least 'Time step', which is " + prm.get("Time step"));
    // Times are sums of steps: each must change them.
    const double latest = std::max(std::abs(start_time), std::abs(end_time));
    if (minimum_time_step < 1e-14 * latest)
      prm.throw_wrong_value(
        time_step < 1e-12 * latest ? "Time step" : "Minimum time step",
        "'Time step' at least 1e-12, 'Minimum time step' 0 or at least 1e-14 of 'Start time' and "
        "'End time'");
    largest_movement = prm.get_positive("Largest movement");
    mesh_size        = prm.get_positive("Mesh size");
    output_interval  = prm.get_positive("Output interval", true);
    if (output_interval > 0. && output_interval < 1e-9 * latest)
      prm.throw_wrong_value("Output interval", "0 or at least 1e-9 of 'Start time' and 'End time'");
    prm.enter_subsection("Checkpoint");
    steps_between_checkpoints = prm.get_count("Steps between", 0, 1000000000);
    time_between_checkpoints  = 60. * prm.get_positive("Minutes between", true);
    prm.leave_subsection();
  }
} // namespace Lahar
