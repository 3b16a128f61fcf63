// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/surface_file.h>
#include <lahar/utilities/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF/File_header_OFF.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace Lahar
{
  namespace
  {
    namespace PMP = CGAL::Polygon_mesh_processing;

    using Kernel  = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh    = CGAL::Surface_mesh<Kernel::Point_3>;
    using Polygon = std::vector<std::size_t>;

    /// Rims shorter than this times the surface's diagonal are holes.
    constexpr double hole = 0.05;

    /// Edges between faces with a larger angle between their normals, in degrees, are kept.
    constexpr double sharp = 30.;

    /// The most triangles of a surface in memory.
    constexpr double most_triangles = 4e6;

    constexpr const char *kinds = "an STL, OBJ, PLY or OFF file of a surface, by its ending";

    [[noreturn]] void fail(const std::string &file_name, const std::string &found, const std::string &allowed)
    {
      throw InputError("Surface '" + file_name + "' " + found + ". Allowed: " + allowed + ".");
    }

    Point<3> to_point(const Kernel::Point_3 &p)
    {
      return Point<3>(p.x(), p.y(), p.z());
    }

    std::string place_of(const Mesh &mesh, const Mesh::Face_index face)
    {
      std::ostringstream text;
      std::string separator = "(";
      for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
      {
        text << separator << to_point(mesh.point(vertex));
        separator = "; ";
      }
      text << ")";
      return text.str();
    }

    struct Soup
    {
      std::vector<Kernel::Point_3> points;
      std::vector<Polygon> polygons;

      /// Whether polygon @p p starts with these points, or a rotation of them, in this order.
      bool is_turned(const unsigned int p, const std::array<Kernel::Point_3, 3> &before) const
      {
        const Polygon &polygon = polygons[p];
        const auto first       = std::find_if(polygon.begin(), polygon.end(),
                                              [&](const std::size_t i) { return points[i] == before[0]; });
        return first != polygon.end() &&
               points[polygon[(first - polygon.begin() + 1) % polygon.size()]] != before[1];
      }
    };

    /// The reader of OFF files takes memory for all that the header says. @throws InputError if the file is too short for
    /// it: a point has at least three numbers, a face one, and each is followed by a space or the line's end.
    void check_off_header(const std::string &file_name)
    {
      if (CGAL::IO::internal::get_file_extension(file_name) != "off")
        return;
      std::ifstream file(file_name, std::ios::binary);
      CGAL::File_header_OFF header;
      std::error_code error;
      const auto size = std::filesystem::file_size(file_name, error);
      if (!error && file >> header && 6. * header.size_of_vertices() + 2. * header.size_of_facets() > size)
        fail(file_name,
             "says that it has " + std::to_string(header.size_of_vertices()) + " points and " +
               std::to_string(header.size_of_facets()) + " faces, and is " + std::to_string(size) +
               " bytes long",
             "a whole file");
    }

    Soup read(const std::string &file_name, const double scale)
    {
      // A pipe would wait for its writer.
      std::error_code error;
      const auto status = std::filesystem::status(file_name, error);
      if (!std::filesystem::is_regular_file(status))
        fail(file_name, std::filesystem::exists(status) ? "is no regular file" : "does not exist", kinds);
      check_off_header(file_name);
      Soup soup;
      bool complete = false;
      try
      {
        complete = CGAL::IO::read_polygon_soup(file_name, soup.points, soup.polygons);
      }
      catch (const std::exception &)
      {}
      if (!complete || soup.polygons.empty())
        fail(file_name,
             soup.polygons.empty() ? "has no triangles that can be read" : "cannot be read to its end",
             kinds);
      for (Kernel::Point_3 &p : soup.points)
      {
        p = Kernel::Point_3(scale * p.x(), scale * p.y(), scale * p.z());
        if (!std::isfinite(to_point(p).norm_square()))
          fail(file_name, "has a point without finite coordinates", "finite numbers");
      }
      for (unsigned int p = 0; p < soup.polygons.size(); ++p)
        for (const std::size_t corner : soup.polygons[p])
          if (corner >= soup.points.size())
            fail(file_name, "has face " + std::to_string(p + 1) + " with a point that is not there",
                 "the file's points");
      return soup;
    }

    /// Places in which several edges of a mesh lie: where more than two faces meet at an edge, CGAL's meshes have copies of
    /// its points, and of it.
    class Joints
    {
    public:
      explicit Joints(const Mesh &mesh)
      {
        std::vector<Places> all;
        for (const auto edge : mesh.edges())
          all.push_back(places_of(mesh, mesh.halfedge(edge)));
        std::sort(all.begin(), all.end());
        for (std::size_t i = 1; i < all.size(); ++i)
          if (all[i] == all[i - 1] && (places.empty() || places.back() != all[i]))
            places.push_back(all[i]);
      }

      bool empty() const
      {
        return places.empty();
      }

      bool contains(const Mesh &mesh, const Mesh::Halfedge_index halfedge) const
      {
        return std::binary_search(places.begin(), places.end(), places_of(mesh, halfedge));
      }

    private:
      using Places = std::pair<Kernel::Point_3, Kernel::Point_3>;

      static Places places_of(const Mesh &mesh, const Mesh::Halfedge_index halfedge)
      {
        return std::minmax({mesh.point(mesh.source(halfedge)), mesh.point(mesh.target(halfedge))});
      }

      std::vector<Places> places; ///< sorted
    };

    /// Whether two triangles that have corners of their own in the same places do not meet beside these.
    bool only_join(const Mesh &mesh, const Mesh::Face_index first, const Mesh::Face_index second)
    {
      std::array<Kernel::Point_3, 3> a, b;
      unsigned int v = 0, w = 0;
      for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(first)))
        a[v++] = mesh.point(vertex);
      for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(second)))
        b[w++] = mesh.point(vertex);
      // Common corners to the front.
      unsigned int n_common = 0;
      for (unsigned int i = 0; i < 3; ++i)
        if (const auto same = std::find(b.begin() + n_common, b.end(), a[i]); same != b.end())
        {
          std::swap(b[n_common], *same);
          std::swap(a[n_common], a[i]);
          ++n_common;
        }
      using Triangle = Kernel::Triangle_3;
      using Segment  = Kernel::Segment_3;
      if (n_common == 1)
        return !CGAL::do_intersect(Triangle(a[0], a[1], a[2]), Segment(b[1], b[2])) &&
               !CGAL::do_intersect(Triangle(b[0], b[1], b[2]), Segment(a[1], a[2]));
      return n_common == 2 && !(CGAL::coplanar(a[0], a[1], a[2], b[2]) &&
                                CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::POSITIVE);
    }

    /// Close holes. @return their number, and the lengths of other rims shorter than the @p diagonal, without @p joints.
    std::pair<unsigned int, std::vector<double>> close_holes(const double diagonal, const Joints &joints,
                                                             Mesh &mesh)
    {
      std::vector<Mesh::Halfedge_index> rims;
      PMP::extract_boundary_cycles(mesh, std::back_inserter(rims));
      std::pair<unsigned int, std::vector<double>> result(0, {});
      for (const Mesh::Halfedge_index rim : rims)
      {
        double length = 0.;
        bool is_hole  = true;
        for (const auto halfedge : CGAL::halfedges_around_face(rim, mesh))
          if (joints.contains(mesh, halfedge))
            is_hole = false;
          else
            length += to_point(mesh.point(mesh.source(halfedge)))
                        .distance(to_point(mesh.point(mesh.target(halfedge))));
        std::vector<Mesh::Face_index> patch;
        if (is_hole && length < hole * diagonal)
          PMP::triangulate_hole(mesh, rim, std::back_inserter(patch));
        if (!patch.empty())
          ++result.first;
        else if (length > 0. && length < diagonal)
          result.second.push_back(length);
      }
      return result;
    }

    /// About how many triangles with edges of this length a mesh needs: by its area, and along its edges.
    double n_triangles(const Mesh &mesh, const double spacing)
    {
      double n = 0.;
      for (const Mesh::Face_index face : mesh.faces())
      {
        std::array<Point<3>, 3> p;
        unsigned int v = 0;
        for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
          p[v++] = to_point(mesh.point(vertex));
        const double area = 0.5 * cross_product_3d(p[1] - p[0], p[2] - p[0]).norm(),
                     edge = std::max({p[0].distance(p[1]), p[1].distance(p[2]), p[2].distance(p[0])});
        n += std::max(area / (0.43 * spacing * spacing), edge > spacing ? edge / spacing : 0.);
      }
      return n;
    }

    /// New triangles. @param keep_points so that edges that are kept are divided alike in all their copies.
    void remesh(const double spacing, const bool keep_points, Mesh &mesh)
    {
      auto kept = mesh.add_property_map<Mesh::Edge_index, bool>("e:kept", false).first;
      PMP::detect_sharp_edges(mesh, sharp, kept);
      for (const auto edge : mesh.edges())
        if (mesh.is_border(edge))
          kept[edge] = true;
      if (keep_points)
      {
        std::vector<Mesh::Edge_index> edges;
        for (const auto edge : mesh.edges())
          if (kept[edge])
            edges.push_back(edge);
        PMP::split_long_edges(edges, 1.3 * spacing, mesh, CGAL::parameters::edge_is_constrained_map(kept));
      }
      PMP::isotropic_remeshing(
        mesh.faces(), spacing, mesh,
        CGAL::parameters::number_of_iterations(5).edge_is_constrained_map(kept).protect_constraints(
          keep_points));
    }
  } // namespace



  SurfaceFile::SurfaceFile(const std::string &file_name, const double scale, const double spacing,
                           const std::string &spacing_entry)
  {
    Soup soup                = read(file_name, scale);
    const std::size_t n_read = soup.polygons.size();
    PMP::repair_polygon_soup(soup.points, soup.polygons);
    std::size_t n_lost = n_read - soup.polygons.size();

    std::vector<std::array<Kernel::Point_3, 3>> before;
    for (const Polygon &polygon : soup.polygons)
      before.push_back({{soup.points[polygon[0]], soup.points[polygon[1]], soup.points[polygon[2]]}});
    PMP::orient_polygon_soup(soup.points, soup.polygons);
    std::size_t n_turned = 0;
    for (unsigned int p = 0; p < before.size(); ++p)
      n_turned += soup.is_turned(p, before[p]);

    Mesh mesh;
    if (soup.polygons.empty() || !PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
      fail(file_name, "has no faces that make a surface", "faces with an area that meet along edges");
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
    PMP::triangulate_faces(mesh);
    const std::size_t n_before = mesh.number_of_faces();
    PMP::remove_degenerate_faces(mesh);
    n_lost += n_before - std::min<std::size_t>(n_before, mesh.number_of_faces());

    const Joints joints(mesh);
    const auto box = PMP::bbox(mesh);
    const double diagonal =
      Point<3>(box.xmin(), box.ymin(), box.zmin()).distance(Point<3>(box.xmax(), box.ymax(), box.zmax()));
    const auto [n_holes, rims] = close_holes(diagonal, joints, mesh);
    if (spacing > 0.)
    {
      if (const double n = n_triangles(mesh, spacing); !(n <= most_triangles))
      {
        std::ostringstream message;
        message << "Parameter '" << spacing_entry << "' is '" << spacing
                << "'. Allowed: 0 or a larger one; with this one the surface of '" << file_name
                << "' has about " << n << " triangles, and at most " << most_triangles << " are possible.";
        throw InputError(message.str());
      }
      remesh(spacing, !joints.empty(), mesh);
    }

    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> crossings;
    PMP::self_intersections(mesh, std::back_inserter(crossings));
    crossings.erase(std::remove_if(crossings.begin(), crossings.end(),
                                   [&](const auto &pair) {
                                     return only_join(mesh, pair.first, pair.second);
                                   }),
                    crossings.end());
    if (!crossings.empty())
      fail(
        file_name,
        "has triangles that cross others: " + std::to_string(crossings.size()) + " pairs, the first being " +
          place_of(mesh, crossings[0].first) + " and " + place_of(mesh, crossings[0].second) + " m",
        "triangles that meet at common edges and corners only; parts that cross may be boundaries with files of "
        "their own");

    for (const Mesh::Face_index face : mesh.faces())
    {
      std::array<Point<3>, 3> triangle;
      unsigned int v = 0;
      for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
        triangle[v++] = to_point(mesh.point(vertex));
      const Tensor<1, 3> ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
      if (cross_product_3d(ab, ac).norm() > 4e-6 * (ab.norm_square() + ac.norm_square()))
        all_triangles.push_back(triangle);
      else
        ++n_lost;
    }
    if (all_triangles.empty())
      fail(file_name, "has no triangles with an area", "a surface");

    const auto remark = [&](const bool needed, const std::string &text) {
      if (needed)
        all_remarks.push_back("Warning: surface '" + file_name + "': " + text);
    };
    remark(n_lost > 0, std::to_string(n_lost) + " faces twice there or without area were left out.");
    remark(n_turned > 0, std::to_string(n_turned) + " faces were turned over, as their neighbours are.");
    remark(n_holes > 0, std::to_string(n_holes) + " holes were closed.");
    std::ostringstream open;
    for (const double length : rims)
      open << (open.str().empty() ? "" : ", ") << length;
    remark(!rims.empty(), "fluid may pass through where it is open: there are rims of " + open.str() + " m.");
  }
} // namespace Lahar
