#include <lahar/simulator/anderson_acceleration.h>

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



  void AndersonAcceleration::restart()
  {
    last_f.reinit(0);
    delta_f.clear();
    delta_g.clear();
  }



  Vector<double> AndersonAcceleration::next_iterate(const Vector<double> &x, const Vector<double> &g,
                                                    const Vector<double> &weights)
  {
    Vector<double> f = g;
    f -= x;
    if (last_f.size() > 0)
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
    last_f = f;
    last_g = g;

    // Gram-Schmidt on the columns W Δf; Δg follows, so that c_j are the components of W f_k.
    Vector<double> next = g;
    f.scale(weights);
    std::vector<Vector<double>> columns, images;
    for (unsigned int j = 0; j < delta_f.size(); ++j)
    {
      Vector<double> column = delta_f[j], image = delta_g[j];
      column.scale(weights);
      const double norm = column.l2_norm();
      for (unsigned int i = 0; i < columns.size(); ++i)
      {
        const double component = columns[i] * column;
        column.add(-component, columns[i]);
        image.add(-component, images[i]);
      }
      const double rest = column.l2_norm();
      if (!(rest > dependent * norm))
        continue;
      column /= rest;
      image /= rest;
      const double component = column * f;
      f.add(-component, column);
      next.add(-component, image);
      columns.push_back(column);
      images.push_back(image);
    }
    return next;
  }
} // namespace Lahar
