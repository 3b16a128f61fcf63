// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/hypoelastic.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void Hypoelastic::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
  }



  SolidLaw::Response Hypoelastic::evaluate(const Tensor<2, 3> &old_F, const Tensor<2, 3> &F,
                                           const Stress &old_stress, const unsigned int dim) const
  {
    const Tensor<2, 3> one = unit_symmetric_tensor<3>();
    const Tensor<2, 3> f   = F * invert(old_F);
    const Tensor<2, 3> M   = invert(0.5 * (f + one)); // ∂x_n/∂x_{n+1/2}
    const Tensor<2, 3> H   = (f - one) * M;
    const Tensor<2, 3> D = 0.5 * (H + transpose(H)), W = 0.5 * (H - transpose(H));
    const Tensor<2, 3> left  = invert(one - 0.5 * W);
    const Tensor<2, 3> R     = left * (one + 0.5 * W);
    const Tensor<2, 3> sigma = old_stress;
    const double G2 = 2. * shear_modulus(), lambda = bulk_modulus() - G2 / 3.;

    Response response;
    response.stress = symmetrize(R * sigma * transpose(R) + G2 * D + lambda * trace(D) * one);

    // δH = (1 − H/2) g ∂x/∂x_{n+1/2}, δR = (1 − W/2)⁻¹ δW/2 (1 + R).
    const Tensor<2, 3> to_middle = f * M, factor = one - 0.5 * H, R_plus = one + R,
                       sigma_Rt = sigma * transpose(R);
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int l = 0; l < dim; ++l)
      {
        Tensor<2, 3> delta_H;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            delta_H[i][j] = factor[i][k] * to_middle[l][j];
        const Tensor<2, 3> turned = 0.25 * left * (delta_H - transpose(delta_H)) * R_plus * sigma_Rt;
        const double volumetric   = lambda * trace(delta_H);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            response.tangent[i][j][k][l] = turned[i][j] + turned[j][i] +
                                           0.5 * G2 * (delta_H[i][j] + delta_H[j][i]) +
                                           (i == j ? volumetric : 0.);
      }
    return response;
  }



  double Hypoelastic::energy_density(const Tensor<2, 3> & /*F*/, const Stress &stress) const
  {
    const double p = trace(stress) / 3.;
    const Stress s = deviator(stress);
    return p * p / (2. * bulk_modulus()) + s * s / (4. * shear_modulus());
  }



  static const Factory<SolidLaw>::Registration<Hypoelastic>
    hypoelastic("hypoelastic", "Jaumann rate of the Cauchy stress, linear in the rate of deformation.");
} // namespace Lahar
