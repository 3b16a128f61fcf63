// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_statistics_line_h
#define lahar_postprocess_statistics_line_h

#include <deal.II/base/table_handler.h>

#include <string>

namespace Lahar
{
  using namespace dealii;

  /// A line of the statistics that is being made.
  class StatisticsTable : public TableHandler
  {
  public:
    /// The name of a column that has more than one value; empty where none has.
    std::string doubled_column() const
    {
      for (const auto &[name, column] : columns)
        if (column.entries.size() > 1)
          return name;
      return "";
    }
  };

  /**
   * The only line of @p table as text, its columns right-aligned: numbers with a point, nan and inf 16 characters wide,
   * whole numbers 7, or more where they need more.
   */
  std::string statistics_line(const TableHandler &table);

  /// The lines before the first one of a statistics file: "# n: name" for each column of @p table.
  std::string statistics_header(const TableHandler &table);
} // namespace Lahar

#endif
