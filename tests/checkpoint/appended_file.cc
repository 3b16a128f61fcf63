// SPDX-License-Identifier: GPL-3.0-or-later

// Test the file that grows line by line: what it holds, what is cut off when a run is resumed, what is refused, what comes
// back when others remove it, and the message of a disk that is full. Test the line and the header of the statistics that
// are written to it.

#include <lahar/postprocess/statistics_line.h>
#include <lahar/utilities/appended_file.h>
#include <lahar/utilities/exceptions.h>

#include "tests.h"

#include <filesystem>
#include <iterator>
#include <limits>

using namespace Tests;

std::string contents(const std::string &name)
{
  std::ifstream file(name);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

int main()
{
  const std::string name = "appended_file.text";
  {
    AppendedFile file(name);
    check("nothing is written before it begins", file.size() == 0);
    file.begin();
    file.append("one\n");
    check("a line is in the file at once", contents(name) == "one\n" && file.size() == 4);
    file.append("two\nthree\n");
    check("more follow", contents(name) == "one\ntwo\nthree\n" && file.size() == 14);
  }
  AppendedFile file(name);
  file.check(8);
  check("a file may be longer than it was", contents(name) == "one\ntwo\nthree\n");
  check("the rest is cut off", file.resume(8) && contents(name) == "one\ntwo\n" && file.size() == 8);
  file.append("four\n");
  check("and the file goes on", contents(name) == "one\ntwo\nfour\n" && file.size() == 13);
  check_throws<InputError>("a shorter one is refused", {"--resume", name, "13 bytes", "14 when", "Allowed"},
                           [&]() { file.check(14); });
  check("all is as it was written", !file.mend());
  std::filesystem::remove(name);
  check("a removed one is there again", file.mend() && contents(name) == "one\ntwo\nfour\n" && !file.mend());
  file.append("five\n");
  check("and the file goes on", contents(name) == "one\ntwo\nfour\nfive\n" && file.size() == 18);
  std::filesystem::resize_file(name, 5);
  check_throws<RunError>("one that others have cut off", {name, "holds 5 bytes", "wrote 18", "--resume"},
                         [&]() { file.mend(); });
  check("or that goes on as it is", !file.mend(false) && file.size() == 5);
  file.begin();
  check("a new beginning", contents(name).empty() && file.size() == 0);

  std::filesystem::remove(name);
  AppendedFile missing(name);
  missing.check(8);
  check("without the file it begins anew",
        !missing.resume(8) && missing.size() == 0 && std::filesystem::exists(name));
  std::filesystem::remove(name);

  AppendedFile full("/dev/full");
  full.begin();
  check_throws<RunError>("a full disk", {"Cannot write '/dev/full'", "No space left"},
                         [&]() { full.append("one\n"); });
  check("nothing is counted as written", full.size() == 0);
  AppendedFile nowhere("no directory/file");
  check_throws<RunError>("no directory", {"Cannot write 'no directory/file'", "No such file"},
                         [&]() { nowhere.begin(); });

  TableHandler table;
  table.add_value("Step", 12U);
  table.add_value("Speed (m/s)", -0.5);
  table.set_precision("Speed (m/s)", 9);
  table.set_scientific("Speed (m/s)", true);
  table.add_value("Gauge (Pa)", std::numeric_limits<double>::quiet_NaN());
  check("a header", statistics_header(table) == "# 1: Step\n# 2: Speed (m/s)\n# 3: Gauge (Pa)\n");
  check("a line", statistics_line(table) == "     12 -5.000000000e-01              nan\n");
  return n_failed;
}
