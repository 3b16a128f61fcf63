// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/grid_lines.h>
#include <lahar/geometry/profile.h>
#include <lahar/utilities/number_table.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Lahar
{
  std::array<double, 2> parse_range(const Parameters &prm, const std::string &entry)
  {
    std::vector<double> numbers;
    try
    {
      for (const std::string &word : split_list(prm.get(entry), ','))
        numbers.push_back(to_number(word));
    }
    catch (const std::invalid_argument &)
    {
      numbers.clear();
    }
    if (numbers.size() != 2 || !(numbers[0] < numbers[1]))
      prm.throw_wrong_value(entry, "'x0, x1' with x0 < x1");
    return {{numbers[0], numbers[1]}};
  }



  double value_at(const std::vector<Point<2>> &table, const double x)
  {
    const auto next   = std::upper_bound(table.begin() + 1, table.end() - 1, x,
                                         [](const double value, const Point<2> &p) { return value < p[0]; });
    const Point<2> &a = *(next - 1), &b = *next;
    return a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
  }



  void Profile::declare_parameters(Parameters &prm)
  {
    prm.declare_file("File", "A table (CSV) of points 'x, y' of the ground in m, by ascending x.");
    prm.declare_list(
      "Window", "", ',',
      "The part of it that is the ground, 'x0, x1' in the table's coordinates; if empty, all.");
    prm.declare_vector("Origin", "0, 0", 2,
                       "Point 'x, y' of the table that is the origin of the case: it is subtracted.");
    prm.declare_positive(
      "Spacing", "0",
      "Distance in x of the ground's points in m, heights between the table's rows being linear. "
      "0: the rows.");
  }



  Profile::Profile(const Parameters &prm)
    : shift(prm.get_vector<2>("Origin"))
    , spacing_path(prm.path("Spacing"))
  {
    if (prm.get("File").empty())
      prm.throw_wrong_value("File", "the name of a table of points 'x, y' (.csv)");
    const NumberTable table(prm.get("File"), {"x in m", "y in m"});
    std::vector<Point<2>> rows;
    std::vector<double> of_file;
    for (const NumberTable::Row &row : table.rows())
    {
      if (!rows.empty() && !(row[0] > rows.back()[0]))
        table.throw_wrong_row(rows.size(), "a larger x than in the line before");
      rows.emplace_back(row[0], row[1]);
      of_file.push_back(row[0]);
    }
    if (rows.size() < 2)
      table.throw_wrong_table("has " + std::to_string(rows.size()) + " points", "at least two");
    range = {{of_file.front(), of_file.back()}};
    if (!prm.get("Window").empty())
    {
      const std::array<double, 2> wanted = parse_range(prm, "Window");
      if (!(wanted[0] >= range[0] && wanted[1] <= range[1]))
      {
        std::ostringstream allowed;
        allowed.precision(12);
        allowed << "a window within the table, which reaches from " << range[0] << " to " << range[1] << " m";
        prm.throw_wrong_value("Window", allowed.str());
      }
      range = wanted;
    }
    for (const double x : grid_lines(range[0], range[1], prm.get_positive("Spacing", true), of_file))
      line.push_back(Point<2>(x, value_at(rows, x)) - shift);
    if (line.size() > most_grid_lines)
      prm.throw_wrong_value("Spacing", "a larger one, or a smaller 'Window'");
  }



  std::vector<std::string> Profile::check_scale(const std::string &name, const double h) const
  {
    return check_grid_spacing(name, (range[1] - range[0]) / (line.size() - 1.), h, spacing_path);
  }
} // namespace Lahar
