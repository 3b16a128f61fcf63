// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/ground_of_boundary.h>
#include <lahar/geometry/mesh_body.h>
#include <lahar/geometry/profile.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/number_table.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Lahar
{
  /// Fluid in the plane on the ground of a boundary of the shape 'terrain': of a depth, of the depths of a table, or up to a
  /// level. Ranges, tables and level are in the coordinates of the profile's table.
  class ProfileRelease : public FluidShape<2>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_text("Boundary", "", "The boundary on which the fluid lies; its 'Shape' is 'terrain'.");
      prm.declare_positive("Depth", "0",
                           "Depth of the fluid in m, measured upwards, between the ends; 0: see below.");
      prm.declare_file("Depth file",
                       "A table (CSV) 'x, depth' in m instead, by ascending x; linear between its rows, zero "
                       "beside them.");
      prm.declare_text("Level", "",
                       "The height in m, as in the profile's table, up to which the fluid reaches instead.");
      prm.declare_list(
        "Ends", "", ',',
        "Ends of the fluid 'x0, x1' in the profile's table. 'Depth' needs them; with 'Level' or 'Depth "
        "file' and no ends there is fluid wherever they give it.");
    }

    void parse_parameters(Parameters &prm) override;

    Bodies bodies(const std::string &name) const override
    {
      Bodies result;
      result.push_back(std::make_unique<MeshBody<2>>(name, nodes, simplices));
      return result;
    }

    void check_scale(const double h) const override;

  private:
    std::vector<Point<2>> nodes;
    std::vector<Simplex<2>> simplices;
    double deepest = 0.; ///< the largest depth
    std::string path;    ///< of the shape's section
  };



  namespace
  {
    Profile profile_of(Parameters &prm)
    {
      const InGroundOfBoundary section(prm);
      return Profile(prm);
    }

    std::vector<Point<2>> read_depths(const std::string &file)
    {
      const NumberTable table(file, {"x in m", "depth in m"});
      std::vector<Point<2>> rows;
      for (const NumberTable::Row &row : table.rows())
      {
        if (!rows.empty() && !(row[0] > rows.back()[0]))
          table.throw_wrong_row(rows.size(), "a larger x than in the line before");
        if (row[1] < 0.)
          table.throw_wrong_row(rows.size(), "a depth of zero or above");
        rows.emplace_back(row[0], row[1]);
      }
      if (rows.size() < 2)
        table.throw_wrong_table("has " + std::to_string(rows.size()) + " rows", "at least two");
      return rows;
    }
  } // namespace



  void ProfileRelease::parse_parameters(Parameters &prm)
  {
    path                    = prm.path("");
    const Profile profile   = profile_of(prm);
    const double depth      = prm.get_positive("Depth", true);
    const std::string level = prm.get("Level"), file = prm.get("Depth file");
    if ((depth > 0.) + !file.empty() + !level.empty() != 1)
      prm.throw_wrong_value("Depth", "one of 'Depth', 'Depth file' and 'Level', and not more");
    std::array<double, 2> ends         = profile.window();
    const std::vector<Point<2>> depths = file.empty() ? std::vector<Point<2>>() : read_depths(file);
    if (!depths.empty())
      ends = {{std::max(ends[0], depths.front()[0]), std::min(ends[1], depths.back()[0])}};
    if (depth > 0. || !prm.get("Ends").empty())
    {
      const std::array<double, 2> wanted = parse_range(prm, "Ends");
      if (!(wanted[0] >= ends[0] && wanted[1] <= ends[1]))
        prm.throw_wrong_value("Ends",
                              "a range within the terrain and the table of depths, which reach from " +
                                std::to_string(ends[0]) + " to " + std::to_string(ends[1]) + " m");
      ends = wanted;
    }
    double surface = 0.;
    if (!level.empty())
      try
      {
        surface = to_number(level) - profile.origin()[1];
      }
      catch (const std::invalid_argument &)
      {
        prm.throw_wrong_value("Level", "a height in m");
      }

    // All corners of the ground and of the surface.
    const double shift        = profile.origin()[0];
    std::vector<double> lines = {ends[0] - shift, ends[1] - shift};
    for (const Point<2> &p : profile.points())
      lines.push_back(p[0]);
    for (const Point<2> &p : depths)
      lines.push_back(p[0] - shift);
    if (!level.empty())
      for (unsigned int i = 1; i < profile.points().size(); ++i)
      {
        const Point<2> &a = profile.points()[i - 1], &b = profile.points()[i];
        if ((a[1] - surface) * (b[1] - surface) < 0.)
          lines.push_back(a[0] + (surface - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
      }
    std::sort(lines.begin(), lines.end());
    const double tolerance = 1e-9 * (ends[1] - ends[0]);
    std::vector<unsigned int> ground, top; // nodes of the columns so far
    double last = 0.;
    for (const double x : lines)
    {
      if (x < ends[0] - shift || x > ends[1] - shift || (!ground.empty() && x < last + tolerance))
        continue;
      last           = x;
      const double y = value_at(profile.points(), x);
      double above   = !level.empty() ? surface - y : depths.empty() ? depth : value_at(depths, x + shift);
      above          = above > tolerance ? above : 0.;
      deepest        = std::max(deepest, above);
      ground.push_back(nodes.size());
      nodes.emplace_back(x, y);
      top.push_back(above > 0. ? nodes.size() : ground.back());
      if (above > 0.)
        nodes.emplace_back(x, y + above);
      if (const unsigned int i = ground.size() - 1; i > 0)
      {
        if (top[i] != ground[i])
          simplices.push_back({{ground[i - 1], ground[i], top[i]}});
        if (top[i - 1] != ground[i - 1])
          simplices.push_back({{ground[i - 1], top[i], top[i - 1]}});
      }
    }
    if (simplices.empty())
      throw InputError("'" + path.substr(0, path.size() - 1) +
                       "' has no fluid. Allowed: a table of depths or a 'Level' above the ground "
                       "between the ends.");
  }



  void ProfileRelease::check_scale(const double h) const
  {
    if (deepest >= h)
      return;
    std::ostringstream message;
    message << "Parameter 'Mesh size' is " << h << " m, and the fluid of '" << path.substr(0, path.size() - 1)
            << "' is at most " << deepest
            << " m deep. Allowed: a mesh size of at most the depth, better a third of it.";
    throw InputError(message.str());
  }



  static const Factory<FluidShape<2>>::Registration<ProfileRelease>
    profile_release("release", "Fluid on a boundary of the shape 'terrain': by its depth or up to a level.");
} // namespace Lahar
