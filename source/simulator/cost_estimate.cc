// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/cost_estimate.h>

#include <cmath>
#include <sstream>

namespace Lahar
{
  std::string estimate_cost(const unsigned int dim, const double n_cells, const Parameters &prm)
  {
    const bool is_direct = prm.get({"Linear solver"}, "Type") == "direct";
    const double steps   = std::ceil(
        (prm.get_number("End time") - prm.get_number("Start time")) / prm.get_positive("Time step") - 1e-6);
    const double seconds = 4.5 * steps * n_cells * 1e-6 * (dim == 3 ? 8. : is_direct ? 7. : 6.);
    const double memory  = 180. + n_cells / 1024. * (dim == 3 ? 3. : is_direct ? 12. : 6.);
    std::ostringstream text;
    text.precision(2);
    text << "Time steps       " << static_cast<unsigned long>(steps) << "\nEstimate         " << seconds
         << " s" << (seconds > 7200. ? " (" : "");
    if (seconds > 7200.)
      text << seconds / 3600. << " h)";
    text.precision(3);
    text << " and " << memory << " MiB on one rank, at the number of cells of the start";
    return text.str();
  }
} // namespace Lahar
