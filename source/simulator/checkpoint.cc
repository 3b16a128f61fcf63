#include <lahar/simulator/simulator.h>
#include <lahar/utilities/ranks.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Entries, and subsections of such, that may change when a run is resumed.
    const std::vector<std::string> changeable = {"Output directory",  "End time",
                                                 "Time step",         "Minimum time step",
                                                 "Maximum time step", "Largest movement",
                                                 "Output interval",   "Checkpoint/",
                                                 "Nonlinear solver/", "Linear solver/"};
  } // namespace



  template <int dim>
  template <typename Archive>
  void Simulator<dim>::save_or_load(Archive &archive)
  {
    archive &particles;
    SolidState<dim> solid_state = solids.state();
    archive &solid_state;
    if constexpr (Archive::is_loading::value)
    {
      if (solid_state.stress.size() != solids.state().stress.size())
        checkpoint.fail("has solids of another mesh", "the mesh files of the run");
      solids.accept(solid_state);
      fluid_mesh.load(archive, particles);
    }
    else
      fluid_mesh.save(archive);
    archive &time &step_number &n_rejected &n_forced_facets &n_kept_out &n_left;
    archive &initial_volume &volume &change_by_solver &change_by_remeshing &left_volume;
    archive &*step_control &*visualization;
    archive &last_output_time &statistics_size &convergence_size &earlier_wall_time;
  }



  template <int dim>
  bool Simulator<dim>::checkpoint_is_due() const
  {
    const bool by_steps = parameters.steps_between_checkpoints > 0 &&
                          step_number % parameters.steps_between_checkpoints == 0;
    const bool by_time = parameters.time_between_checkpoints > 0. &&
                         progress->wall_time() - last_checkpoint_wall_time >
                           parameters.time_between_checkpoints;
    return Utilities::MPI::broadcast(communicator, by_steps || by_time);
  }



  template <int dim>
  void Simulator<dim>::write_checkpoint()
  {
    last_checkpoint_wall_time = earlier_wall_time = progress->wall_time();
    on_first_rank(communicator, [this] {
      statistics_size  = statistics.size();
      convergence_size = convergence.size();
      std::ostringstream data;
      {
        boost::archive::binary_oarchive archive(data);
        const std::map<std::string, std::string> values = prm.values();
        archive << values;
        save_or_load(archive);
      }
      checkpoint.write(data.str());
    });
  }



  template <int dim>
  void Simulator<dim>::resume()
  {
    std::istringstream data(checkpoint.read());
    visualization = std::make_unique<Visualization<dim>>(parameters.output_directory, communicator);
    try
    {
      boost::archive::binary_iarchive archive(data);
      std::map<std::string, std::string> earlier_values;
      archive >> earlier_values;
      check_unchanged(earlier_values);
      save_or_load(archive);
    }
    catch (const boost::archive::archive_exception &error)
    {
      checkpoint.fail(std::string("cannot be read (") + error.what() + ")",
                      "one written by the same program on the same kind of machine");
    }
    statistics.check(statistics_size);
    convergence.check(convergence_size);
    resumed = true;
    if (parameters.end_time < time - 1e-10 * parameters.time_step)
      prm.throw_wrong_value("End time",
                            "a time not before that of the checkpoint, which is " + std::to_string(time));
  }



  template <int dim>
  void Simulator<dim>::check_unchanged(const std::map<std::string, std::string> &earlier_values) const
  {
    const std::map<std::string, std::string> values = prm.values();
    const auto may_change                           = [](const std::string &path) {
      for (const std::string &entry : changeable)
        if (path == entry || (entry.back() == '/' && path.rfind(entry, 0) == 0))
          return true;
      return false;
    };
    for (const auto &[path, value] : values)
    {
      const auto earlier = earlier_values.find(path);
      if (!may_change(path) && (earlier == earlier_values.end() || earlier->second != value))
        throw InputError("Parameter '" + path + "' is '" + value + "'. Allowed when a run is resumed: " +
                         (earlier == earlier_values.end()
                            ? "not to be there, as in the checkpoint"
                            : "'" + earlier->second + "' as in the checkpoint") +
                         ".");
    }
    for (const auto &[path, value] : earlier_values)
      if (values.count(path) == 0)
        throw InputError("Parameter '" + path + "' is not there. Allowed when a run is resumed: '" + value +
                         "' as in the checkpoint.");
  }



  template void Simulator<2>::resume();
  template void Simulator<3>::resume();
  template bool Simulator<2>::checkpoint_is_due() const;
  template bool Simulator<3>::checkpoint_is_due() const;
  template void Simulator<2>::write_checkpoint();
  template void Simulator<3>::write_checkpoint();
} // namespace Lahar
