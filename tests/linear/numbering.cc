// SPDX-License-Identifier: GPL-3.0-or-later

// Test that numbers of different kinds cannot be mixed up, and the numbering of a strip of triangles with a solid behind
// it, on several ranks too: numbers lead there and back, and values pass from vertices to nodes and back.

#include <lahar/linear/numbering.h>

#include <algorithm>
#include <type_traits>

#include "tests.h"

using namespace Tests;

template <typename V, typename I, typename = void>
struct IsIndexedBy : std::false_type
{};

template <typename V, typename I>
struct IsIndexedBy<V, I, std::void_t<decltype(std::declval<V>()[std::declval<I>()])>> : std::true_type
{};

static_assert(!std::is_convertible_v<unsigned int, Vertex> && !std::is_convertible_v<Vertex, unsigned int>);
static_assert(!std::is_convertible_v<Vertex, LocalNode> && !std::is_constructible_v<Vertex, LocalNode>);
static_assert(IsIndexedBy<IndexVector<Vertex, double>, Vertex>::value);
static_assert(!IsIndexedBy<IndexVector<Vertex, double>, LocalNode>::value);
static_assert(!IsIndexedBy<IndexVector<Vertex, double>, unsigned int>::value);
static_assert(sizeof(Vertex) == sizeof(unsigned int) && std::is_trivially_copyable_v<Vertex>);

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check("an index of nothing", !Vertex().is_valid() && Vertex(3).is_valid() && Vertex(3).value() == 3);
  std::vector<unsigned int> run;
  for (const Vertex v : IndexRange<Vertex>(3))
    run.push_back(v.value());
  check("a range", run == std::vector<unsigned int>({0, 1, 2}));
  IndexVector<Vertex, bool> flags(2, false);
  flags[Vertex(1)] = true;
  check("a vector of flags", !flags[Vertex(0)] && flags[Vertex(1)]);

  // The strip has the vertices 0 to 59. The solid has 8 nodes, a strip too, of which the first four are the last vertices
  // and the others its own.
  constexpr unsigned int n_vertices = 60, n_own_solid_nodes = 4, n_nodes = n_vertices + n_own_solid_nodes;
  std::vector<unsigned int> fluid_cells, solid_cells;
  for (unsigned int i = 0; i + 2 < n_vertices; ++i)
    fluid_cells.insert(fluid_cells.end(), {i, i + 1, i + 2});
  IndexVector<SolidNode, RegionNode> solids;
  for (unsigned int i = n_vertices - 4; i < n_nodes; ++i)
    solids.push_back(RegionNode(i));
  for (unsigned int i = 0; i + 2 < solids.size(); ++i)
    for (unsigned int k = 0; k < 3; ++k)
      solid_cells.push_back(solids[SolidNode(i + k)].value());
  NodePartition partition(MPI_COMM_WORLD);
  partition.reinit(n_nodes, {{fluid_cells.data(), static_cast<unsigned int>(fluid_cells.size() / 3), 3},
                             {solid_cells.data(), static_cast<unsigned int>(solid_cells.size() / 3), 3}});
  Numbering numbering;
  numbering.reinit(partition, n_vertices, solids);

  check("all own nodes together", Utilities::MPI::sum(partition.n_own(), MPI_COMM_WORLD) == n_nodes);
  check("all own vertices together",
        Utilities::MPI::sum(numbering.n_own_vertices(), MPI_COMM_WORLD) == n_vertices);
  bool there_and_back = true, vertices_match = true, own_first = true;
  unsigned int n_vertex_nodes = 0;
  for (const LocalNode node : numbering.nodes())
  {
    there_and_back = there_and_back && numbering.node(numbering.region_node(node)) == node;
    vertices_match = vertices_match &&
                     numbering.is_vertex(node) == (numbering.region_node(node).value() < n_vertices);
    own_first = own_first && numbering.is_own(node) == (node < LocalNode(partition.n_own()));
    n_vertex_nodes += numbering.is_vertex(node);
  }
  check("from a node to the region's and back", there_and_back);
  check("which nodes are vertices", vertices_match && n_vertex_nodes == numbering.n_vertices());
  check("own nodes come first", own_first);
  bool by_vertex = true;
  for (const Vertex v : numbering.vertices())
    by_vertex = by_vertex && numbering.node(numbering.region_vertex(v)) == numbering.node(v);
  check("from a vertex to the region's and back", by_vertex);
  unsigned int n_unknown = 0;
  for (unsigned int i = 0; i < n_nodes; ++i)
    n_unknown += !numbering.node(RegionNode(i)).is_valid();
  check("a node that the rank does not know has no number here", n_unknown + numbering.n_nodes() == n_nodes);

  bool of_solid = true;
  for (const auto &[node, i] : numbering.solid_nodes())
    of_solid = of_solid && numbering.region_node(node) == solids[i];
  const unsigned int n_own_solid = std::count_if(numbering.solid_nodes().begin(),
                                                 numbering.solid_nodes().end(), [&](const auto &pair) {
                                                   return numbering.is_own(pair.first);
                                                 });
  check("the solid's nodes are the region's", of_solid);
  check("each of them belongs to one rank",
        Utilities::MPI::sum(n_own_solid, MPI_COMM_WORLD) == solids.size());

  // Each node has one global number: the ranks' own ones add up to 0 + 1 + ….
  unsigned int sum = 0;
  for (const LocalNode node : numbering.own_nodes())
    sum += numbering.global_node(node).value();
  check("global numbers", Utilities::MPI::sum(sum, MPI_COMM_WORLD) == n_nodes * (n_nodes - 1) / 2);

  IndexVector<Vertex, double> values(numbering.n_vertices());
  for (const Vertex v : numbering.vertices())
    values[v] = 1. + numbering.region_vertex(v).value();
  const IndexVector<LocalNode, double> of_nodes = numbering.by_node(values);
  bool spread                                   = true;
  for (const LocalNode node : numbering.nodes())
    spread = spread &&
             of_nodes[node] == (numbering.is_vertex(node) ? 1. + numbering.region_node(node).value() : 0.);
  check("values of vertices as those of nodes", spread);
  check("and back", numbering.by_vertex(of_nodes) == values);
  return n_failed > 0;
}
