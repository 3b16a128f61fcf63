// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/gmsh_model.h>
#include <lahar/utilities/exceptions.h>

#include <gmsh.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <set>
#include <vector>

namespace Lahar
{
  namespace
  {
    /// Of a file's name, in small letters.
    std::string ending_of(const std::string &file_name)
    {
      std::string ending = std::filesystem::path(file_name).extension().string();
      std::transform(ending.begin(), ending.end(), ending.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return ending;
    }



    /// gmsh's library while it is in use; its messages are kept, not printed.
    class Gmsh
    {
    public:
      Gmsh()
      {
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::logger::start();
      }

      ~Gmsh()
      {
        gmsh::finalize();
      }

      Gmsh(const Gmsh &)            = delete;
      Gmsh &operator=(const Gmsh &) = delete;

      /// The last error; @p otherwise if there was none.
      std::string error(const std::string &otherwise) const
      {
        std::vector<std::string> lines;
        gmsh::logger::get(lines);
        const auto line = std::find_if(lines.rbegin(), lines.rend(), [](const std::string &text) {
          return text.compare(0, 7, "Error: ") == 0;
        });
        return line == lines.rend() ? otherwise : line->substr(7);
      }
    };



    void add_groups()
    {
      std::vector<std::pair<int, int>> entities, groups;
      gmsh::model::getPhysicalGroups(groups);
      if (!groups.empty())
        return;
      gmsh::model::getEntities(entities);
      for (const auto &[dimension, tag] : entities)
        gmsh::model::addPhysicalGroup(dimension, {tag}, tag);
    }



    /// An empty file that nobody else has. @throws InputError if there is no room for it.
    std::string temporary_mesh_file()
    {
      std::error_code error;
      std::string name = (std::filesystem::temp_directory_path(error) / "lahar-XXXXXX.msh").string();
      const int file   = mkstemps(name.data(), 4);
      if (file < 0)
        throw InputError("The temporary file '" + name +
                         "' for gmsh's mesh cannot be written. Allowed: a "
                         "directory for temporary files (TMPDIR) that can be written.");
      close(file);
      return name;
    }
  } // namespace



  bool GmshModel::is_geometry(const std::string &file_name)
  {
    const std::string ending = ending_of(file_name);
    return ending == ".geo" || ending == ".geo_unrolled" || is_drawing(file_name);
  }



  bool GmshModel::is_drawing(const std::string &file_name)
  {
    return std::set<std::string>{".step", ".stp", ".brep", ".iges", ".igs"}.count(ending_of(file_name)) > 0;
  }



  GmshModel::GmshModel(const std::string &file_name, const unsigned int dimension, const double element_size)
  {
    std::error_code status;
    if (!std::filesystem::is_regular_file(file_name, status))
      throw InputError(
        "Geometry file '" + file_name + "' " +
        (std::filesystem::exists(file_name, status) ? "is no regular file" : "does not exist") +
        ". Allowed: a file of gmsh's (.geo) or of CAD (.step, .brep, .iges).");
    mesh_file_name = temporary_mesh_file();
    const Gmsh gmsh_library;
    std::string reason;
    // Versions of gmsh throw texts, numbers or exceptions.
    try
    {
      gmsh::open(file_name);
      add_groups();
      if (element_size > 0.)
        gmsh::option::setNumber("Mesh.CharacteristicLengthMax", element_size);
      gmsh::model::mesh::generate(dimension);
      gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
      gmsh::option::setNumber("Mesh.Binary", 0);
      gmsh::write(mesh_file_name);
      return;
    }
    catch (const std::string &text)
    {
      reason = gmsh_library.error(text);
    }
    catch (const std::exception &error)
    {
      reason = gmsh_library.error(error.what());
    }
    catch (const int)
    {
      reason = gmsh_library.error("an error without a reason");
    }
    std::filesystem::remove(mesh_file_name, status);
    throw InputError("Geometry file '" + file_name + "' cannot be meshed; gmsh says: " + reason +
                     ". Allowed: what 'gmsh -" + std::to_string(dimension) + " FILE' meshes.");
  }



  GmshModel::~GmshModel()
  {
    std::error_code ignored;
    std::filesystem::remove(mesh_file_name, ignored);
  }
} // namespace Lahar
