// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <lahar/simulator/run_parameters.h>
#include <lahar/simulator/simulator.h>
#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/ranks.h>
#include <lahar/version.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>

namespace
{
  using namespace Lahar;

  struct CommandLine
  {
    std::string file_name;
    std::vector<std::string> overrides;
    std::string print_format;
    bool check = false, resume = false;
  };

  constexpr const char *usage =
    "Usage: lahar [options] case.prm\n       mpirun -np N lahar [options] case.prm\n\nFree-surface Bingham flows by the Particle Finite Element Method.\n";

  /// Read the command line. @return whether there is a case to compute.
  bool parse(const int argc, char **argv, CommandLine &line)
  {
    namespace po = boost::program_options;
    po::options_description visible("Options"), all;
    visible.add_options()("set", po::value(&line.overrides)->composing(),
                          "override one entry: --set \"Section/Subsection/Entry=value\" (repeatable)")(
      "check", po::bool_switch(&line.check), "read, validate, build the initial mesh, report sizes, stop")(
      "resume", po::bool_switch(&line.resume), "go on from the checkpoint in the output directory")(
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

    const bool first_rank = is_first_rank(MPI_COMM_WORLD);
    if (values.count("help") && first_rank)
      std::cout << usage << "\n"
                << visible << "\nExit status: 0 success, 1 the run failed, 2 the input is wrong.\n";
    if (values.count("version") && first_rank)
      std::cout << "lahar " << LAHAR_VERSION << " (deal.II " << DEAL_II_PACKAGE_VERSION << ")\n";
    if (values.count("help") || values.count("version"))
      return false;
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
    return true;
  }



  /// Set the entry "Section/Subsection/Entry" to a value, which may be on several lines.
  void override_entry(Parameters &prm, std::string text)
  {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw InputError("Option --set is '" + text + "'. Allowed: \"Section/Subsection/Entry=value\".");
    const std::string path            = Utilities::trim(text.substr(0, equals)),
                      value           = Utilities::trim(text.substr(equals + 1));
    std::vector<std::string> sections = split_list(path, '/');
    if (sections.empty())
      throw InputError("Option --set is '" + text + "'. Allowed: \"Section/Subsection/Entry=value\".");
    const std::string entry = sections.back();
    sections.pop_back();

    std::ostringstream input;
    for (const std::string &section : sections)
      input << "subsection " << section << "\n";
    input << "set " << entry << " = " << value << "\n";
    for (unsigned int i = 0; i < sections.size(); ++i)
      input << "end\n";
    try
    {
      prm.parse_input_from_string(input.str());
    }
    catch (const ParameterHandler::ExcEntryUndeclared &)
    {
      throw InputError("Option --set: there is no entry '" + path + "'. See lahar --print-parameters prm.");
    }
    catch (const ParameterHandler::ExcNoSubsection &)
    {
      throw InputError("Option --set: there is no entry '" + path + "'. See lahar --print-parameters prm.");
    }
    catch (const ExceptionBase &)
    {
      throw InputError("Option --set: '" + value + "' is no value for the entry '" + path +
                       "'. See lahar --print-parameters prm.");
    }
  }



  void print_parameters(const Parameters &prm, const std::string &format, std::ostream &out)
  {
    prm.print_parameters(out, format == "json"    ? ParameterHandler::JSON
                              : format == "latex" ? ParameterHandler::LaTeX
                                                  : ParameterHandler::PRM);
  }



  /// The text of deal.II's exception without its frame, which may quote a long line.
  std::string short_message(const ExceptionBase &error)
  {
    std::ostringstream text;
    error.print_info(text);
    const std::string message = Utilities::trim(text.str());
    return message.size() > 1000 ? message.substr(0, 1000) + " ..." : message;
  }



  void read(const std::string &file_name, Parameters &prm)
  {
    std::ifstream file(file_name);
    if (!file || std::filesystem::is_directory(file_name))
      throw InputError("Cannot read the parameter file '" + file_name + "'.");
    try
    {
      prm.parse_input(file, file_name);
    }
    catch (const ExceptionBase &error)
    {
      throw InputError("Parameter file: " + short_message(error));
    }
  }



  /// Create the output directory and leave the complete parameters in it.
  void prepare_output(const Parameters &prm, const std::string &directory)
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    try
    {
      if (error)
        throw RunError(error.message());
      write_atomically(directory + "/parameters.prm",
                       [&](std::ostream &file) { print_parameters(prm, "prm", file); });
    }
    catch (const RunError &reason)
    {
      throw InputError("Parameter 'Output directory' is '" + directory +
                       "'. Allowed: a directory that can be created and written to (" + reason.what() + ").");
    }
  }



  /// The case's entry 'Dimension' before the parameters, which depend on it, are declared; a wrong value shows later.
  unsigned int find_dimension(const CommandLine &line)
  {
    Parameters prm;
    RunParameters::declare_parameters(prm);
    std::ifstream file(line.file_name);
    try
    {
      if (file)
        prm.parse_input(file, line.file_name, "", true);
      for (const std::string &text : line.overrides)
        if (text.find("Dimension") != std::string::npos)
          override_entry(prm, text);
    }
    catch (const std::exception &)
    {}
    return prm.get("Dimension") == "3" ? 3 : 2;
  }



  /// How many solids the case counts or describes; what is wrong with the input shows later.
  unsigned int count_solids(const CommandLine &line)
  {
    Parameters prm;
    Solids<2>::declare_parameters(prm, 0);
    std::ifstream file(line.file_name);
    try
    {
      if (file)
        prm.parse_input(file, line.file_name, "", true);
      for (const std::string &text : line.overrides)
        if (text.find("Number of solids") != std::string::npos)
          override_entry(prm, text);
      prm.enter_subsection("Solids");
      unsigned int n_solids = prm.get_count("Number of solids", 0, Solids<2>::maximum);
      std::ifstream text(line.file_name);
      for (std::string word, number; text >> word;)
        if (word == "subsection" && text >> word && word == "Solid" && text >> number &&
            number.find_first_not_of("0123456789") == std::string::npos && number.size() < 4)
          n_solids = std::max<unsigned int>(n_solids,
                                            std::min<unsigned int>(std::stoi(number), Solids<2>::maximum));
      return n_solids;
    }
    catch (const std::exception &)
    {
      return 0;
    }
  }



  template <int dim>
  void run(const CommandLine &line)
  {
    // Without a case there is one solid for show.
    Parameters prm;
    Simulator<dim>::declare_parameters(prm, std::max(count_solids(line), line.file_name.empty() ? 1U : 0U));
    if (!line.print_format.empty())
    {
      if (is_first_rank(MPI_COMM_WORLD))
        print_parameters(prm, line.print_format, std::cout);
      return;
    }
    read(line.file_name, prm);
    for (const std::string &text : line.overrides)
      override_entry(prm, text);

    Simulator<dim> simulator(prm, MPI_COMM_WORLD);
    simulator.initialize();
    if (line.resume)
      simulator.resume();
    if (line.check)
    {
      const std::string sizes = simulator.sizes();
      if (is_first_rank(MPI_COMM_WORLD))
        std::cout << sizes << std::endl;
      return;
    }
    on_first_rank(MPI_COMM_WORLD, [&] { prepare_output(prm, prm.get("Output directory")); });
    simulator.run();
  }



  int lahar_main(const int argc, char **argv)
  {
    CommandLine line;
    if (!parse(argc, argv, line))
      return 0;
    if (find_dimension(line) == 2)
      run<2>(line);
    else
      run<3>(line);
    return 0;
  }
} // namespace



int main(int argc, char **argv)
{
  // The program's name and no options: deal.II hands them on to PETSc and Kokkos, which have a say on those of Lahar.
  int n_words   = 1;
  char *words[] = {argv[0], nullptr}, **name = words;
  Utilities::MPI::MPI_InitFinalize mpi(n_words, name, 1);
  try
  {
    return lahar_main(argc, argv);
  }
  catch (const Lahar::InputError &error)
  {
    Lahar::fail_on_all_ranks(MPI_COMM_WORLD, std::string("lahar: wrong input. ") + error.what(), 2);
    return 2;
  }
  catch (const std::bad_alloc &)
  {
    Lahar::fail_on_all_ranks(
      MPI_COMM_WORLD,
      "lahar: the run failed. There is not enough memory: 'Mesh size' and the elements "
      "of solids are what it depends on.",
      1);
    return 1;
  }
  catch (const std::exception &error) // RunError, too
  {
    Lahar::fail_on_all_ranks(MPI_COMM_WORLD, std::string("lahar: the run failed. ") + error.what(), 1);
    return 1;
  }
}
