// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/normal_parts.h>

#include <Eigen/Cholesky>

namespace Lahar
{
  template <int dim>
  std::vector<double> normal_parts(const std::vector<Tensor<1, dim>> &normals, const Tensor<1, dim> &force)
  {
    const unsigned int n = normals.size();
    Eigen::MatrixXd products(n, n);
    Eigen::VectorXd along(n);
    for (unsigned int k = 0; k < n; ++k)
    {
      along[k] = force * normals[k];
      for (unsigned int l = 0; l < n; ++l)
        products(k, l) = normals[k] * normals[l];
    }
    const Eigen::VectorXd parts = products.ldlt().solve(along);
    return {parts.begin(), parts.end()};
  }



  template std::vector<double> normal_parts<2>(const std::vector<Tensor<1, 2>> &, const Tensor<1, 2> &);
  template std::vector<double> normal_parts<3>(const std::vector<Tensor<1, 3>> &, const Tensor<1, 3> &);
} // namespace Lahar
