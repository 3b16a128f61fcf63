// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/anderson_acceleration.h>

#include <cmath>

namespace Lahar
{
  namespace
  {
    /// A difference that is the sum of the others but for this part says nothing new.
    constexpr double dependent = 1e-4;
  } // namespace



  AndersonAcceleration::AndersonAcceleration(const unsigned int depth)
    : depth(depth)
  {}



  void AndersonAcceleration::restart(const MPI_Comm &new_communicator)
  {
    communicator = new_communicator;
    has_last     = false;
    delta_f.clear();
    delta_g.clear();
  }



  double AndersonAcceleration::inner_product(const Vector<double> &a, const Vector<double> &b) const
  {
    return Utilities::MPI::sum(a.size() > 0 ? a * b : 0., communicator);
  }



  Vector<double> AndersonAcceleration::next_iterate(const Vector<double> &x, const Vector<double> &g,
                                                    const Vector<double> &weights)
  {
    Vector<double> f = g;
    f -= x;
    if (has_last)
    {
      delta_f.push_front(f);
      delta_f.front() -= last_f;
      delta_g.push_front(g);
      delta_g.front() -= last_g;
      if (delta_f.size() > depth)
      {
        delta_f.pop_back();
        delta_g.pop_back();
      }
    }
    last_f   = f;
    last_g   = g;
    has_last = true;

    // Gram-Schmidt on the columns W Δf; Δg follows, so that c_j are the components of W f_k.
    Vector<double> next = g;
    f.scale(weights);
    std::vector<Vector<double>> columns, images;
    for (unsigned int j = 0; j < delta_f.size(); ++j)
    {
      Vector<double> column = delta_f[j], image = delta_g[j];
      column.scale(weights);
      const double norm = std::sqrt(inner_product(column, column));
      for (unsigned int i = 0; i < columns.size(); ++i)
      {
        const double component = inner_product(columns[i], column);
        column.add(-component, columns[i]);
        image.add(-component, images[i]);
      }
      const double rest = std::sqrt(inner_product(column, column));
      if (!(rest > dependent * norm))
        continue;
      column /= rest;
      image /= rest;
      const double component = inner_product(column, f);
      f.add(-component, column);
      next.add(-component, image);
      columns.push_back(column);
      images.push_back(image);
    }
    return next;
  }
} // namespace Lahar
