// Test how nodes are shared out: every node has one owner, the rows of own nodes and of the halo are complete, local
// numbers are in the promised order, and gathering brings every value to every rank; in 2D and 3D, with two lists of
// cells, on one rank and on several.

#include <lahar/linear/node_partition.h>
#include <lahar/remeshing/delaunay.h>

#include <algorithm>
#include <set>

#include "tests.h"

using namespace Tests;

template <int dim>
void test(const unsigned int n_points, const bool by_position)
{
  const std::string name = Utilities::int_to_string(dim) + "D, " +
                           (by_position ? "by position: " : "by number: ");
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  Random random;
  std::vector<Point<dim>> points;
  for (unsigned int i = 0; i < n_points; ++i)
    points.push_back(Point<dim>(random.vector<dim>()));

  // Two lists: every third simplex is in the second one.
  std::vector<Simplex<dim>> cells[2];
  unsigned int n_all = 0;
  for (const Simplex<dim> &simplex : delaunay(points))
    cells[n_all++ % 3 == 0].push_back(simplex);
  std::vector<CellList> lists;
  for (const auto &list : cells)
    lists.push_back({list.front().data(), static_cast<unsigned int>(list.size()), dim + 1});

  const std::vector<unsigned int> owners = by_position ? share_nodes(points, lists, n_ranks)
                                                       : std::vector<unsigned int>();
  NodePartition partition(MPI_COMM_WORLD);
  partition.reinit(n_points, owners, lists);
  const auto &nodes = partition.nodes();

  std::vector<unsigned int> n_owners(n_points, 0);
  for (unsigned int l = 0; l < partition.n_own(); ++l)
    ++n_owners[nodes[l]];
  Utilities::MPI::sum(n_owners, MPI_COMM_WORLD, n_owners);
  check(name + "one owner each", std::count(n_owners.begin(), n_owners.end(), 1U) == n_points);
  check(name + "shares are balanced",
        n_ranks * partition.n_own() > 0.7 * n_points && n_ranks * partition.n_own() < 1.3 * n_points);
  check(name + "own nodes ascend", std::is_sorted(nodes.begin(), nodes.begin() + partition.n_own()));
  bool found = true;
  for (unsigned int l = 0; l < nodes.size(); ++l)
    found = found && partition.local(nodes[l]) == l;
  check(name + "local numbers", found);
  if (by_position)
    check(name + "halo by owner and number",
          std::is_sorted(nodes.begin() + partition.n_own(), nodes.begin() + partition.n_with_rows(),
                         [&](const unsigned int i, const unsigned int j) {
                           return std::make_pair(owners[i], i) < std::make_pair(owners[j], j);
                         }));

  // What the definitions say, by hand.
  std::set<unsigned int> own(nodes.begin(), nodes.begin() + partition.n_own()), with_halo = own;
  for (const auto &list : cells)
    for (const Simplex<dim> &cell : list)
      if (std::any_of(cell.begin(), cell.end(), [&](const unsigned int node) { return own.count(node) > 0; }))
        with_halo.insert(cell.begin(), cell.end());
  std::set<unsigned int> known = with_halo;
  bool cells_agree             = true;
  for (unsigned int k = 0; k < 2; ++k)
  {
    std::vector<unsigned int> numbers;
    for (unsigned int c = 0; c < cells[k].size(); ++c)
      if (std::any_of(cells[k][c].begin(), cells[k][c].end(),
                      [&](const unsigned int node) { return with_halo.count(node) > 0; }))
      {
        numbers.push_back(c);
        known.insert(cells[k][c].begin(), cells[k][c].end());
      }
    cells_agree                           = cells_agree && numbers == partition.cells(k);
    const std::vector<unsigned int> local = partition.local_cells(k, lists[k]);
    for (unsigned int i = 0; i < local.size(); ++i)
      cells_agree = cells_agree && nodes[local[i]] == cells[k][numbers[i / (dim + 1)]][i % (dim + 1)];
  }
  check(name + "halo",
        with_halo == std::set<unsigned int>(nodes.begin(), nodes.begin() + partition.n_with_rows()));
  check(name + "known nodes", known == std::set<unsigned int>(nodes.begin(), nodes.end()));
  check(name + "known cells", cells_agree);

  // The owners' values of two numbers a node arrive at all ranks that know the node.
  std::vector<std::array<double, 2>> copies(nodes.size(), {{-1., -1.}});
  for (unsigned int l = 0; l < partition.n_own(); ++l)
    copies[l] = {{10. * nodes[l], 10. * nodes[l] + 1.}};
  partition.update(copies);
  bool updated = true;
  for (unsigned int l = 0; l < nodes.size(); ++l)
    updated = updated && copies[l][0] == 10. * nodes[l] && copies[l][1] == 10. * nodes[l] + 1.;
  check(name + "updated", updated);

  // Gather two values a node of two ranges of nodes.
  std::vector<double> values;
  for (unsigned int l = 0; l < partition.n_own(); ++l)
    for (unsigned int a = 0; a < 2; ++a)
      values.push_back(10. * nodes[l] + a);
  const std::vector<double> all = partition.gather(values.data(), 2, {{0, 20}, {100, n_points}});
  bool gathered                 = all.size() == (n_points - 80) * 2;
  for (unsigned int i = 0; i < all.size(); ++i)
    gathered = gathered && all[i] == 10. * (i / 2 + (i >= 40 ? 80 : 0)) + i % 2;
  check(name + "gathered", gathered);
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
