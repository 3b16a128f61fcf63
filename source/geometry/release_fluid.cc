// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/ground_of_boundary.h>
#include <lahar/geometry/layer_body.h>
#include <lahar/geometry/map_raster.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/geometry/polygon.h>
#include <lahar/geometry/terrain.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/number_table.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Lahar
{
  /**
   * Fluid on the ground of a boundary of the shape 'terrain': of a depth inside an outline, of the depths of a raster, or up
   * to a level. Outline, raster and level are in the coordinates of the map, as the terrain's file.
   */
  class ReleaseFluid : public FluidShape<3>
  {
  public:
    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm) override;

    Bodies bodies(const std::string &name) const override
    {
      Bodies result;
      result.push_back(std::make_unique<LayerBody>(name, pieces));
      return result;
    }

    void check_scale(const double h) const override;

  private:
    void parse_outlines(const Parameters &prm, const Terrain &terrain);

    /// Cut the pieces along the outlines and keep what is inside.
    void keep_inside();

    /// Depths of the pieces' corners from a raster of @p terrain's map.
    void take_depths(const MapRaster &raster, const Parameters &prm, const Terrain &terrain);

    std::vector<Polygon> outlines; ///< in coordinates of the case
    std::vector<GroundPiece> pieces;
    std::string path; ///< of the shape's section
  };



  namespace
  {
    /// The ground of the boundary that the entry 'Boundary' of the current section names.
    Terrain terrain_of(Parameters &prm)
    {
      const InGroundOfBoundary section(prm);
      return Terrain(prm);
    }

    double mean_size(const std::vector<GroundPiece> &pieces)
    {
      double sum = 0.;
      for (const GroundPiece &piece : pieces)
        sum += piece[0].place.distance(piece[1].place) / pieces.size();
      return sum;
    }

    using Edge = std::array<Point<2>, 2>; ///< of an outline

    /// Halve the pieces that meet an edge along its line; then none has parts on both sides of it.
    void cut_along(const Edge &edge, const double tolerance, std::vector<GroundPiece> &pieces)
    {
      const double length      = edge[0].distance(edge[1]);
      const Tensor<1, 2> along = (edge[1] - edge[0]) / length, across = cross_product_2d(along);
      std::vector<GroundPiece> result;
      for (const GroundPiece &piece : pieces)
      {
        std::array<double, 3> beside, opposite;
        double first = length, last = 0., lowest = 0., highest = 0.;
        for (unsigned int v = 0; v < 3; ++v)
        {
          const Tensor<1, 2> from = Point<2>(piece[v].place[0], piece[v].place[1]) - edge[0];
          beside[v]               = across * from;
          opposite[v]             = -beside[v];
          first                   = std::min(first, along * from);
          last                    = std::max(last, along * from);
          lowest                  = std::min(lowest, beside[v]);
          highest                 = std::max(highest, beside[v]);
        }
        if (lowest > -tolerance || highest < tolerance || first > length || last < 0.)
        {
          result.push_back(piece);
          continue;
        }
        for (const auto &values : {beside, opposite})
          for (const GroundPiece &part : positive_part(piece, values, tolerance))
            result.push_back(part);
      }
      pieces.swap(result);
    }
  } // namespace



  void ReleaseFluid::declare_parameters(Parameters &prm)
  {
    prm.declare_text("Boundary", "", "The boundary on which the fluid lies; its 'Shape' is 'terrain'.");
    prm.declare_positive("Depth", "0",
                         "Depth of the fluid in m, measured upwards, inside the outline; 0: see below.");
    prm.declare_file(
      "Depth file",
      "A raster of depths in m instead, in the coordinates of the terrain's file: an ESRI ASCII grid or "
      "a GeoTIFF, bilinear between the cells' middles. Cells without value have no fluid.");
    prm.declare_text("Level", "",
                     "The elevation in m, as in the terrain's file, up to which the fluid reaches instead.");
    prm.declare_list(
      "Outline", "", ';',
      "Polygons that hold the fluid, each as its corners 'x, y : x, y : x, y ...' in the coordinates of "
      "the terrain's file, separated by ';'. With 'Depth' there must be one; with 'Level' or 'Depth "
      "file' and no outline there is fluid wherever they give it.");
    prm.declare_file("Outline file", "A table (CSV) of the corners 'x, y' of one polygon instead.");
  }



  void ReleaseFluid::parse_outlines(const Parameters &prm, const Terrain &terrain)
  {
    outlines          = parse_point_lists<2>(prm, "Outline");
    std::string entry = "Outline";
    if (const std::string file = prm.get("Outline file"); !file.empty())
    {
      if (!outlines.empty())
        prm.throw_wrong_value("Outline file", "'Outline' or 'Outline file', not both");
      entry = "Outline file";
      const NumberTable table(file, {"x", "y"});
      outlines.emplace_back();
      for (const NumberTable::Row &row : table.rows())
        outlines.back().emplace_back(row[0], row[1]);
    }
    for (Polygon &outline : outlines)
    {
      if (outline.size() > 2 && outline.front() == outline.back())
        outline.pop_back();
      if (outline.size() < 3 || is_self_intersecting(outline) || signed_area(outline) == 0.)
        prm.throw_wrong_value(entry, "at least three corners and edges that do not meet each other");
      for (Point<2> &corner : outline)
      {
        if (!terrain.window().contains(corner, 0.))
        {
          std::ostringstream allowed;
          allowed.precision(12);
          allowed << "corners within the terrain, which reaches from (" << terrain.window().lower << ") to ("
                  << terrain.window().upper << ") m (found " << corner << ")";
          prm.throw_wrong_value(entry, allowed.str());
        }
        corner -= Tensor<1, 2>({terrain.origin()[0], terrain.origin()[1]});
      }
    }
  }



  void ReleaseFluid::keep_inside()
  {
    const double tolerance = 1e-7 * mean_size(pieces);
    std::vector<Edge> edges;
    std::vector<BoundingBox<2>> outline_boxes;
    std::vector<std::pair<BoundingBox<2>, unsigned int>> edge_boxes;
    for (const Polygon &outline : outlines)
    {
      outline_boxes.emplace_back(outline);
      for (unsigned int i = 0; i < outline.size(); ++i)
      {
        edges.push_back({{outline[i], outline[(i + 1) % outline.size()]}});
        edge_boxes.emplace_back(BoundingBox<2>(edges.back()), edge_boxes.size());
      }
    }
    const auto edge_tree = pack_rtree(edge_boxes);

    std::vector<GroundPiece> inside;
    for (const GroundPiece &piece : pieces)
    {
      std::array<Point<2>, 3> plan;
      for (unsigned int v = 0; v < 3; ++v)
        plan[v] = {piece[v].place[0], piece[v].place[1]};
      const BoundingBox<2> box(plan);
      if (std::none_of(outline_boxes.begin(), outline_boxes.end(), [&](const BoundingBox<2> &outline_box) {
            return boost::geometry::intersects(outline_box, box);
          }))
        continue;
      std::vector<unsigned int> near;
      for (const auto &[edge_box, e] :
           edge_tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(box)))
        near.push_back(e);
      std::sort(near.begin(), near.end());
      std::vector<GroundPiece> parts(1, piece);
      for (const unsigned int e : near)
        cut_along(edges[e], tolerance, parts);
      for (const GroundPiece &part : parts)
      {
        Point<2> middle;
        for (const GroundPoint &corner : part)
          middle += Tensor<1, 2>({corner.place[0], corner.place[1]}) / 3.;
        if (std::any_of(outlines.begin(), outlines.end(),
                        [&](const Polygon &outline) { return is_inside(outline, middle); }))
          inside.push_back(part);
      }
    }
    pieces.swap(inside);
  }



  void ReleaseFluid::take_depths(const MapRaster &raster, const Parameters &prm, const Terrain &terrain)
  {
    const Box<2> extent = raster.extent(), &window = terrain.window();
    const std::vector<double> columns = raster.lines(0), rows = raster.lines(1);
    for (unsigned int j = 0; j < rows.size(); ++j)
      for (unsigned int i = 0; i < columns.size(); ++i)
        if (const double depth = raster.cell(i, j);
            depth < 0. || (depth > 0. && !window.contains({columns[i], rows[j]}, 0.)))
        {
          std::ostringstream allowed;
          allowed.precision(12);
          allowed
            << "a raster of depths zero or above, with fluid only within the terrain, which reaches from ("
            << window.lower << ") to (" << window.upper << ") m (found " << depth << " m at (" << columns[i]
            << ' ' << rows[j] << "))";
          prm.throw_wrong_value("Depth file", allowed.str());
        }
    for (GroundPiece &piece : pieces)
      for (GroundPoint &corner : piece)
      {
        const Point<2> place(corner.place[0] + terrain.origin()[0], corner.place[1] + terrain.origin()[1]);
        // Beside the raster depth falls to zero within a cell.
        double share = 1.;
        Point<2> nearest;
        for (unsigned int d = 0; d < 2; ++d)
        {
          nearest[d] = std::clamp(place[d], extent.lower[d], extent.upper[d]);
          share *= std::max(0., 1. - std::abs(place[d] - nearest[d]) / raster.cell_size()[d]);
        }
        corner.depth = share * raster.value(nearest, 0.);
      }
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                                [](const GroundPiece &piece) {
                                  return std::all_of(piece.begin(), piece.end(),
                                                     [](const GroundPoint &corner) {
                                                       return corner.depth == 0.;
                                                     });
                                }),
                 pieces.end());
  }



  void ReleaseFluid::parse_parameters(Parameters &prm)
  {
    path                   = prm.path("");
    const Terrain terrain  = terrain_of(prm);
    const double depth     = prm.get_positive("Depth", true);
    const std::string file = prm.get("Depth file"), level_text = prm.get("Level");
    if ((depth > 0.) + !file.empty() + !level_text.empty() != 1)
      prm.throw_wrong_value("Depth", "one of 'Depth', 'Depth file' and 'Level', and not more");
    for (const auto &triangle : terrain.triangles())
      pieces.push_back({{{triangle[0], depth}, {triangle[1], depth}, {triangle[2], depth}}});
    parse_outlines(prm, terrain);
    if (depth > 0. && outlines.empty())
      prm.throw_wrong_value("Outline", "polygons, inside which 'Depth' is the fluid's depth");

    double level = 0.;
    if (!level_text.empty())
    {
      try
      {
        level = to_number(level_text) - terrain.origin()[2];
      }
      catch (const std::invalid_argument &)
      {
        prm.throw_wrong_value("Level", "an elevation in m");
      }
      const double tolerance = 1e-7 * mean_size(pieces);
      std::vector<GroundPiece> wet;
      for (GroundPiece &piece : pieces)
      {
        std::array<double, 3> depths;
        for (unsigned int v = 0; v < 3; ++v)
          piece[v].depth = depths[v] = level - piece[v].place[2];
        for (const GroundPiece &part : positive_part(piece, depths, tolerance))
          wet.push_back(part);
      }
      pieces = wet;
    }
    if (!file.empty())
      take_depths(MapRaster(file), prm, terrain);
    if (!outlines.empty() && !pieces.empty())
      keep_inside();
    if (pieces.empty())
      throw InputError("'" + path.substr(0, path.size() - 1) + "' has no fluid. Allowed: " +
                       (level_text.empty() ? "a raster with depths" : "a 'Level'") +
                       " above the ground within the terrain and the outline.");
  }



  void ReleaseFluid::check_scale(const double h) const
  {
    const double depth = LayerBody("", pieces).depth();
    if (depth >= h)
      return;
    std::ostringstream message;
    message << "Parameter 'Mesh size' is " << h << " m, and the fluid of '" << path.substr(0, path.size() - 1)
            << "' is at most " << depth
            << " m deep. Allowed: a mesh size of at most the depth, better a third of it.";
    throw InputError(message.str());
  }



  static const Factory<FluidShape<3>>::Registration<ReleaseFluid>
    release("release", "Fluid on a boundary of the shape 'terrain': by its depth or up to a level.");
} // namespace Lahar
