#include <lahar/simulator/undetermined_pressures.h>

#include <boost/pending/disjoint_sets.hpp>

namespace Lahar
{
  template <int dim>
  void fix_undetermined_pressures(const std::vector<Simplex<dim>> &cells,
                                  std::vector<NodeConstraint<dim>> &constraints)
  {
    boost::disjoint_sets_with_storage<> parts(constraints.size());
    for (const Simplex<dim> &cell : cells)
      for (unsigned int I = 1; I <= dim; ++I)
        parts.union_set(cell[0], cell[I]);

    std::vector<bool> moves(constraints.size(), false);
    for (unsigned int i = 0; i < constraints.size(); ++i)
      if (constraints[i].n_fixed < dim)
        moves[parts.find_set(i)] = true;
    for (unsigned int i = 0; i < constraints.size(); ++i)
      constraints[i].fixed_pressure = !moves[parts.find_set(i)];
  }



  template void fix_undetermined_pressures(const std::vector<Simplex<2>> &, std::vector<NodeConstraint<2>> &);
  template void fix_undetermined_pressures(const std::vector<Simplex<3>> &, std::vector<NodeConstraint<3>> &);
} // namespace Lahar
