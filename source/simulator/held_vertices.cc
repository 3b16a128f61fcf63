// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/held_vertices.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <string>

namespace Lahar
{
  namespace
  {
    // Parts are powers of ½: a quarter and a half, or three halves in a row. A simplex may lose most of its volume in one
    // increment, so that a vertex that is stopped can go on halving for many iterations.
    constexpr double smallest_product      = 0.2;
    constexpr unsigned int n_short_to_hold = 2;
    /// A few are allowed in small meshes too.
    constexpr double largest_held_part      = 0.01;
    constexpr unsigned int n_always_allowed = 1;
  } // namespace



  template <int dim>
  void HeldVertices<dim>::start_step(const IndexVector<LocalNode, bool> &new_can_be_held)
  {
    can_be_held = new_can_be_held;
    followed.assign(can_be_held.size(), 1.);
    n_short.assign(can_be_held.size(), 0);
    product.assign(can_be_held.size(), 1.);
    n_held = 0;
  }



  template <int dim>
  void HeldVertices<dim>::note(const IndexVector<LocalNode, double> &lengths)
  {
    followed = lengths;
  }



  template <int dim>
  bool HeldVertices<dim>::update(const NodePartition &partition,
                                 IndexVector<LocalNode, NodeConstraint<dim>> &constraints)
  {
    // Ranks that know a vertex know the same of it, and come to the same decision.
    const unsigned int n_before = n_held;
    unsigned int n_own_new      = 0;
    for (const LocalNode v : followed.indices())
    {
      const bool is_short = followed[v] < 1.;
      n_short[v]          = is_short ? n_short[v] + 1 : 0;
      product[v]          = is_short ? product[v] * followed[v] : 1.;
      if (n_short[v] >= n_short_to_hold && product[v] < smallest_product && can_be_held[v])
      {
        can_be_held[v]         = false;
        constraints[v]         = {};
        constraints[v].n_fixed = dim;
        n_own_new += partition.is_own(v);
      }
    }
    n_held += Utilities::MPI::sum(n_own_new, partition.communicator());
    if (n_held > std::max<double>(n_always_allowed, largest_held_part * partition.n_nodes()))
      throw RunError("flat simplices stop the flow at " + std::to_string(n_held) + " vertices");
    return n_held > n_before;
  }



  template class HeldVertices<2>;
  template class HeldVertices<3>;
} // namespace Lahar
