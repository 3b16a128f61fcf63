// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <lahar/simulator/run_parameters.h>
#include <lahar/simulator/simulator.h>
#include <lahar/utilities/assignment.h>
#include <lahar/utilities/case_structure.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/plugins.h>
#include <lahar/utilities/process_start.h>
#include <lahar/utilities/ranks.h>
#include <lahar/utilities/standard_output.h>
#include <lahar/version.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <csignal>
#include <memory>
#include <sstream>

namespace
{
  using namespace Lahar;

  struct CommandLine
  {
    std::string file_name;
    std::vector<std::string> overrides;
    std::string print_format, start_directory;
    bool check = false, resume = false, overwrite = false;
  };

  constexpr const char *usage =
    "Usage: lahar [options] case.prm\n       mpirun -np N lahar [options] case.prm\n\nFree-surface Bingham flows by the Particle Finite Element Method.\n";

  /// Print what was asked for, once.
  void show(const std::string &text)
  {
    on_first_rank(MPI_COMM_WORLD, [&] { write_standard_output(text); });
  }



  /// Read the command line. @return whether there is a case to compute.
  bool parse(const int argc, char **argv, CommandLine &line)
  {
    namespace po = boost::program_options;
    po::options_description visible("Options"), all;
    visible.add_options()("set", po::value(&line.overrides)->composing(),
                          "override one entry: --set \"Section/Subsection/Entry=value\" (repeatable)")(
      "check", po::bool_switch(&line.check), "read, validate, build the initial mesh, report sizes, stop")(
      "write-start", po::value(&line.start_directory),
      "like --check, and write initial mesh, walls and all entries into this directory")(
      "resume", po::bool_switch(&line.resume), "go on from the checkpoint in the output directory")(
      "overwrite", po::bool_switch(&line.overwrite),
      "remove the files of an earlier run from the output directory and begin anew")(
      "print-parameters", po::value(&line.print_format),
      "print every entry with default and documentation: prm, json or latex")("help", "print this text")(
      "version", "print the version");
    all.add(visible).add_options()("case", po::value<std::vector<std::string>>());
    po::positional_options_description positional;
    positional.add("case", -1);

    po::variables_map values;
    try
    {
      po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), values);
      po::notify(values);
    }
    catch (const po::error &error)
    {
      throw InputError(std::string("Command line: ") + error.what() + ". See lahar --help.");
    }

    std::ostringstream text;
    if (values.count("help"))
      text << usage << "\n"
           << visible << "\nExit status: 0 success, 1 the run failed, 2 the input is wrong.\n";
    if (values.count("version"))
      text << "lahar " << LAHAR_VERSION << " (deal.II " << DEAL_II_PACKAGE_VERSION << ")\n";
    if (values.count("help") || values.count("version"))
    {
      show(text.str());
      return false;
    }
    if (values.count("print-parameters"))
    {
      if (line.print_format != "prm" && line.print_format != "json" && line.print_format != "latex")
        throw InputError("Option --print-parameters is '" + line.print_format +
                         "'. Allowed: prm, json, latex.");
      return true;
    }
    const auto files = values.count("case") ? values["case"].as<std::vector<std::string>>()
                                            : std::vector<std::string>();
    if (files.size() != 1)
      throw InputError("Command line: " + std::to_string(files.size()) +
                       " parameter files, one is needed. See lahar --help.");
    line.file_name = files[0];
    if (values.count("write-start"))
    {
      if (line.resume || line.overwrite)
        throw InputError("Command line: --write-start with --resume or --overwrite. Allowed: one of them.");
      line.check = true;
      line.overrides.push_back("Output directory=" + line.start_directory);
    }
    if (line.resume && line.overwrite)
      throw InputError("Command line: --resume and --overwrite. Allowed: one of them.");
    return true;
  }



  void print_parameters(const Parameters &prm, const std::string &format, std::ostream &out)
  {
    prm.print_parameters(out, format == "json"    ? ParameterHandler::JSON
                              : format == "latex" ? ParameterHandler::LaTeX
                                                  : ParameterHandler::PRM);
  }



  /// What the case, which the first rank reads once, and then the command line assign.
  std::vector<Assignment> read(const CommandLine &line)
  {
    std::vector<Assignment> assignments;
    if (!line.file_name.empty())
    {
      on_first_rank(MPI_COMM_WORLD, [&] { assignments = read_parameter_file(line.file_name); });
      assignments = Utilities::MPI::broadcast(MPI_COMM_WORLD, assignments, 0);
    }
    for (const std::string &text : line.overrides)
      assignments.push_back(parse_override(text));
    return assignments;
  }



  template <int dim>
  int run(const CommandLine &line, const CaseStructure &structure, const std::vector<Assignment> &assignments)
  {
    Parameters prm, of_other_dimension;
    Simulator<dim>::declare_parameters(prm, structure);
    Simulator<5 - dim>::declare_parameters(of_other_dimension, structure);
    of_other_dimension.set("Dimension", std::to_string(5 - dim));
    if (!line.print_format.empty())
    {
      prm.set_names("Fluids", structure.fluids);
      prm.set_names("Boundaries", structure.boundaries);
      prm.set_names("Solids", structure.solids);
      std::ostringstream text;
      print_parameters(prm, line.print_format, text);
      show(text.str());
      return 0;
    }
    prm.assign(assignments, of_other_dimension);

    // It outlives what is thrown, because its destructor waits for the other ranks.
    std::unique_ptr<Simulator<dim>> simulator;
    return exit_status(MPI_COMM_WORLD, [&] {
      simulator = std::make_unique<Simulator<dim>>(prm, structure, MPI_COMM_WORLD);
      if (!line.check)
        simulator->take_output_directory(line.resume      ? OutputDirectory::Use::resume
                                         : line.overwrite ? OutputDirectory::Use::overwrite
                                                          : OutputDirectory::Use::begin);
      simulator->initialize();
      if (line.resume)
        simulator->resume();
      if (!line.start_directory.empty())
        simulator->write_start();
      if (line.check)
      {
        show(simulator->sizes() + '\n');
        return;
      }
      simulator->run();
    });
  }



  int lahar_main(const int argc, char **argv)
  {
    CommandLine line;
    if (!parse(argc, argv, line))
      return 0;
    const std::vector<Assignment> assignments = read(line);
    CaseStructure structure(assignments);
    load_plugins(structure.plugins);
    if (line.file_name.empty()) // to show which entries there are
      structure.complete();
    return structure.dimension == 2 ? run<2>(line, structure, assignments)
                                    : run<3>(line, structure, assignments);
  }



#ifndef LAHAR_SANITIZE // AddressSanitizer wants to be the first
  // The loader calls what stands in this section before anything else.
  [[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)(int, char **,
                                                                               char **) = prepare_process;
#endif
} // namespace



int main(int argc, char **argv)
{
  struct sigaction hangup; // ignored under nohup
  sigaction(SIGHUP, nullptr, &hangup);
  reserve_blas_buffers();
  reserve_memory_for_failure();
  // The program's name and no options: deal.II hands them on to PETSc and Kokkos, which have a say on those of Lahar.
  int n_words   = 1;
  char *words[] = {argv[0], nullptr}, **name = words;
  Utilities::MPI::MPI_InitFinalize mpi(n_words, name, 1);
  // PETSc, which deal.II starts, has set them all to their defaults.
  sigaction(SIGHUP, &hangup, nullptr);
  // A pipe to a reader that has gone away and a file at its limit (ulimit -f) fail like files on a full disk.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
#ifndef LAHAR_SANITIZE
  report_crashes();
#endif
  int status         = 0;
  const int failures = exit_status(MPI_COMM_WORLD, [&] { status = lahar_main(argc, argv); });
  return std::max(status, failures);
}
