#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/line_reader.h>
#include <lahar/utilities/exceptions.h>

#include <cmath>
#include <cstdlib>

namespace Lahar
{
  /**
   * A file is a row of sections "$Name ... $EndName"; unknown ones are skipped. No memory is reserved by a count of the
   * file: each item that a count announces must be found first.
   */
  class GmshFile::Parser
  {
  public:
    explicit Parser(GmshFile &mesh)
      : mesh(mesh)
      , in(mesh.file_name)
    {}

    void parse()
    {
      while (in.advance())
      {
        const std::string name(in.rest());
        if (sections.empty() && name != "$MeshFormat")
          in.fail(in_quotes(name), "$MeshFormat, with which a gmsh file begins");
        if (name[0] != '$' || name.compare(0, 4, "$End") == 0)
          in.fail(in_quotes(name), "the begin of a section, $Name");
        if (name == "$Elements" && sections.count("$Nodes") == 0)
          in.fail(name, "$Nodes before it");
        if (name == "$Entities" && sections.count("$Elements") > 0)
          in.fail(name + " behind $Elements", "$Entities before it");

        const std::string end = "$End" + name.substr(1);
        if (!parse_section(name))
          while (in.rest() != end)
            in.advance_to(end);
        else if (!sections.insert(name).second)
          in.fail("a second section " + name, "one");
        else if (in.advance_to(end); in.rest() != end)
          in.fail(in_quotes(in.rest()), end + ", since the announced number of items is complete");
      }
      for (const std::string name : {"$MeshFormat", "$Nodes", "$Elements"})
        if (sections.count(name) == 0)
          in.fail("the end of the file", "a section " + name + " before it");
    }

  private:
    /// Parse what stands between "$Name" and "$EndName". @return whether the section is of use.
    bool parse_section(const std::string &name)
    {
      if (name == "$MeshFormat")
        parse_format();
      else if (name == "$PhysicalNames")
        parse_names();
      else if (name == "$Entities" && version_4)
        parse_entities();
      else if (name == "$Nodes")
        version_4 ? parse_nodes_4() : parse_nodes_2();
      else if (name == "$Elements")
        version_4 ? parse_elements_4() : parse_elements_2();
      else
        return false;
      return true;
    }

    void parse_format()
    {
      in.advance_to("version, file type and data size");
      const std::string_view version = in.word("the version, 2.2 or 4.1");
      if (version != "2.2" && version != "4.1")
        in.fail("file format " + in_quotes(version), "2.2 and 4.1 (gmsh -format msh22 or msh41)");
      version_4 = version == "4.1";
      if (in.word("the file type, 0") != "0")
        in.fail("a binary file", "ASCII files, of file type 0 (gmsh without -bin)");
      in.count("the data size");
      in.end_line();
    }

    /// A line with nothing but a count or a tag.
    std::size_t parse_single(const std::string_view expected)
    {
      in.advance_to(expected);
      const std::size_t value = in.count(expected);
      in.end_line();
      return value;
    }

    /// A line with nothing but four counts or tags.
    std::array<std::size_t, 4> parse_four(const std::string_view expected)
    {
      std::array<std::size_t, 4> values;
      in.advance_to(expected);
      for (std::size_t &value : values)
        value = in.count(expected);
      in.end_line();
      return values;
    }

    /// Tag of a group; its sign, an orientation, says nothing here.
    long parse_group_tag()
    {
      return std::labs(in.number<int>("the tag of a physical group"));
    }

    void parse_names()
    {
      const std::size_t n_names = parse_single("the number of physical names");
      for (std::size_t i = 0; i < n_names; ++i)
      {
        in.advance_to("a physical group: dimension tag \"name\"");
        const auto dimension        = in.number<unsigned int>("the dimension of a physical group");
        const long tag              = parse_group_tag();
        const std::string_view name = in.rest();
        if (name.size() < 3 || name.front() != '"' || name.back() != '"')
          in.fail(in_quotes(name), "the name of a physical group in double quotes");
        if (!mesh.groups.insert({{dimension, std::string(name.substr(1, name.size() - 2))}, tag}).second)
          in.fail(in_quotes(name) + " a second time", "different names in a dimension");
      }
    }

    void parse_entities()
    {
      const auto n_entities = parse_four("the numbers of points, curves, surfaces and volumes");
      for (unsigned int dimension = 0; dimension < 4; ++dimension)
        for (std::size_t i = 0; i < n_entities[dimension]; ++i)
        {
          in.advance_to("an entity of dimension " + std::to_string(dimension));
          std::set<long> &groups = entity_groups[{dimension, in.number<int>("the tag of an entity")}];
          for (unsigned int d = 0; d < (dimension == 0 ? 3 : 6); ++d)
            in.word("the point or the bounding box of an entity");
          const std::size_t n_groups = in.count("the number of physical groups of an entity");
          for (std::size_t j = 0; j < n_groups; ++j)
            groups.insert(parse_group_tag());
        }
    }

    void parse_nodes_2()
    {
      const std::size_t n_nodes = parse_single("the number of nodes");
      for (std::size_t i = 0; i < n_nodes; ++i)
      {
        in.advance_to("a node: tag x y z");
        parse_node(in.count("the tag of a node"));
        in.end_line();
      }
    }

    void parse_nodes_4()
    {
      const auto [n_blocks, n_nodes, first, last] = parse_four("numbers of blocks and nodes, range of tags");
      for (std::size_t block = 0; block < n_blocks; ++block)
      {
        in.advance_to("a block of nodes: dimension entity parametric n_nodes");
        in.number<unsigned int>("the dimension of an entity");
        in.number<int>("the tag of an entity");
        in.number<unsigned int>("whether there are parametric coordinates");
        const std::size_t n_in_block = in.count("the number of nodes in the block");
        in.end_line();

        std::vector<std::size_t> tags;
        for (std::size_t i = 0; i < n_in_block; ++i)
          tags.push_back(parse_single("the tag of a node"));
        for (const std::size_t tag : tags)
        {
          in.advance_to("a node: x y z");
          parse_node(tag); // parametric coordinates may follow
        }
      }
      if (mesh.nodes.size() != n_nodes)
        in.fail(std::to_string(mesh.nodes.size()) + " nodes up to here",
                std::to_string(n_nodes) + ", as announced");
    }

    void parse_node(const std::size_t tag)
    {
      const double x = in.number<double>("x of a node");
      const double y = in.number<double>("y of a node");
      if (in.number<double>("z of a node") != 0.)
        in.fail("node " + std::to_string(tag) + " with z different from 0", "z = 0 (plane mesh expected)");
      if (!mesh.nodes.insert({tag, Point<2>(x, y)}).second)
        in.fail("node " + std::to_string(tag) + " a second time", "different tags");
    }

    void parse_elements_2()
    {
      const std::size_t n_elements = parse_single("the number of elements");
      for (std::size_t i = 0; i < n_elements; ++i)
      {
        in.advance_to("an element: tag type n_tags tags nodes");
        in.count("the tag of an element");
        const auto type          = in.number<unsigned int>("the type of an element");
        const std::size_t n_tags = in.count("the number of tags of an element");
        check_type(type);
        std::set<long> groups;
        if (n_tags > 0)
          groups.insert(parse_group_tag());
        for (std::size_t j = 1; j < n_tags; ++j)
          in.number<int>("a tag of an element");
        parse_element(type, groups);
      }
    }

    void parse_elements_4()
    {
      const auto [n_blocks, n_elements, first,
                  last]   = parse_four("numbers of blocks and elements, range of tags");
      std::size_t n_found = 0;
      for (std::size_t block = 0; block < n_blocks; ++block)
      {
        in.advance_to("a block of elements: dimension entity type n_elements");
        const auto dimension         = in.number<unsigned int>("the dimension of an entity");
        const int entity             = in.number<int>("the tag of an entity");
        const auto type              = in.number<unsigned int>("the type of the elements");
        const std::size_t n_in_block = in.count("the number of elements in the block");
        in.end_line();
        check_type(type);
        if (dimension != (type == 15 ? 0 : type == 1 ? 1 : 2))
          in.fail("elements of type " + std::to_string(type) + " in dimension " + std::to_string(dimension),
                  "the dimension of the type");
        if (sections.count("$Entities") > 0 && entity_groups.count({dimension, entity}) == 0)
          in.fail("entity " + std::to_string(entity) + " of dimension " + std::to_string(dimension),
                  "those in $Entities (a mesh that is not partitioned)");

        const std::set<long> groups = entity_groups[{dimension, entity}];
        for (std::size_t i = 0; i < n_in_block; ++i, ++n_found)
        {
          in.advance_to("an element: tag nodes");
          in.count("the tag of an element");
          parse_element(type, groups);
        }
      }
      if (n_found != n_elements)
        in.fail(std::to_string(n_found) + " elements up to here",
                std::to_string(n_elements) + ", as announced");
    }

    void check_type(const unsigned int type) const
    {
      if (type != 15 && (type < 1 || type > 3))
        in.fail("an element of type " + std::to_string(type),
                "1 (line of two nodes), 2 (triangle of three), 3 (quadrilateral of four) and 15 (point)");
    }

    /// The nodes of an element, with which its line ends.
    void parse_element(const unsigned int type, const std::set<long> &groups)
    {
      std::array<std::size_t, 4> tags;
      const unsigned int n_nodes = type == 15 ? 1 : type + 1;
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        tags[i] = in.count("the tag of a node of the element");
        if (mesh.nodes.count(tags[i]) == 0)
          in.fail("an element with node " + std::to_string(tags[i]), "the tags of $Nodes");
      }
      in.end_line();

      if (type == 1 && mesh.nodes.at(tags[0]) == mesh.nodes.at(tags[1]))
        in.fail("a line without length", "lines between different points");
      for (const long group : groups)
        if (type == 1)
          mesh.curve_edges[group].push_back({{tags[0], tags[1]}});
        else if (type != 15)
        {
          mesh.surface_nodes[group].insert(tags.begin(), tags.begin() + n_nodes);
          for (unsigned int i = 2; i < n_nodes; ++i)
            mesh.surface_triangles[group].push_back({{tags[0], tags[i - 1], tags[i]}});
        }
    }

    GmshFile &mesh;
    LineReader in;
    bool version_4 = false;
    std::set<std::string> sections;                                       ///< parsed so far
    std::map<std::pair<unsigned int, int>, std::set<long>> entity_groups; ///< by dimension and entity tag
  };


  GmshFile::GmshFile(const std::string &file_name)
    : file_name(file_name)
  {
    Parser(*this).parse();
  }


  long GmshFile::find_group(const unsigned int dimension, const std::string &group) const
  {
    const std::string kind = dimension == 1 ? "physical curve" : "physical surface";
    const auto found       = groups.find({dimension, group});
    if (found == groups.end())
    {
      std::string names;
      for (const auto &entry : groups)
        if (entry.first.first == dimension)
          names += (names.empty() ? "'" : ", '") + entry.first.second + "'";
      throw InputError(file_name + " has no " + kind + " '" + group +
                       "'. Allowed: " + (names.empty() ? "none, the file names no " + kind : names) + ".");
    }
    if (dimension == 1 ? curve_edges.count(found->second) == 0 : surface_nodes.count(found->second) == 0)
      throw InputError(
        file_name + ": the " + kind + " '" + group +
        "' has no elements. Allowed: a group that is meshed (gmsh -2; in format 2.2 without Mesh.SaveAll).");
    return found->second;
  }


  std::vector<Point<2>> GmshFile::nodes_of_surface(const std::string &group) const
  {
    std::vector<Point<2>> result;
    for (const std::size_t tag : surface_nodes.at(find_group(2, group)))
      result.push_back(nodes.at(tag));
    return result;
  }


  void GmshFile::triangles_of_surface(const std::string &group, std::vector<Point<2>> &points,
                                      std::vector<std::array<unsigned int, 3>> &triangles) const
  {
    const long tag = find_group(2, group);
    std::map<std::size_t, unsigned int> numbers;
    points.clear();
    triangles.clear();
    for (const std::size_t node : surface_nodes.at(tag))
    {
      numbers[node] = points.size();
      points.push_back(nodes.at(node));
    }
    for (const auto &corners : surface_triangles.at(tag))
    {
      triangles.push_back({{numbers.at(corners[0]), numbers.at(corners[1]), numbers.at(corners[2])}});
      const Point<2> &a     = nodes.at(corners[0]);
      const Tensor<1, 2> ab = nodes.at(corners[1]) - a, ac = nodes.at(corners[2]) - a;
      const double twice_area = std::abs(cross_product_2d(ab) * ac);
      if (!(twice_area > 1e-12 * (ab.norm_square() + ac.norm_square())))
        throw InputError(file_name + ": the triangle of the nodes " + std::to_string(corners[0]) + ", " +
                         std::to_string(corners[1]) + " and " + std::to_string(corners[2]) +
                         " has no area. Allowed: triangles with an area.");
    }
  }


  std::vector<std::array<Point<2>, 2>> GmshFile::edges_of_curve(const std::string &group) const
  {
    std::vector<std::array<Point<2>, 2>> result;
    for (const auto &edge : curve_edges.at(find_group(1, group)))
      result.push_back({{nodes.at(edge[0]), nodes.at(edge[1])}});
    return result;
  }
} // namespace Lahar
