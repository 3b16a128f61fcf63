// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_visualization_h
#define lahar_postprocess_visualization_h

#include <lahar/postprocess/output_field.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * Writes solution-NNNNN.vtu files and solution.pvd, which lists them with their times, for ParaView. Solids have
   * files of their own, solid-NNNNN.vtu (SolidOutput), which solution.pvd lists as a second part. Rigid walls are the
   * third part: one file walls.vtu if they stay, walls-NNNNN.vtu otherwise.
   *
   * The fields of the fluid are models, see OutputField. On several ranks each writes a piece of the fluid,
   * solution-NNNNN.R.vtu, and solution-NNNNN.pvtu lists them. Files are written under a temporary name first, so that each
   * that has its final name is complete. The list leaves out files that others have removed, as long as they are away.
   */
  template <int dim>
  class Visualization
  {
  public:
    /// @param directory output directory, which exists.
    Visualization(const std::string &directory, const MPI_Comm &communicator);

    /// Collective. @return on the first rank which files have been removed since the last time, for people. @throws
    /// RunError if a file cannot be written.
    std::string write(const Snapshot<dim> &snapshot, const typename OutputField<dim>::List &fields);

    /// Write walls.vtu, if there are walls, which are the same on all ranks, and none moves. @throws RunError as above
    void write_walls(const Walls<dim> &walls);

    /// What was written so far.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &n_written &has_walls &records;
    }

  private:
    /// A file in solution.pvd.
    struct Record
    {
      double time;
      unsigned int part; ///< 0: fluid, 1: solids, 2: walls
      std::string file_name;

      template <typename Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &time &part &file_name;
      }
    };

    /// Each rank its own cells, then the list. @return the name of the file with all of the fluid; none if there is none.
    std::string write_fluid(const Snapshot<dim> &snapshot, const typename OutputField<dim>::List &fields,
                            const std::string &name) const;
    /// Write the mesh to one of the @p pieces. @return the list of these.
    std::string write_piece(const Snapshot<dim> &snapshot, const typename OutputField<dim>::List &fields,
                            const std::string &file_name, const std::vector<std::string> &pieces) const;
    std::string write_records();

    std::string directory;
    MPI_Comm communicator;
    unsigned int n_written = 0;
    bool has_walls         = false;
    std::vector<Record> records;
    std::set<std::string> missing; ///< of their files
  };
} // namespace Lahar

#endif
