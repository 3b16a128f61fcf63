#include <lahar/simulator/held_vertices.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <string>

namespace Lahar
{
  namespace
  {
    constexpr double blocked_part            = 0.3;
    constexpr unsigned int n_blocked_to_hold = 2;
    /// A few are allowed in small meshes too.
    constexpr double largest_held_part      = 0.01;
    constexpr unsigned int n_always_allowed = 1;
  } // namespace



  template <int dim>
  void HeldVertices<dim>::start_step(const std::vector<bool> &new_can_be_held)
  {
    can_be_held = new_can_be_held;
    is_blocked.assign(can_be_held.size(), false);
    n_blocked.assign(can_be_held.size(), 0);
    n_held = 0;
  }



  template <int dim>
  void HeldVertices<dim>::note(const std::vector<double> &lengths)
  {
    for (unsigned int v = 0; v < is_blocked.size(); ++v)
      is_blocked[v] = lengths[v] < blocked_part;
  }



  template <int dim>
  bool HeldVertices<dim>::update(std::vector<NodeConstraint<dim>> &constraints)
  {
    const unsigned int n_before = n_held;
    for (unsigned int v = 0; v < is_blocked.size(); ++v)
    {
      n_blocked[v] = is_blocked[v] ? n_blocked[v] + 1 : 0;
      if (n_blocked[v] >= n_blocked_to_hold && can_be_held[v])
      {
        can_be_held[v] = false;
        constraints[v] = {dim, unit_symmetric_tensor<dim>(), false};
        ++n_held;
      }
    }
    if (n_held > std::max<double>(n_always_allowed, largest_held_part * constraints.size()))
      throw RunError("flat simplices stop the flow at " + std::to_string(n_held) + " vertices");
    return n_held > n_before;
  }



  template class HeldVertices<2>;
  template class HeldVertices<3>;
} // namespace Lahar
