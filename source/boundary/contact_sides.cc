// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/contact_sides.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// What two facets have in common: as many corners, and over an edge (2D: an end) 1 where the normals of both point to
    /// the same side of the surface that they make, −1 where to different ones; else 0.
    struct Joint
    {
      unsigned int n_corners = 0;
      int turn               = 0;
    };

    template <int dim>
    Joint joint_of(const std::array<Point<dim>, dim> &a, const std::array<Point<dim>, dim> &b)
    {
      Joint joint;
      std::array<unsigned int, dim> in_a{}, in_b{};
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          if (a[i] == b[j])
          {
            in_a[joint.n_corners] = i;
            in_b[joint.n_corners] = j;
            ++joint.n_corners;
            break;
          }
      // The common edge is passed along in opposite directions, the common end is where the one ends and the other begins.
      if (dim == 2 && joint.n_corners == 1)
        joint.turn = in_a[0] != in_b[0] ? 1 : -1;
      if (dim == 3 && joint.n_corners == 2)
        joint.turn = (in_a[1] + 3 - in_a[0]) % 3 != (in_b[1] + 3 - in_b[0]) % 3 ? 1 : -1;
      return joint;
    }
  } // namespace



  template <int dim>
  void ContactSides<dim>::add(const unsigned int facet, const int side)
  {
    added.emplace_back(facet, side);
  }



  template <int dim>
  int ContactSides<dim>::passed_on(const unsigned int to) const
  {
    int over_corner = 0;
    for (const auto &[from, side] : added)
    {
      if (from == to)
        return side;
      if (step.deforms(from))
        continue;
      const double cosine = walls.normal(from) * walls.normal(to);
      const Joint joint   = joint_of<dim>(walls.facets()[from].corners, walls.facets()[to].corners);
      if (joint.turn != 0)
        return side * joint.turn;
      if (joint.n_corners > 0 && std::abs(cosine) > smooth_joint)
        over_corner = cosine > 0. ? side : -side;
    }
    return over_corner;
  }



  template <int dim>
  int ContactSides<dim>::find(const unsigned int to, const int by_place) const
  {
    if (step.deforms(to)) // the outside
      return by_place;
    if (const int side = passed_on(to); side != 0)
      return side;
    return left_over_bulge(to, -by_place).empty() ? by_place : -by_place;
  }



  template <int dim>
  bool ContactSides<dim>::goes_on(const int from, const unsigned int to, const int side) const
  {
    const int side_from = added_side(from);
    return side_from != 0 && side_from * side * (walls.normal(from) * walls.normal(to)) > smooth_joint;
  }



  template <int dim>
  bool ContactSides<dim>::is_round_edge(const int from, const unsigned int to) const
  {
    const int side = added_side(from);
    return side != 0 &&
           joint_of<dim>(walls.facets()[from].corners, walls.facets()[to].corners).n_corners > 0 &&
           is_behind(from, side, to);
  }



  template <int dim>
  std::vector<unsigned int> ContactSides<dim>::left_over_bulge(const unsigned int to, const int side) const
  {
    std::vector<unsigned int> result;
    if (!step.deforms(to))
      for (const auto &[from, side_from] : added)
        if (goes_on(from, to, side) && is_behind(from, side_from, to))
          result.push_back(from);
    return result;
  }



  template <int dim>
  std::optional<std::pair<unsigned int, int>>
  ContactSides<dim>::passed_by(const Point<dim> &place, const double reach,
                               const std::array<int, dim> &in_contact) const
  {
    if (added.empty())
      return {};
    for (const unsigned int facet : walls.near(place, reach))
      if (walls.facets()[facet].lands && !step.deforms(facet) && walls.is_above(facet, place, 0.))
        if (const int side = passed_on(facet); side != 0)
          if (const double height = side * walls.signed_distance(facet, place);
              height < 0. && -height < reach &&
              std::none_of(in_contact.begin(), in_contact.end(),
                           [&](const int from) { return is_round_edge(from, facet); }))
            return std::make_pair(facet, side);
    return {};
  }



  template <int dim>
  int ContactSides<dim>::added_side(const int facet) const
  {
    const auto entry = std::find_if(added.begin(), added.end(),
                                    [facet](const std::pair<unsigned int, int> &e) {
                                      return static_cast<int>(e.first) == facet;
                                    });
    return entry != added.end() ? entry->second : 0;
  }



  template <int dim>
  bool ContactSides<dim>::is_behind(const unsigned int from, const int side, const unsigned int to) const
  {
    Point<dim> middle;
    for (const Point<dim> &corner : walls.facets()[to].corners)
      middle += corner / dim;
    return side * walls.signed_distance(from, middle) < 0.;
  }



  template class ContactSides<2>;
  template class ContactSides<3>;
} // namespace Lahar
