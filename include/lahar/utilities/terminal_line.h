// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_terminal_line_h
#define lahar_utilities_terminal_line_h

#include <chrono>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The last line on the screen, which rewrites itself while messages pass above it. It is there where the standard
   * output is a terminal of known width that can erase (TERM is not "dumb"): mpirun gives its ranks one without a width
   * where its own output goes elsewhere. It is shorter than the terminal is wide, and silent while the process runs in
   * the background.
   */
  class TerminalLine
  {
  public:
    /// A piece of the line; where the terminal is too narrow, those of the lowest rank are left out.
    struct Piece
    {
      std::string text;
      unsigned int rank = 0;
    };

    TerminalLine();

    /// Like finish().
    ~TerminalLine();

    TerminalLine(const TerminalLine &)            = delete;
    TerminalLine &operator=(const TerminalLine &) = delete;

    /// Whether it can be shown.
    bool exists() const;

    /// Show the pieces, two blanks between them, at most ten times a second; those of the last call stay in any case.
    void show(std::vector<Piece> pieces);

    /// Lines above it.
    void message(const std::string &text);

    /// What is on the screen stays, and what comes then stands below it.
    void finish() noexcept;

  private:
    /// Write the line over itself.
    void draw();

    /// Its text at a width.
    std::string text(const unsigned int width) const;

    bool is_there, is_drawn = false;
    std::vector<Piece> pieces; ///< empty: no line
    std::chrono::steady_clock::time_point last_drawn;
  };
} // namespace Lahar

#endif
