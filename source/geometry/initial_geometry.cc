#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/initial_geometry.h>
#include <lahar/geometry/point_lists.h>

#include <algorithm>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// "x, y : x, y : ..." as points.
    std::vector<Point<2>> parse_list(const Parameters &prm, const std::string &entry, const std::string &text)
    {
      return parse_points<2>(prm, entry, text,
                             "lists of points 'x, y : x, y : ...' separated by ';', lengths in m (found '" +
                               text + "')");
    }

    std::string numbered(const Parameters &prm, const std::string &entry, const unsigned int number)
    {
      return "number " + std::to_string(number) + " of '" + prm.path(entry) + "'";
    }

    std::string to_text(const Point<2> &p)
    {
      std::ostringstream text;
      text << '(' << p << ')';
      return text.str();
    }
  } // namespace



  void InitialGeometry::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Geometry");
    prm.declare_entry(
      "Fluid boxes", "", Patterns::Anything(),
      "Fluid rectangles, each as two opposite corners 'x, y : x, y', separated by ';'. Lengths in m.");
    prm.declare_entry("Fluid polygons", "", Patterns::Anything(),
                      "Fluid polygons, each as its corners 'x, y : x, y : x, y ...', separated by ';'.");
    prm.declare_entry(
      "No-slip walls", "", Patterns::Anything(),
      "Rigid walls without slip, each a polyline 'x, y : x, y ...', separated by ';'. A line whose last "
      "point is its first one is a closed body.");
    prm.declare_entry(
      "Slip walls", "", Patterns::Anything(),
      "Rigid walls with free slip, polylines as in 'No-slip walls'. Fluid slides along them and does "
      "not leave them.");
    prm.declare_entry(
      "Mesh file", "", Patterns::Anything(),
      "A gmsh file (.msh, ASCII, format 2.2 or 4.1) that gives fluid bodies and walls by physical groups.");
    prm.declare_entry("Fluid groups", "", Patterns::Anything(),
                      "Names of the mesh file's physical surfaces that are fluid, separated by commas.");
    prm.declare_entry(
      "No-slip wall groups", "", Patterns::Anything(),
      "Names of the mesh file's physical curves that are walls without slip, separated by commas.");
    prm.declare_entry(
      "Slip wall groups", "", Patterns::Anything(),
      "Names of the mesh file's physical curves that are walls with free slip, separated by commas.");
    prm.leave_subsection();
  }



  void InitialGeometry::parse_parameters(Parameters &prm, const bool has_solids)
  {
    prm.enter_subsection("Geometry");
    parse_bodies(prm);
    parse_lines(prm, "No-slip walls", false);
    parse_lines(prm, "Slip walls", true);
    parse_mesh_file(prm);
    if (bodies.empty() && !has_solids)
      throw InputError("There is no fluid: '" + prm.path("Fluid boxes") + "', '" +
                       prm.path("Fluid polygons") + "' and '" + prm.path("Fluid groups") +
                       "' are all empty.");
    prm.leave_subsection();
  }



  void InitialGeometry::parse_bodies(Parameters &prm)
  {
    unsigned int number = 0;
    for (const std::string &text : split_list(prm.get("Fluid boxes"), ';'))
    {
      const std::vector<Point<2>> p = parse_list(prm, "Fluid boxes", text);
      if (p.size() != 2 || p[0][0] == p[1][0] || p[0][1] == p[1][1])
        prm.throw_wrong_value("Fluid boxes",
                              "two opposite corners with different x and different y for each box");
      const double x[2] = {std::min(p[0][0], p[1][0]), std::max(p[0][0], p[1][0])};
      const double y[2] = {std::min(p[0][1], p[1][1]), std::max(p[0][1], p[1][1])};
      bodies.push_back(
        {numbered(prm, "Fluid boxes", ++number),
         {Point<2>(x[0], y[0]), Point<2>(x[1], y[0]), Point<2>(x[1], y[1]), Point<2>(x[0], y[1])},
         {}});
    }

    number = 0;
    for (const std::string &text : split_list(prm.get("Fluid polygons"), ';'))
    {
      Polygon polygon = parse_list(prm, "Fluid polygons", text);
      if (polygon.size() < 3 || is_self_intersecting(polygon) || signed_area(polygon) == 0.)
        prm.throw_wrong_value("Fluid polygons",
                              "at least three corners and edges that do not meet each other");
      if (signed_area(polygon) < 0.)
        std::reverse(polygon.begin(), polygon.end());
      bodies.push_back({numbered(prm, "Fluid polygons", ++number), polygon, {}});
    }
  }



  void InitialGeometry::parse_lines(Parameters &prm, const std::string &entry, const bool slip)
  {
    unsigned int number = 0;
    for (const std::string &text : split_list(prm.get(entry), ';'))
    {
      Line line{numbered(prm, entry, ++number), parse_list(prm, entry, text), false, slip};
      if (line.corners.size() > 2 && line.corners.front() == line.corners.back())
      {
        line.closed = true;
        line.corners.pop_back();
      }
      bool has_length = line.corners.size() >= 2;
      for (unsigned int i = 1; i < line.corners.size(); ++i)
        has_length = has_length && line.corners[i] != line.corners[i - 1];
      if (!has_length)
        prm.throw_wrong_value(entry, "at least two different points for each wall, neighbours apart");
      lines.push_back(line);
    }
  }



  void InitialGeometry::parse_mesh_file(Parameters &prm)
  {
    const std::string file_name = prm.get("Mesh file");
    const auto fluid            = split_list(prm.get("Fluid groups"), ',');
    const auto no_slip          = split_list(prm.get("No-slip wall groups"), ',');
    const auto slip             = split_list(prm.get("Slip wall groups"), ',');
    if (file_name.empty())
    {
      if (!fluid.empty() || !no_slip.empty() || !slip.empty())
        prm.throw_wrong_value("Mesh file", "the name of a gmsh file, since groups of it are named");
      return;
    }

    const GmshFile file(file_name);
    for (const std::string &group : fluid)
      bodies.push_back({"group '" + group + "' of " + file_name, {}, file.nodes_of_surface(group)});
    for (const bool is_slip : {false, true})
      for (const std::string &group : is_slip ? slip : no_slip)
        for (const auto &edge : file.edges_of_curve(group))
          lines.push_back({"group '" + group + "' of " + file_name, {edge[0], edge[1]}, false, is_slip});
  }



  void InitialGeometry::check_body_sizes(const double h) const
  {
    for (const Body &body : bodies)
    {
      const std::vector<Point<2>> &points = body.contour.empty() ? body.nodes : body.contour;
      for (unsigned int d = 0; d < 2; ++d)
      {
        const auto [lower, upper] = std::minmax_element(points.begin(), points.end(),
                                                        [d](const Point<2> &a, const Point<2> &b) {
                                                          return a[d] < b[d];
                                                        });
        const double extent       = (*upper)[d] - (*lower)[d];
        if (h > extent * (1. + 1e-10))
        {
          std::ostringstream message;
          message << "Parameter 'Mesh size' is " << h << " m, larger than fluid body " << body.name
                  << ", which is " << extent << " m in direction "
                  << "xy"[d] << ". Allowed: at most the size of every body.";
          throw InputError(message.str());
        }
      }
    }
  }



  void InitialGeometry::check_overlaps(const double h) const
  {
    const double tolerance = 1e-3 * h;
    const auto check       = [&](const Body &body, const Point<2> &p, const std::string &name) {
      if (!body.contour.empty() && is_inside(body.contour, p) &&
          distance_to_contour(body.contour, p) > tolerance)
        throw InputError("Fluid body " + body.name + " overlaps " + name + " at " + to_text(p) +
                               " m. Fluid and walls may touch, not overlap.");
    };

    for (const Body &body : bodies)
      for (const Line &line : lines)
      {
        for (const Point<2> &p : sample_polyline(line.corners, 0.2 * h, line.closed))
          check(body, p, "wall " + line.name);
        if (line.closed)
          for (const Point<2> &p :
               body.contour.empty() ? body.nodes : sample_polyline(body.contour, 0.2 * h, true))
            check({line.name, line.corners, {}}, p, "wall " + line.name);
      }
    for (const Body &body : bodies)
      for (const Body &other : bodies)
        if (&body != &other)
          for (const Point<2> &p : other.contour.empty() ? other.nodes : fill_polygon(other.contour, h))
            check(body, p, "fluid body " + other.name);
  }



  void InitialGeometry::check_solids(const SolidContour<2> &solids, const double h) const
  {
    const auto is_deep_inside = [&](const Point<2> &p) {
      if (!solids.is_inside(p))
        return false;
      for (const auto &facet : solids.wall_facets())
        if (distance_to_segment(p, facet.corners[0], facet.corners[1]) < 1e-3 * h)
          return false;
      return true;
    };
    const auto fail = [](const std::string &what, const Point<2> &p) {
      throw InputError(what + " overlaps a solid at " + to_text(p) +
                       " m. Fluid, walls and solids may touch, not overlap.");
    };
    for (const Line &line : lines)
      for (const Point<2> &p : sample_polyline(line.corners, 0.2 * h, line.closed))
        if (is_deep_inside(p))
          fail("Wall " + line.name, p);
    for (const Body &body : bodies)
    {
      for (const Point<2> &p : body.contour.empty() ? body.nodes : fill_polygon(body.contour, h))
        if (is_deep_inside(p))
          fail("Fluid body " + body.name, p);
      if (!body.contour.empty())
        for (const auto &facet : solids.wall_facets())
          if (is_inside(body.contour, facet.corners[0]) &&
              distance_to_contour(body.contour, facet.corners[0]) > 1e-3 * h)
            fail("Fluid body " + body.name, facet.corners[0]);
    }
  }



  std::vector<Point<2>> InitialGeometry::with_contact_points(const Line &line, const SolidContour<2> &solids,
                                                             const double h) const
  {
    std::vector<Point<2>> result;
    const unsigned int n_pieces = line.closed ? line.corners.size() : line.corners.size() - 1;
    for (unsigned int i = 0; i < n_pieces; ++i)
    {
      const Point<2> &a = line.corners[i];
      const Point<2> &b = line.corners[(i + 1) % line.corners.size()];

      std::vector<Point<2>> contacts;
      for (const Body &body : bodies)
        for (const Point<2> &corner : body.contour)
          if (distance_to_segment(corner, a, b) < 1e-3 * h && corner.distance(a) > 0.5 * h &&
              corner.distance(b) > 0.5 * h)
            contacts.push_back(corner);
      // Facets in a row along the line share nodes: the ends of the row are in one only.
      std::vector<Point<2>> on_line;
      for (const auto &facet : solids.wall_facets())
        if (distance_to_segment(facet.corners[0], a, b) < 1e-3 * h &&
            distance_to_segment(facet.corners[1], a, b) < 1e-3 * h)
          on_line.insert(on_line.end(), facet.corners.begin(), facet.corners.end());
      for (const Point<2> &p : on_line)
        if (std::count(on_line.begin(), on_line.end(), p) == 1 && p.distance(a) > 0.5 * h &&
            p.distance(b) > 0.5 * h)
          contacts.push_back(p);
      std::sort(contacts.begin(), contacts.end(), [&a](const Point<2> &p, const Point<2> &q) {
        return p.distance_square(a) < q.distance_square(a);
      });

      result.push_back(a);
      for (const Point<2> &p : contacts)
        if (p.distance(result.back()) > 0.5 * h)
          result.push_back(p);
    }
    if (!line.closed)
      result.push_back(line.corners.back());
    return result;
  }



  std::vector<bool> InitialGeometry::create(const double h, const SolidContour<2> &solids,
                                            ParticleCloud<2> &cloud, Walls<2> &walls) const
  {
    check_body_sizes(h);
    check_overlaps(h);
    check_solids(solids, h);

    std::vector<WallFacet<2>> facets;
    std::vector<Point<2>> wall_points;
    for (const Line &line : lines)
    {
      const unsigned int n = line.corners.size();
      for (unsigned int i = 0; i + 1 < n + line.closed; ++i)
        facets.push_back({{{line.corners[i], line.corners[(i + 1) % n]}}, line.slip});
      if (!line.slip)
        for (const Point<2> &p : sample_polyline(with_contact_points(line, solids, h), h, line.closed))
          if (std::none_of(solids.wall_facets().begin(), solids.wall_facets().end(), [&](const auto &facet) {
                return distance_to_segment(p, facet.corners[0], facet.corners[1]) < 0.1 * h;
              }))
            wall_points.push_back(p);
    }
    walls = Walls<2>(facets);

    // Two lines may share points, a fluid's contour may run along a wall: the first particle in a place stays, and a
    // wall particle in the place of a fluid particle is wet.
    std::vector<bool> wet(cloud.size(), false);
    const auto add = [&](const Point<2> &p, const ParticleKind kind, const double clearance) {
      bool is_free = true;
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (p.distance_square(cloud.position[i]) < clearance * clearance)
        {
          is_free = false;
          if (kind == ParticleKind::fluid)
            wet[i] = true;
        }
      if (is_free)
      {
        cloud.append(p, kind, h);
        wet.push_back(kind == ParticleKind::fluid);
      }
    };
    for (const Point<2> &p : wall_points)
      add(p, ParticleKind::wall, 0.1 * h);
    for (const Body &body : bodies)
    {
      for (unsigned int i = 0; i < cloud.size() && !body.contour.empty(); ++i)
        if (cloud.kind[i] != ParticleKind::fluid &&
            distance_to_contour(body.contour, cloud.position[i]) < 0.1 * h)
          wet[i] = true;
      for (const Point<2> &p : body.contour.empty() ? body.nodes : fill_polygon(body.contour, h))
        add(p, ParticleKind::fluid, 0.3 * h);
    }
    if (has_fluid() && cloud.n_particles(ParticleKind::fluid) == 0)
      throw InputError("No fluid particle is left beside the walls: all lie within 0.3 mesh sizes of one.");
    return wet;
  }
} // namespace Lahar
