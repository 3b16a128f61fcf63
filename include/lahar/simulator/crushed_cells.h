// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_crushed_cells_h
#define lahar_simulator_crushed_cells_h

#include <vector>

namespace Lahar
{
  /**
   * Simplices of the fluid that a solid crushes against what cannot give way: their corners are the solid's, or have
   * prescribed velocities (walls, HeldVertices).
   *
   * Nothing in the fluid can keep such a simplex from becoming flat, and a solid does not stop at one of them: its
   * increments would be cut in every iteration. Once the increments have wanted to flatten it in five iterations it is
   * left out: it exerts no force for the rest of the time step, whatever becomes of its volume. The remeshing that
   * follows replaces it, and gives back what it has gained or lost.
   */
  class CrushedCells
  {
  public:
    /// Begin a step, in which no cell is left out.
    void start_step(const unsigned int n_cells);

    /// Take note of cells, all corners of which are the solids' or prescribed, that an increment would flatten.
    void note(const std::vector<unsigned int> &cells);

    /// After an iteration: leave cells out. Ranks that know a cell come to the same decision.
    void update(std::vector<bool> &left_out) const;

  private:
    std::vector<unsigned int> n_times; ///< that increments wanted to flatten the cell
  };
} // namespace Lahar

#endif
