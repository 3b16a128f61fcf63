// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/terminal_line.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace Lahar
{
  namespace
  {
    constexpr std::chrono::milliseconds redraw_pause(100);
    constexpr char erase[] = "\r\033[K";

    /// Columns of the terminal that the standard output is; 0 if it is none, or of unknown width.
    unsigned int terminal_width()
    {
      winsize size{};
      return isatty(STDOUT_FILENO) != 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
    }

    bool can_erase()
    {
      const char *terminal = std::getenv("TERM");
      return terminal != nullptr && std::strcmp(terminal, "") != 0 && std::strcmp(terminal, "dumb") != 0;
    }

    /// Whether another group of processes has the terminal.
    bool is_in_background()
    {
      const pid_t group = tcgetpgrp(STDOUT_FILENO);
      return group >= 0 && group != getpgrp();
    }
  } // namespace



  TerminalLine::TerminalLine()
    : is_there(terminal_width() > 0 && can_erase())
  {}



  TerminalLine::~TerminalLine()
  {
    finish();
  }



  bool TerminalLine::exists() const
  {
    return is_there;
  }



  std::string TerminalLine::text(const unsigned int width) const
  {
    std::vector<Piece> shown = pieces;
    const auto joined        = [&] {
      std::string line;
      for (const Piece &piece : shown)
        line += (line.empty() ? "" : "  ") + piece.text;
      return line;
    };
    const auto lower = [](const Piece &a, const Piece &b) { return a.rank < b.rank; };
    while (shown.size() > 1 && joined().size() >= width)
      shown.erase(std::min_element(shown.begin(), shown.end(), lower));
    return joined().substr(0,
                           std::max(width, 1U) - 1); // in the last column the cursor may be in the next line
  }



  void TerminalLine::draw()
  {
    const unsigned int width = terminal_width();
    if (pieces.empty() || width == 0 || is_in_background())
      return;
    std::cout << erase << text(width) << std::flush;
    is_drawn = true;
  }



  void TerminalLine::show(std::vector<Piece> new_pieces)
  {
    pieces         = std::move(new_pieces);
    const auto now = std::chrono::steady_clock::now();
    if (!is_there || now - last_drawn < redraw_pause)
      return;
    last_drawn = now;
    draw();
  }



  void TerminalLine::message(const std::string &text)
  {
    if (is_drawn)
      std::cout << erase;
    is_drawn = false;
    std::cout << text << std::endl;
    if (is_there)
      draw();
  }



  void TerminalLine::finish() noexcept
  {
    try
    {
      if (is_there)
        draw();
      if (is_drawn)
        std::cout << std::endl;
    }
    catch (...)
    {
      // The screen is not worth a failure.
    }
    is_drawn = false;
    pieces.clear();
  }
} // namespace Lahar
