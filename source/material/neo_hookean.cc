// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/neo_hookean.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  void NeoHookean::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
  }



  SolidLaw::Response NeoHookean::evaluate(const Tensor<2, 3> & /*old_F*/, const Tensor<2, 3> &F,
                                          const Stress & /*old_stress*/, const unsigned int dim) const
  {
    const double J = determinant(F), kappa = bulk_modulus();
    const double G_J                   = shear_modulus() * std::pow(J, -5. / 3.);
    const SymmetricTensor<2, 3> b      = symmetrize(F * transpose(F));
    const SymmetricTensor<2, 3> dev_b  = deviator(b);
    const SymmetricTensor<2, 3> one    = unit_symmetric_tensor<3>();
    const double volumetric_derivative = 0.5 * kappa * (J + 1. / J);

    Response response;
    response.stress = G_J * dev_b + 0.5 * kappa * (J - 1. / J) * one;
    // δb = g b + b gᵀ, δJ = J tr g.
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int l = 0; l < dim; ++l)
      {
        SymmetricTensor<2, 3> delta_b;
        for (unsigned int j = 0; j < 3; ++j)
          delta_b[k][j] += (j == k ? 2. : 1.) * b[l][j];
        SymmetricTensor<2, 3> delta = G_J * deviator(delta_b);
        if (k == l)
          delta += volumetric_derivative * one - 5. / 3. * G_J * dev_b;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            response.tangent[i][j][k][l] = delta[i][j];
      }
    return response;
  }



  double NeoHookean::energy_density(const Tensor<2, 3> &F, const Stress & /*stress*/) const
  {
    const double J = determinant(F), trace_b = trace(symmetrize(F * transpose(F)));
    return (0.5 * shear_modulus() * (std::pow(J, -2. / 3.) * trace_b - 3.) +
            0.5 * bulk_modulus() * (0.5 * (J * J - 1.) - std::log(J))) /
           J;
  }



  static const Factory<SolidLaw>::Registration<NeoHookean> neo_hookean("neo-Hookean",
                                                                       "Compressible, for large strains.");
} // namespace Lahar
