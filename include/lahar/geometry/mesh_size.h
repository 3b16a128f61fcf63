// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_mesh_size_h
#define lahar_geometry_mesh_size_h

#include <lahar/geometry/box.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/utilities/parameters.h>

#include <vector>

namespace Lahar
{
  /**
   * The wanted distance of neighbouring particles as a function of the place, m:
   *
   *   h(x) = min(h_0, min_i (h_i + G |x − B_i|)),   G = 0.2,
   *
   * h_0 the entry `Mesh size`, B_i the boxes of `Remeshing/Refined boxes`, h_i their mesh sizes and |x − B_i| the
   * distance of x from B_i, zero inside. Where boxes overlap the smallest size wins. |∇h| is at most G, so that from one
   * particle to the next h changes by a factor of about 1.2.
   */
  template <int dim>
  class MeshSize
  {
  public:
    /// The same size everywhere.
    MeshSize(const double uniform = 0.)
      : sizes({uniform})
    {}

    static void declare_parameters(Parameters &prm);

    /// Read the boxes; @p mesh_size is h_0. @throws InputError
    void parse_parameters(Parameters &prm, const double mesh_size);

    /// h at a place.
    double operator()(const Point<dim> &point) const;

    bool is_uniform() const
    {
      return boxes.empty();
    }

    /// h_0, the largest size.
    double coarsest() const
    {
      return sizes.back();
    }

    /// The smallest h in a box.
    double finest_in(const Box<dim> &region) const;

    /**
     * Sizes of the lattices that bodies are filled with, ascending: those of the boxes, h_0, and between them steps by
     * factors of at most √2.
     */
    const std::vector<double> &levels() const
    {
      return sizes;
    }

    /// About how many points at distances h the boxes add to what h_0 alone gives in a part of a box of space: with
    /// @p n_directions = dim in the whole of it, with less on lines or surfaces in it.
    double estimate_refinement(const Box<dim> &region, const unsigned int n_directions) const;

    /**
     * Give all fluid particles the spacing h of the place where they are now. It falls by 15 % at most in one call: the
     * division of edges, one a particle and step, cannot follow faster. Nothing happens without refined boxes.
     */
    void update(ParticleCloud<dim> &cloud) const;

  private:
    struct RefinedBox
    {
      Box<dim> box;
      double size;
    };

    std::vector<RefinedBox> boxes;
    std::vector<double> sizes; ///< levels()
  };
} // namespace Lahar

#endif
