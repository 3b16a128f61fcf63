// SPDX-License-Identifier: GPL-3.0-or-later

// Test how nodes are shared out: what a rank knows are its own nodes, the halo and the outer nodes as the definitions say,
// local and global numbers are in the promised order, and updating brings the owners' values to all copies; in 2D and 3D,
// with two lists of cells, where ranks have heard of all nodes and where they have not, on one rank and on several.

#include <lahar/geometry/delaunay.h>
#include <lahar/linear/node_partition.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>

#include "tests.h"

using namespace Tests;

/// Owners by position, slabs of equal width, or by number.
template <int dim>
std::vector<unsigned int> find_owners(const std::vector<Point<dim>> &points, const bool by_position)
{
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  std::vector<unsigned int> owners;
  for (unsigned int i = 0; i < points.size(); ++i)
    owners.push_back(by_position ? std::min<unsigned int>(0.5 * (points[i][0] + 1.) * n_ranks, n_ranks - 1)
                                 : i * n_ranks / points.size());
  return owners;
}

template <int dim>
void test(const unsigned int n_points, const bool by_position)
{
  const std::string name = Utilities::int_to_string(dim) + "D, " +
                           (by_position ? "by position: " : "by number: ");
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  Random random;
  std::vector<Point<dim>> points;
  for (unsigned int i = 0; i < n_points; ++i)
    points.push_back(Point<dim>(random.vector<dim>()));
  const std::vector<unsigned int> all_owners = find_owners<dim>(points, by_position);

  // Two lists: every third simplex is in the second one.
  std::vector<Simplex<dim>> cells[2];
  unsigned int n_all = 0;
  for (const Simplex<dim> &simplex : delaunay(points))
    cells[n_all++ % 3 == 0].push_back(simplex);

  // What the definitions say, by hand.
  std::set<unsigned int> own, with_halo, known, heard;
  for (unsigned int i = 0; i < n_points; ++i)
    if (all_owners[i] == rank)
      own.insert(i);
  const auto grow = [&](const std::set<unsigned int> &nodes) {
    std::set<unsigned int> grown = nodes;
    for (const auto &list : cells)
      for (const Simplex<dim> &cell : list)
        if (std::any_of(cell.begin(), cell.end(),
                        [&](const unsigned int node) { return nodes.count(node) > 0; }))
          grown.insert(cell.begin(), cell.end());
    return grown;
  };
  with_halo = grow(own);
  known     = grow(with_halo);

  // By position a rank has heard of one layer more than it needs, under numbers of its own; else of all nodes.
  heard = grow(known);
  std::vector<unsigned int> number_here(n_points, numbers::invalid_unsigned_int), number_of, owners;
  std::vector<std::uint64_t> keys;
  for (unsigned int i = 0; i < n_points; ++i)
    if (!by_position || heard.count(i) > 0)
    {
      number_here[i] = number_of.size();
      number_of.push_back(i);
      owners.push_back(all_owners[i]);
      keys.push_back(1000 + 3 * i);
    }
  std::vector<Simplex<dim>> cells_here[2];
  for (unsigned int k = 0; k < 2; ++k)
    for (const Simplex<dim> &cell : cells[k])
    {
      Simplex<dim> here;
      for (unsigned int c = 0; c <= dim; ++c)
        here[c] = number_here[cell[c]];
      if (*std::max_element(here.begin(), here.end()) < number_of.size())
        cells_here[k].push_back(here);
    }
  std::vector<CellList> lists;
  for (const auto &list : cells_here)
    lists.push_back({list.front().data(), static_cast<unsigned int>(list.size()), dim + 1});

  NodePartition partition(MPI_COMM_WORLD);
  if (by_position)
    partition.reinit(owners, keys, lists);
  else
    partition.reinit(n_points, lists);
  std::vector<unsigned int> nodes; // by the numbers that the test has
  for (const RegionNode node : partition.nodes())
    nodes.push_back(number_of[node.value()]);

  check(name + "own nodes, ascending",
        std::vector<unsigned int>(own.begin(), own.end()) ==
          std::vector<unsigned int>(nodes.begin(), nodes.begin() + partition.n_own()));
  check(name + "all nodes", partition.n_nodes() == n_points);
  bool found = true;
  for (const LocalNode l : partition.nodes().indices())
    found = found && partition.local(partition.nodes()[l]) == l;
  check(name + "local numbers", found);
  const auto by_owner = [&](const unsigned int i, const unsigned int j) {
    return std::make_pair(all_owners[i], i) < std::make_pair(all_owners[j], j);
  };
  check(name + "halo by owner and number",
        std::is_sorted(nodes.begin() + partition.n_own(), nodes.begin() + partition.n_with_rows(), by_owner));
  check(name + "halo",
        with_halo == std::set<unsigned int>(nodes.begin(), nodes.begin() + partition.n_with_rows()));
  check(name + "known nodes", known == std::set<unsigned int>(nodes.begin(), nodes.end()));

  bool cells_agree = true;
  for (unsigned int k = 0; k < 2; ++k)
  {
    std::vector<unsigned int> expected;
    for (unsigned int c = 0; c < cells_here[k].size(); ++c)
      if (std::any_of(cells_here[k][c].begin(), cells_here[k][c].end(),
                      [&](const unsigned int node) { return with_halo.count(number_of[node]) > 0; }))
        expected.push_back(c);
    cells_agree                           = cells_agree && expected == partition.cells(k);
    const std::vector<unsigned int> local = partition.local_cells(k, lists[k]);
    for (unsigned int i = 0; i < local.size(); ++i)
      cells_agree = cells_agree && partition.nodes()[LocalNode(local[i])].value() ==
                                     cells_here[k][expected[i / (dim + 1)]][i % (dim + 1)];
  }
  check(name + "known cells", cells_agree);

  // Global numbers: rank after rank, each in the order of its numbers; also where only some nodes count.
  std::vector<unsigned int> order(n_points);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), by_owner);
  std::vector<unsigned int> global(n_points), count(n_points);
  for (unsigned int k = 0, n = 0; k < n_points; ++k)
  {
    global[order[k]] = k;
    count[order[k]]  = n;
    n += order[k] % 5 == 0;
  }
  IndexVector<LocalNode, bool> marked;
  for (const unsigned int i : nodes)
    marked.push_back(i % 5 == 0);
  const IndexVector<LocalNode, unsigned int> counted = partition.count_before(marked);
  bool numbered = true, right_count = true;
  for (const LocalNode l : counted.indices())
  {
    numbered    = numbered && partition.global_numbers()[l].value() == global[nodes[l.value()]];
    right_count = right_count && counted[l] == count[nodes[l.value()]];
  }
  check(name + "global numbers", numbered);
  check(name + "count of marked nodes", right_count);

  // The owners' values of two numbers a node arrive at all ranks that know the node.
  IndexVector<LocalNode, std::array<double, 2>> copies(nodes.size(), {{-1., -1.}});
  for (const LocalNode l : partition.own_nodes())
    copies[l] = {{10. * nodes[l.value()], 10. * nodes[l.value()] + 1.}};
  partition.update(copies);
  bool updated = true;
  for (const LocalNode l : copies.indices())
    updated = updated && copies[l][0] == 10. * nodes[l.value()] &&
              copies[l][1] == 10. * nodes[l.value()] + 1.;
  check(name + "updated", updated);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool by_position : {true, false})
  {
    test<2>(300, by_position);
    test<3>(400, by_position);
  }
  return n_failed > 0;
}
