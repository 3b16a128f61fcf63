// SPDX-License-Identifier: GPL-3.0-or-later

// Test entries that are a number or a word: what is read, and that anything else is refused with the entry's full path, its
// value and what is allowed.

#include <lahar/utilities/parameters.h>

#include "tests.h"

using namespace Tests;

int main()
{
  Parameters prm;
  prm.enter_subsection("Layer");
  prm.declare_text("Level", "none", "A height.");
  prm.declare_text("Time", "infinite", "A time.");
  const auto level = [&](const std::string &value) {
    prm.set("Level", value);
    return prm.get_number_or("Level", "none");
  };
  const auto time = [&](const std::string &value) {
    prm.set("Time", value);
    return prm.get_positive_or("Time", "infinite");
  };
  check("the words are no numbers", !level("none") && !time("infinite"));
  check("numbers of any sign", level("-2.5").value() + 2.5, 0.);
  check("zero", level("0").value(), 0.);
  check("numbers above zero", time("4e-3").value() - 4e-3, 0.);
  for (const char *value : {"", "non", "None", "1 m", "1, 2", "nan", "inf", "1e999", "infinite"})
    check_throws<InputError>(std::string("level '") + value + "' is refused",
                             {"'Layer/Level'", std::string("'") + value + "'",
                              "Allowed: a finite number or 'none'."},
                             [&] { level(value); });
  for (const char *value : {"0", "-1", "soon", "inf", "none", ""})
    check_throws<InputError>(std::string("time '") + value + "' is refused",
                             {"'Layer/Time'", std::string("'") + value + "'",
                              "Allowed: a finite number above zero or 'infinite'."},
                             [&] { time(value); });
  return n_failed > 0;
}
