// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_boundary_reactions_h
#define lahar_postprocess_boundary_reactions_h

#include <lahar/postprocess/postprocessor.h>

#include <functional>

namespace Lahar
{
  /**
   * Call @p use with a boundary, the mean force (N) of a particle of the rank's own on it over the last step, and the
   * particle's place: the reactions of the discrete momentum equation at the particles of boundaries and at those of the
   * fluid in contact, see TimeIntegration::mean_force().
   *
   * A particle that boundaries share belongs to the first of them. Where a particle touches facets of several
   * boundaries, each has the part of the reaction along its normal, and the first boundary of the case what is along
   * the edge.
   */
  template <int dim>
  void for_each_boundary_force(
    const Snapshot<dim> &snapshot,
    const std::function<void(const unsigned int, const Tensor<1, dim> &, const Point<dim> &)> &use);
} // namespace Lahar

#endif
