// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/gmsh_input.h>
#include <lahar/geometry/gmsh_model.h>
#include <lahar/utilities/assignment.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace Lahar
{
  namespace
  {
    /// A kind of element of gmsh's that can be read; its corners come first among its nodes.
    struct ElementType
    {
      unsigned int number, dimension, n_corners, n_nodes;
    };

    constexpr std::array<ElementType, 10> element_types = {{{15, 0, 1, 1},
                                                            {1, 1, 2, 2},
                                                            {8, 1, 2, 3},
                                                            {2, 2, 3, 3},
                                                            {9, 2, 3, 6},
                                                            {3, 2, 4, 4},
                                                            {10, 2, 4, 9},
                                                            {16, 2, 4, 8},
                                                            {4, 3, 4, 4},
                                                            {11, 3, 4, 10}}};
  } // namespace



  /**
   * A file is a row of sections "$Name ... $EndName"; unknown ones are skipped. In a binary file the sections
   * $Entities, $Nodes and $Elements are binary (in format 2: behind their count). No memory is reserved by a count of
   * the file: each item that a count announces must be found first.
   */
  template <int dim>
  class GmshFile<dim>::Parser
  {
  public:
    Parser(GmshFile &mesh, const std::string &mesh_file, const double scale)
      : mesh(mesh)
      , scale(scale)
      , in(mesh_file)
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
        in.read_format();
      else if (name == "$PhysicalNames")
        parse_names();
      else if ((name == "$Entities" && in.version() >= 40) || name == "$Nodes" || name == "$Elements")
      {
        in.set_binary(in.is_binary_file() && in.version() >= 40);
        if (name == "$Entities")
          parse_entities();
        else if (name == "$Nodes")
          in.version() >= 40 ? parse_nodes_4() : parse_nodes_2();
        else
          in.version() >= 40 ? parse_elements_4() : parse_elements_2();
        in.set_binary(false);
      }
      else
        return false;
      return true;
    }

    /// Dimension and tag of the entity of a block; format 4.0 has the tag first.
    std::pair<unsigned int, int> parse_entity_of_block()
    {
      std::pair<unsigned int, int> entity;
      if (in.version() == 40)
        entity.second = in.number<int>("the tag of an entity");
      entity.first = in.number<unsigned int>("the dimension of an entity");
      if (in.version() == 41)
        entity.second = in.number<int>("the tag of an entity");
      return entity;
    }

    /// Numbers of blocks and of items; format 4.1 has the range of tags behind them.
    std::array<std::size_t, 2> parse_block_counts(const std::string_view expected)
    {
      if (in.version() == 40)
        return in.counts<2>(expected);
      const auto values = in.counts<4>(expected);
      return {{values[0], values[1]}};
    }

    /// Tag of a group; its sign, an orientation, says nothing here.
    long parse_group_tag()
    {
      return std::labs(in.number<int>("the tag of a physical group"));
    }

    void parse_names()
    {
      const std::size_t n_names = in.counts<1>("the number of physical names")[0];
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
      const auto n_entities = in.counts<4>("the numbers of points, curves, surfaces and volumes");
      for (unsigned int dimension = 0; dimension < 4; ++dimension)
        for (std::size_t i = 0; i < n_entities[dimension]; ++i)
        {
          in.advance_to("an entity of dimension " + std::to_string(dimension));
          std::set<long> &groups = entity_groups[{dimension, in.number<int>("the tag of an entity")}];
          for (unsigned int d = 0; d < (dimension == 0 && in.version() == 41 ? 3 : 6); ++d)
            in.skip<double>("the point or the bounding box of an entity");
          const std::size_t n_groups = in.number<std::size_t>("the number of physical groups of an entity");
          for (std::size_t j = 0; j < n_groups; ++j)
            groups.insert(parse_group_tag());
          if (in.is_binary_file() && dimension > 0)
          {
            const std::size_t n_bounding = in.number<std::size_t>("the number of bounding entities");
            for (std::size_t j = 0; j < n_bounding; ++j)
              in.skip<int>("the tag of a bounding entity");
          }
        }
    }

    void parse_nodes_2()
    {
      const std::size_t n_nodes = in.counts<1>("the number of nodes")[0];
      in.set_binary(in.is_binary_file());
      for (std::size_t i = 0; i < n_nodes; ++i)
      {
        in.advance_to("a node: tag x y z");
        parse_node(in.tag("the tag of a node"));
        in.end_line();
      }
    }

    void parse_nodes_4()
    {
      const auto [n_blocks, n_nodes] = parse_block_counts("numbers of blocks and nodes, range of tags");
      for (std::size_t block = 0; block < n_blocks; ++block)
      {
        in.advance_to("a block of nodes: dimension entity parametric n_nodes");
        const unsigned int dimension = parse_entity_of_block().first;
        const bool is_parametric = in.number<unsigned int>("whether there are parametric coordinates") > 0;
        const std::size_t n_in_block = in.number<std::size_t>("the number of nodes in the block");
        in.end_line();

        std::vector<std::size_t> tags;
        if (in.version() == 41)
          for (std::size_t i = 0; i < n_in_block; ++i)
            tags.push_back(in.counts<1>("the tag of a node")[0]);
        for (std::size_t i = 0; i < n_in_block; ++i)
        {
          in.advance_to("a node: x y z");
          parse_node(in.version() == 41 ? tags[i] : in.tag("the tag of a node"));
          if (is_parametric && in.is_binary_file())
            for (unsigned int d = 0; d < dimension; ++d)
              in.skip<double>("a parametric coordinate");
        }
      }
      if (mesh.nodes.size() != n_nodes)
        in.fail(std::to_string(mesh.nodes.size()) + " nodes up to here",
                std::to_string(n_nodes) + ", as announced");
    }

    void parse_node(const std::size_t tag)
    {
      Point<dim> node;
      node[0]        = scale * in.number<double>("x of a node");
      node[1]        = scale * in.number<double>("y of a node");
      const double z = scale * in.number<double>("z of a node");
      if constexpr (dim == 3)
        node[2] = z;
      if (dim == 2 && z != 0.)
        in.fail("node " + std::to_string(tag) + " with z different from 0",
                "z = 0 (a mesh of the plane, since 'Dimension' is 2)");
      if (!std::isfinite(node.norm_square()))
        in.fail("node " + std::to_string(tag) + " too far away", "coordinates of reasonable size");
      mesh.is_flat = mesh.is_flat && z == 0.;
      if (!mesh.nodes.insert({tag, node}).second)
        in.fail("node " + std::to_string(tag) + " a second time", "different tags");
    }

    void parse_elements_2()
    {
      const std::size_t n_elements = in.counts<1>("the number of elements")[0];
      in.set_binary(in.is_binary_file());
      // In a binary file elements of a kind come in blocks, whose type and number of tags stand before them.
      for (std::size_t i = 0; i < n_elements;)
      {
        in.advance_to("an element: tag type n_tags tags nodes");
        if (!in.is_binary_file())
          in.tag("the tag of an element");
        const auto type              = in.number<unsigned int>("the type of an element");
        const std::size_t n_in_block = in.is_binary_file()
                                         ? in.number<unsigned int>("the number of elements in the block")
                                         : 1;
        const auto n_tags            = in.number<unsigned int>("the number of tags of an element");
        const ElementType &element   = find_type(type);
        if (n_in_block == 0 || n_in_block > n_elements - i)
          in.fail("a block of " + std::to_string(n_in_block) + " elements",
                  "1 to " + std::to_string(n_elements - i));
        for (std::size_t j = 0; j < n_in_block; ++j, ++i)
        {
          if (in.is_binary_file())
            in.tag("the tag of an element");
          std::set<long> groups;
          for (unsigned int t = 0; t < n_tags; ++t)
            if (t > 0)
              in.skip<int>("a tag of an element");
            else if (const long group = parse_group_tag(); group != 0) // 0: in no group
              groups.insert(group);
          parse_element(element, groups);
        }
      }
    }

    void parse_elements_4()
    {
      const auto [n_blocks, n_elements] = parse_block_counts("numbers of blocks and elements, range of tags");
      std::size_t n_found               = 0;
      for (std::size_t block = 0; block < n_blocks; ++block)
      {
        in.advance_to("a block of elements: dimension entity type n_elements");
        const auto entity            = parse_entity_of_block();
        const auto type              = in.number<unsigned int>("the type of the elements");
        const std::size_t n_in_block = in.number<std::size_t>("the number of elements in the block");
        in.end_line();
        const ElementType &element = find_type(type);
        if (entity.first != element.dimension)
          in.fail("elements of type " + std::to_string(type) + " in dimension " +
                    std::to_string(entity.first),
                  "the dimension of the type");
        if (sections.count("$Entities") > 0 && entity_groups.count(entity) == 0)
          in.fail("entity " + std::to_string(entity.second) + " of dimension " + std::to_string(entity.first),
                  "those in $Entities (a mesh that is not partitioned)");

        const std::set<long> groups = entity_groups[entity];
        for (std::size_t i = 0; i < n_in_block; ++i, ++n_found)
        {
          in.advance_to("an element: tag nodes");
          in.tag("the tag of an element");
          parse_element(element, groups);
        }
      }
      if (n_found != n_elements)
        in.fail(std::to_string(n_found) + " elements up to here",
                std::to_string(n_elements) + ", as announced");
    }

    const ElementType &find_type(const unsigned int number) const
    {
      const auto type = std::find_if(element_types.begin(), element_types.end(), [&](const ElementType &t) {
        return t.number == number && t.dimension <= dim;
      });
      if (type == element_types.end())
        in.fail("an element of type " + std::to_string(number),
                std::string("lines (1, 8), triangles (2, 9), quadrilaterals (3, 10, 16)") +
                  (dim == 3 ? ", tetrahedra (4, 11)" : "") + " of first and second order and points (15)" +
                  (number == 4 || number == 11 ? ", since 'Dimension' is 2" : ""));
      return *type;
    }

    /// The nodes of an element, with which its line ends. Those beside the corners are passed over.
    void parse_element(const ElementType &type, const std::set<long> &groups)
    {
      std::array<std::size_t, 4> tags;
      for (unsigned int i = 0; i < type.n_nodes; ++i)
      {
        const std::size_t tag = in.tag("the tag of a node of the element");
        if (mesh.nodes.count(tag) == 0)
          in.fail("an element with node " + std::to_string(tag), "the tags of $Nodes");
        if (i < type.n_corners)
          tags[i] = tag;
      }
      in.end_line();

      for (unsigned int i = type.dimension; i < type.n_corners; ++i) // a quadrilateral is two triangles
      {
        std::array<std::size_t, 4> simplex = tags;
        if (type.dimension == 2)
          simplex = {{tags[0], tags[i - 1], tags[i], 0}};
        if (type.dimension == dim - 1)
          add_facet(simplex, groups);
        else if (type.dimension == dim)
          for (const long group : groups)
            std::copy_n(simplex.begin(), dim + 1, mesh.cells[group].emplace_back().begin());
      }
    }

    void add_facet(const std::array<std::size_t, 4> &tags, const std::set<long> &groups)
    {
      std::array<Point<dim>, dim> facet;
      for (unsigned int i = 0; i < dim; ++i)
        facet[i] = mesh.nodes.at(tags[i]);
      const Tensor<1, dim> ab = facet[1] - facet[0], ac = facet[dim - 1] - facet[0];
      if (dim == 2 && ab.norm() == 0.)
        in.fail("a line without length", "lines between different points");
      if constexpr (dim == 3)
        if (!(cross_product_3d(ab, ac).norm() > 4e-6 * (ab.norm_square() + ac.norm_square())))
          in.fail("a triangle without area", "triangles with an area");
      for (const long group : groups)
        mesh.facets[group].push_back(facet);
    }

    GmshFile &mesh;
    double scale;
    GmshInput in;
    std::set<std::string> sections;                                       ///< parsed so far
    std::map<std::pair<unsigned int, int>, std::set<long>> entity_groups; ///< by dimension and entity tag
  };



  template <int dim>
  GmshFile<dim>::GmshFile(const std::string &file_name, const double scale, const double element_size)
    : file_name(file_name)
  {
    if (!GmshModel::is_geometry(file_name))
    {
      Parser(*this, file_name, scale).parse();
      return;
    }
    const GmshModel model(file_name, dim, element_size / scale);
    try
    {
      Parser(*this, model.mesh_file(), scale).parse();
    }
    catch (const InputError &error)
    {
      throw InputError("The mesh that gmsh makes of '" + file_name + "' cannot be used: " + error.what());
    }
  }



  template GmshFile<2>::GmshFile(const std::string &, const double, const double);
  template GmshFile<3>::GmshFile(const std::string &, const double, const double);
} // namespace Lahar
