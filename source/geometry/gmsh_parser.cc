// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/line_reader.h>

#include <algorithm>
#include <cstdlib>

namespace Lahar
{
  namespace
  {
    /// A kind of element of gmsh's that can be read.
    struct ElementType
    {
      unsigned int number, dimension, n_nodes;
    };

    constexpr std::array<ElementType, 5> element_types = {
      {{15, 0, 1}, {1, 1, 2}, {2, 2, 3}, {3, 2, 4}, {4, 3, 4}}};
  } // namespace



  /**
   * A file is a row of sections "$Name ... $EndName"; unknown ones are skipped. No memory is reserved by a count of the
   * file: each item that a count announces must be found first.
   */
  template <int dim>
  class GmshFile<dim>::Parser
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
      Point<dim> node;
      node[0]        = in.number<double>("x of a node");
      node[1]        = in.number<double>("y of a node");
      const double z = in.number<double>("z of a node");
      if constexpr (dim == 3)
        node[2] = z;
      if (dim == 2 && z != 0.)
        in.fail("node " + std::to_string(tag) + " with z different from 0",
                "z = 0 (a mesh of the plane, since 'Dimension' is 2)");
      mesh.is_flat = mesh.is_flat && z == 0.;
      if (!mesh.nodes.insert({tag, node}).second)
        in.fail("node " + std::to_string(tag) + " a second time", "different tags");
    }

    void parse_elements_2()
    {
      const std::size_t n_elements = parse_single("the number of elements");
      for (std::size_t i = 0; i < n_elements; ++i)
      {
        in.advance_to("an element: tag type n_tags tags nodes");
        in.count("the tag of an element");
        const auto type            = in.number<unsigned int>("the type of an element");
        const std::size_t n_tags   = in.count("the number of tags of an element");
        const ElementType &element = find_type(type);
        std::set<long> groups;
        if (n_tags > 0)
          groups.insert(parse_group_tag());
        for (std::size_t j = 1; j < n_tags; ++j)
          in.number<int>("a tag of an element");
        parse_element(element, groups);
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
        const ElementType &element = find_type(type);
        if (dimension != element.dimension)
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
                std::string("1 (line of two nodes), 2 (triangle of three), 3 (quadrilateral of four)") +
                  (dim == 3 ? ", 4 (tetrahedron of four)" : "") + " and 15 (point)" +
                  (number == 4 ? ", since 'Dimension' is 2" : ""));
      return *type;
    }

    /// The nodes of an element, with which its line ends.
    void parse_element(const ElementType &type, const std::set<long> &groups)
    {
      std::array<std::size_t, 4> tags;
      for (unsigned int i = 0; i < type.n_nodes; ++i)
      {
        tags[i] = in.count("the tag of a node of the element");
        if (mesh.nodes.count(tags[i]) == 0)
          in.fail("an element with node " + std::to_string(tags[i]), "the tags of $Nodes");
      }
      in.end_line();

      for (unsigned int i = type.dimension; i < type.n_nodes; ++i) // a quadrilateral is two triangles
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
    LineReader in;
    bool version_4 = false;
    std::set<std::string> sections;                                       ///< parsed so far
    std::map<std::pair<unsigned int, int>, std::set<long>> entity_groups; ///< by dimension and entity tag
  };



  template <int dim>
  GmshFile<dim>::GmshFile(const std::string &file_name)
    : file_name(file_name)
  {
    Parser(*this).parse();
  }



  template GmshFile<2>::GmshFile(const std::string &);
  template GmshFile<3>::GmshFile(const std::string &);
} // namespace Lahar
