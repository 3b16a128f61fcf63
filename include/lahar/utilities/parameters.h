// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_parameters_h
#define lahar_utilities_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <lahar/utilities/exceptions.h>

#include <map>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * A ParameterHandler that knows where it is, so that an error can name a parameter by its full path.
   */
  class Parameters : public ParameterHandler
  {
  public:
    /// As in ParameterHandler; files that include files are followed to a depth of 20, then InputError.
    void parse_input(std::istream &input, const std::string &file_name = "input file",
                     const std::string &last_line = "", const bool skip_undefined = false) override;
    using ParameterHandler::parse_input;

    void enter_subsection(const std::string &name);
    void leave_subsection();

    /// Full path of @p entry in the current section, as in "Fluid/Bingham/Density".
    std::string path(const std::string &entry) const;

    /// Throw InputError with the entry's full path, the value found and what is @p allowed.
    [[noreturn]] void throw_wrong_value(const std::string &entry, const std::string &allowed) const;

    /// A finite number; InputError otherwise.
    double get_number(const std::string &entry) const;

    /// A whole number in [@p lower, @p upper]; InputError otherwise.
    unsigned int get_count(const std::string &entry, const unsigned int lower,
                           const unsigned int upper) const;

    /// A finite number above zero (or, with @p allow_zero, not below); InputError otherwise.
    double get_positive(const std::string &entry, const bool allow_zero = false) const;

    /// A finite number in [@p lower, @p upper]; InputError otherwise.
    double get_in_range(const std::string &entry, const double lower, const double upper) const;

    /// The @p dim components of a vector "x, y[, z]"; InputError if their number differs.
    template <int dim>
    Tensor<1, dim> get_vector(const std::string &entry) const;

    /// The values of all entries by their full paths.
    std::map<std::string, std::string> values() const;

  private:
    std::vector<std::string> sections;
    unsigned int depth = 0;     ///< of the included file that is being read
    bool skip_unknown  = false; ///< in included files, too
  };

  /// Split @p text at @p separator; pieces lose their surrounding white space, an empty text has no pieces.
  std::vector<std::string> split_list(const std::string &text, const char separator);

  /// @p text as a finite number; throws std::invalid_argument where it is none or something follows it.
  double to_number(const std::string &text);
} // namespace Lahar

#endif
