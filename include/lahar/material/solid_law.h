// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_solid_law_h
#define lahar_material_solid_law_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <lahar/utilities/parameters.h>

#include <memory>

namespace Lahar
{
  /**
   * An elastic solid: the Cauchy stress at the end of a step from the deformation gradients F = ∂x/∂X at its start and
   * end and the stress at its start.
   *
   * All tensors are three-dimensional; in plane strain F has the out-of-plane component 1.
   */
  class SolidLaw
  {
  public:
    using Stress = SymmetricTensor<2, 3>;

    /// What the law says of one material point.
    struct Response
    {
      Stress stress; ///< σ, Pa
      /// ∂σ/∂g with g = δF F⁻¹, the gradient of the displacement δu in the configuration at the end of the step.
      Tensor<4, 3> tangent;
    };

    virtual ~SolidLaw() = default;

    /**
     * @param old_F, F deformation gradients at the start and end of the step, det > 0.
     * @param old_stress σ at the start of the step.
     * @param dim only ∂σ/∂g_kl with k, l < @p dim is computed; the other entries stay zero.
     */
    virtual Response evaluate(const Tensor<2, 3> &old_F, const Tensor<2, 3> &F, const Stress &old_stress,
                              const unsigned int dim) const = 0;

    /// Stored energy per present volume, J/m³.
    virtual double energy_density(const Tensor<2, 3> &F, const Stress &stress) const = 0;

    /// ρ in the undeformed state, kg/m³.
    double density() const
    {
      return rho;
    }

    /// κ = E/(3(1−2ν)), Pa.
    double bulk_modulus() const
    {
      return young / (3. * (1. - 2. * poisson));
    }

    /// G = E/(2(1+ν)), Pa.
    double shear_modulus() const
    {
      return young / (2. * (1. + poisson));
    }

    /// Declare `Law` and one subsection a law in the handler's current section.
    static void declare_parameters(Parameters &prm);

    /// Create the law that the current section names. @throws InputError
    static std::unique_ptr<SolidLaw> create(Parameters &prm);

    /// Read the law's own subsection: `Density`, `Young's modulus`, `Poisson's ratio`.
    virtual void parse_parameters(Parameters &prm);

  protected:
    static void declare_common_parameters(Parameters &prm);

  private:
    double rho = 1000., young = 1e6, poisson = 0.;
  };
} // namespace Lahar

#endif
