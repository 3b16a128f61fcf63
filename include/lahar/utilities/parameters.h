// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_parameters_h
#define lahar_utilities_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <lahar/utilities/assignment.h>
#include <lahar/utilities/exceptions.h>

#include <map>
#include <optional>
#include <set>
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
    void enter_subsection(const std::string &name);
    void leave_subsection();

    /// A finite number; with limits one in [@p lower, @p upper].
    void declare_number(const std::string &entry, const std::string &default_value,
                        const std::string &documentation,
                        const double lower = Patterns::Double::min_double_value,
                        const double upper = Patterns::Double::max_double_value);

    /// A finite number that is not negative; what is read may refuse zero, see get_positive().
    void declare_positive(const std::string &entry, const std::string &default_value,
                          const std::string &documentation)
    {
      declare_number(entry, default_value, documentation, 0.);
    }

    /// A whole number in [@p lower, @p upper].
    void declare_count(const std::string &entry, const std::string &default_value,
                       const std::string &documentation, const unsigned int lower, const unsigned int upper);

    /// One of the @p choices, which are separated by '|'.
    void declare_choice(const std::string &entry, const std::string &default_value,
                        const std::string &choices, const std::string &documentation);

    /// 'true' or 'false'.
    void declare_bool(const std::string &entry, const bool default_value, const std::string &documentation);

    /// @p n numbers separated by ','.
    void declare_vector(const std::string &entry, const std::string &default_value, const unsigned int n,
                        const std::string &documentation);

    /// Any number of texts separated by @p separator.
    void declare_list(const std::string &entry, const std::string &default_value, const char separator,
                      const std::string &documentation);

    /// A text.
    void declare_text(const std::string &entry, const std::string &default_value,
                      const std::string &documentation);

    /// An entry whose value is the name of a file that is read, or empty.
    void declare_file(const std::string &entry, const std::string &documentation);

    /// An entry whose value is a list of such names, separated by ';'.
    void declare_file_list(const std::string &entry, const std::string &documentation);

    /// An entry whose value is a list of names, separated by ','. A subsection may have the same name.
    void declare_names(const std::string &entry, const std::string &documentation);

    /// The value of such an entry becomes @p names.
    void set_names(const std::string &entry, const std::vector<std::string> &names);

    /**
     * Set entries as the user says. Names of files become absolute ones.
     * @param of_other_dimension entries of the other space dimension, for messages.
     * @throws InputError with the place for a subsection or an entry that was not declared, with all of those that stand
     * elsewhere now.
     */
    void assign(const std::vector<Assignment> &assignments, const Parameters &of_other_dimension);

    /// Whether the value of the entry with this full path is the name of a file.
    bool is_file(const std::string &path) const
    {
      return files.count(path) > 0;
    }

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

    /// A finite number, none where the value is the @p word; InputError otherwise.
    std::optional<double> get_number_or(const std::string &entry, const std::string &word) const;

    /// The same of a number above zero.
    std::optional<double> get_positive_or(const std::string &entry, const std::string &word) const;

    /// A finite number in [@p lower, @p upper]; InputError otherwise.
    double get_in_range(const std::string &entry, const double lower, const double upper) const;

    /// The @p dim components of a vector "x, y[, z]"; InputError if their number differs.
    template <int dim>
    Tensor<1, dim> get_vector(const std::string &entry) const;

    /// Names separated by commas; one with a comma stands in double quotes. InputError for anything beside a quoted
    /// name.
    std::vector<std::string> get_names(const std::string &entry) const;

    /// The values of all entries by their full paths.
    std::map<std::string, std::string> values() const;

  private:
    bool knows(const Assignment &assignment, const std::map<std::string, std::string> &known) const;
    [[noreturn]] void throw_unknown(const Assignment &assignment, const Parameters &of_other_dimension) const;

    /// @throws InputError if entries or subsections stand elsewhere now, see new_spelling().
    void check_renamed(const std::vector<Assignment> &assignments,
                       const std::map<std::string, std::string> &known) const;

    std::vector<std::string> sections;
    std::set<std::string> files, file_lists, name_lists; ///< full paths of entries
  };

  /// Split @p text at @p separator; pieces lose their surrounding white space, an empty text has no pieces.
  std::vector<std::string> split_list(const std::string &text, const char separator);

  /// @p text as a finite number; throws std::invalid_argument where it is none or something follows it.
  double to_number(const std::string &text);
} // namespace Lahar

#endif
