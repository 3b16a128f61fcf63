// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/map_raster.h>
#include <lahar/utilities/exceptions.h>

#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <sstream>
#include <system_error>

namespace Lahar
{
  namespace
  {
    /// Of a raster in memory.
    constexpr double most_cells = 2.5e7;

    /// Shares of cells below this are rounding.
    constexpr double share_rounding = 1e-6;

    /// GDAL's own messages stay away from the user's screen.
    struct QuietErrors
    {
      QuietErrors()
      {
        CPLErrorReset();
        CPLPushErrorHandler(CPLQuietErrorHandler);
      }

      ~QuietErrors()
      {
        CPLPopErrorHandler();
      }
    };

    using Dataset = std::unique_ptr<void, void (*)(GDALDatasetH)>;

    [[noreturn]] void fail(const std::string &file_name, const std::string &found, const std::string &allowed)
    {
      throw InputError("Grid '" + file_name + "' " + found + ". Allowed: " + allowed + ".");
    }

    Dataset open(const std::string &file_name)
    {
      // A pipe would wait for its writer.
      std::error_code error;
      const auto status = std::filesystem::status(file_name, error);
      if (!std::filesystem::is_regular_file(status))
        fail(file_name, std::filesystem::exists(status) ? "is no regular file" : "does not exist",
             "an ESRI ASCII grid (.asc) or a GeoTIFF");
      GDALRegister_AAIGrid();
      GDALRegister_GTiff();
      const char *drivers[]   = {"AAIGrid", "GTiff", nullptr};
      const char *precision[] = {"DATATYPE=Float64", nullptr}; // of AAIGrid, whose default is 32 bits
      Dataset dataset(GDALOpenEx(file_name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, precision,
                                 nullptr),
                      [](GDALDatasetH handle) { GDALClose(handle); });
      if (!dataset)
        fail(file_name,
             "cannot be read" + (*CPLGetLastErrorMsg() != '\0'
                                   ? " (" + std::string(CPLGetLastErrorMsg()) + ")"
                                   : std::string()),
             "an ESRI ASCII grid (.asc) or a GeoTIFF");
      return dataset;
    }

    /// @return whether the file knows its map. @throws InputError unless its coordinates are in metres.
    bool check_metres(const std::string &file_name, GDALDatasetH dataset)
    {
      const OGRSpatialReferenceH reference = GDALGetSpatialRef(dataset);
      if (reference == nullptr)
        return false;
      if (OSRIsGeographic(reference))
        fail(file_name, "has coordinates in degrees",
             "a projected one with coordinates in m, as UTM (gdalwarp -t_srs EPSG:... makes it)");
      char *unit = nullptr;
      if (const double length = OSRGetLinearUnits(reference, &unit); std::abs(length - 1.) > 1e-12)
      {
        std::ostringstream found;
        found << "has coordinates in units of " << length << " m (" << (unit == nullptr ? "" : unit) << ")";
        fail(file_name, found.str(), "coordinates in m");
      }
      return true;
    }
  } // namespace



  MapRaster::MapRaster(const std::string &file_name, const std::optional<Box<2>> &window)
  {
    const QuietErrors quiet;
    const Dataset dataset = open(file_name);
    projected             = check_metres(file_name, dataset.get());
    std::array<double, 6> map{};
    if (GDALGetGeoTransform(dataset.get(), map.data()) != CE_None)
      fail(file_name, "does not say where it lies",
           "a grid with the coordinates of its corner and its cell size");
    if (map[2] != 0. || map[4] != 0. || !(map[1] > 0.) || !(std::abs(map[5]) > 0.) ||
        !std::isfinite(map[0] + map[1] + map[3] + map[5]))
      fail(file_name, "has rows that do not run from west to east",
           "a grid along x and y (gdalwarp makes it)");
    if (GDALGetRasterCount(dataset.get()) != 1)
      fail(file_name, "has " + std::to_string(GDALGetRasterCount(dataset.get())) + " bands", "one");
    const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
    if (const std::string unit = GDALGetRasterUnitType(band); !unit.empty() && unit != "m" &&
                                                              unit != "metre" && unit != "meter" &&
                                                              unit != "metres" && unit != "meters")
      fail(file_name, "has values in '" + unit + "'", "metres");

    const std::array<unsigned int, 2> n_all = {
      {static_cast<unsigned int>(GDALGetRasterXSize(dataset.get())),
       static_cast<unsigned int>(GDALGetRasterYSize(dataset.get()))}};
    // Middles of the cells in the south-western corner.
    size  = {{map[1], std::abs(map[5])}};
    first = {{map[0] + 0.5 * map[1], map[3] + (map[5] < 0. ? n_all[1] - 0.5 : 0.5) * map[5]}};
    std::array<unsigned int, 2> begin{};
    n = n_all;
    for (unsigned int d = 0; d < 2 && window; ++d)
    {
      const double lower = (window->lower[d] - first[d]) / size[d],
                   upper = (window->upper[d] - first[d]) / size[d];
      if (!(lower > -share_rounding && upper < n_all[d] - 1. + share_rounding))
      {
        std::ostringstream found;
        found.precision(12);
        found << "reaches from " << first[0] << " to " << first[0] + (n_all[0] - 1.) * size[0]
              << " m in x and from " << first[1] << " to " << first[1] + (n_all[1] - 1.) * size[1]
              << " m in y (middles of its cells); what is wanted of it lies from " << window->lower[0]
              << " to " << window->upper[0] << " m and from " << window->lower[1] << " to "
              << window->upper[1] << " m";
        fail(file_name, found.str(), "a window within the grid");
      }
      begin[d] = std::max(0., std::floor(lower + share_rounding));
      n[d]     = std::min(n_all[d] - 1., std::ceil(upper - share_rounding)) - begin[d] + 1.;
    }
    if (double(n[0]) * n[1] > most_cells)
      fail(file_name, "has " + std::to_string(n[0]) + " x " + std::to_string(n[1]) + " cells",
           "at most 25000000 in the window");

    values.resize(std::size_t(n[0]) * n[1]);
    const unsigned int first_row = map[5] < 0. ? n_all[1] - begin[1] - n[1] : begin[1];
    if (GDALRasterIO(band, GF_Read, begin[0], first_row, n[0], n[1], values.data(), n[0], n[1], GDT_Float64,
                     0, 0) != CE_None)
      fail(file_name, "cannot be read to its end (" + std::string(CPLGetLastErrorMsg()) + ")",
           "a whole file");
    if (map[5] < 0.)
      for (unsigned int row = 0; row < n[1] / 2; ++row)
        std::swap_ranges(values.begin() + std::size_t(row) * n[0],
                         values.begin() + std::size_t(row + 1) * n[0],
                         values.end() - std::size_t(row + 1) * n[0]);
    int has_gaps        = 0;
    const double gap    = GDALGetRasterNoDataValue(band, &has_gaps);
    const double factor = GDALGetRasterScale(band, nullptr), offset = GDALGetRasterOffset(band, nullptr);
    for (double &value : values)
      if ((has_gaps && value == gap) || !std::isfinite(value))
        value = std::numeric_limits<double>::quiet_NaN();
      else
        value = offset + factor * value;
    for (unsigned int d = 0; d < 2; ++d)
      first[d] += begin[d] * size[d];
  }



  Box<2> MapRaster::extent() const
  {
    return Box<2>({first[0], first[1]}, {first[0] + (n[0] - 1.) * size[0], first[1] + (n[1] - 1.) * size[1]});
  }



  std::vector<double> MapRaster::lines(const unsigned int direction) const
  {
    std::vector<double> result(n[direction]);
    for (unsigned int i = 0; i < n[direction]; ++i)
      result[i] = first[direction] + i * size[direction];
    return result;
  }



  double MapRaster::value(const Point<2> &point, const double gap) const
  {
    std::array<unsigned int, 2> corner;
    std::array<double, 2> share;
    for (unsigned int d = 0; d < 2; ++d)
    {
      const double place = (point[d] - first[d]) / size[d];
      corner[d]          = std::clamp(std::floor(place), 0., std::max(0., n[d] - 2.));
      share[d]           = std::clamp(place - corner[d], 0., 1.);
      if (share[d] < share_rounding || share[d] > 1. - share_rounding)
        share[d] = std::round(share[d]);
    }
    double sum = 0.;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
      {
        const double weight = (i == 0 ? 1. - share[0] : share[0]) * (j == 0 ? 1. - share[1] : share[1]);
        if (weight > 0.)
        {
          const double of_cell = cell(corner[0] + i, corner[1] + j);
          sum += weight * (std::isnan(of_cell) ? gap : of_cell);
        }
      }
    return sum;
  }
} // namespace Lahar
