// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/exact_plastic_stress.h>
#include <lahar/assembly/fluid_assembler.h>
#include <lahar/assembly/residual_projection.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/utilities/factory.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// τ_s ρ|g| over the speed of a cell whose fluid is stiff enough to do with less.
    constexpr double largest_leak = 4.;

    /// In m/s: below it a cell is at rest.
    constexpr double smallest_speed = 1e-30;
  } // namespace



  template <int dim>
  void FluidAssembler<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Stabilization");
    Factory<Stabilization<dim>>::declare_choice(prm, "Form", "projected residual",
                                                "Stabilisation of the mass equation.");
    Factory<Stabilization<dim>>::declare_parameters(prm);
    prm.declare_positive(
      "Viscosity limit", "0.1",
      "Largest viscosity in Pa s that enters the stabilisation parameter where the fluid moves, zero or above. The "
      "effective viscosity of a plug would slow down the nonlinear iteration. Where fluid stands there is no limit, "
      "so that it does not creep in proportion to the time step.");
    prm.leave_subsection();
  }



  template <int dim>
  void FluidAssembler<dim>::parse_parameters(Parameters &prm)
  {
    prm.enter_subsection("Stabilization");
    if (Symmetry::applies<dim>() && prm.get("Form") == "FIC")
      prm.throw_wrong_value("Form",
                            "another one with 'Geometry = rotational symmetry', for which the boundary "
                            "terms of this one are not there");
    stabilization   = Factory<Stabilization<dim>>::create(Factory<Stabilization<dim>>::choice(prm, "Form"),
                                                          prm);
    viscosity_limit = prm.get_positive("Viscosity limit", true);
    prm.leave_subsection();
  }



  template <int dim>
  FluidCell<dim> FluidAssembler<dim>::make_cell(const FluidMesh<dim> &mesh, const Materials &materials,
                                                const FluidState<dim> &state, const unsigned int c,
                                                const bool linearize_motion)
  {
    return {state, c, mesh.cells()[c], mesh.fluid(c), materials.law(mesh.fluid(c)), linearize_motion};
  }



  template <int dim>
  void FluidAssembler<dim>::set_stabilization(const FluidMesh<dim> &mesh, const Materials &materials,
                                              FluidState<dim> &state) const
  {
    state.plastic_dual.clear();
    state.residual_projection.assign(materials.n_fluids() * mesh.n_vertices(), Tensor<1, dim>());
    state.stabilization.resize(mesh.n_cells());
    state.stabilization_viscosity.resize(mesh.n_cells());
    state.left_out.assign(mesh.n_cells(), false);
    state.sliver.resize(mesh.n_cells(), false);
    const bool any_exact = materials.any_exact_yield_stress();
    if (any_exact)
    {
      state.multiplier.resize(mesh.n_cells());
      state.stands.resize(mesh.n_cells(), false);
      state.standing_projection.resize(mesh.n_cells());
    }
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const FluidLaw &law = materials.law(mesh.fluid(c));
      const CellFlow<dim> cell(state.shape_of(c, mesh.cells()[c]), mesh.cells()[c], state.velocity,
                               state.pressure);
      const double edge   = cell.edge();
      const double mu_eff = law
                              .effective_viscosity(cell.strain_rate(),
                                                   cell.confining_pressure(law, state.gravity),
                                                   state.structure_of(c))
                              .value;
      const double mu      = std::min(mu_eff, viscosity_limit);
      const double inertia = 2. * law.density() / state.time_step;
      double speed         = 0.;
      for (const Tensor<1, dim> &v : cell.velocity())
        speed = std::max(speed, v.norm());
      const double slowest = (law.density() * state.gravity).norm() /
                             (largest_leak * std::max(speed, smallest_speed));
      state.stabilization_viscosity[c] = mu;
      state.stabilization[c]           = 1. / std::max(8. * mu / (edge * edge) + inertia,
                                             law.has_exact_yield_stress()
                                                         ? 0.
                                                         : std::min(8. * mu_eff / (edge * edge) + inertia, slowest));
    }

    if (!stabilization->projects_residual())
      return;
    std::vector<ResidualProjection<dim>> projections(materials.n_fluids(),
                                                     ResidualProjection<dim>(mesh.n_vertices()));
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const FluidCell<dim> cell = make_cell(mesh, materials, state, c);
      projections[mesh.fluid(c)].add(mesh.cells()[c], cell);
      if (any_exact && state.stands[c])
        state.standing_projection[c] = cell.momentum_residual(0.);
    }
    state.residual_projection.clear();
    for (const ResidualProjection<dim> &projection : projections)
    {
      const std::vector<Tensor<1, dim>> of_fluid = projection.compute();
      state.residual_projection.insert(state.residual_projection.end(), of_fluid.begin(), of_fluid.end());
    }
  }



  template <int dim>
  void FluidAssembler<dim>::start_plastic_dual(const FluidMesh<dim> &mesh, const Materials &materials,
                                               FluidState<dim> &state) const
  {
    state.plastic_dual.resize(mesh.n_cells());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const FluidCell<dim> cell = make_cell(mesh, materials, state, c);
      state.plastic_dual[c]     = 2. * cell.law().plastic_part(cell.plastic_strain_rate()).value *
                              cell.plastic_rate();
    }
  }



  template <int dim>
  void FluidAssembler<dim>::predict_plastic_dual(const FluidMesh<dim> &mesh, const Materials &materials,
                                                 const FluidState<dim> &state,
                                                 const std::vector<Tensor<1, dim>> &increment,
                                                 std::vector<SymmetricTensor<2, dim>> &base,
                                                 std::vector<SymmetricTensor<2, dim>> &slope) const
  {
    base.resize(mesh.n_cells());
    slope.resize(mesh.n_cells());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const FluidLaw &law = materials.law(mesh.fluid(c));
      base[c] = slope[c] = SymmetricTensor<2, dim>();
      if (state.left_out[c] || !law.has_yield_stress())
        continue;
      const Simplex<dim> &vertices = mesh.cells()[c];
      const FluidCell<dim> cell    = make_cell(mesh, materials, state, c);

      Tensor<2, dim> delta_L;
      for (unsigned int I = 0; I <= dim; ++I)
        delta_L += cell.velocity_factor()[I] * outer_product(increment[vertices[I]], cell.gradients()[I]);
      double delta_hoop = 0.;
      for (unsigned int I = 0; I <= dim && cell.is_ring(); ++I)
        delta_hoop += cell.velocity_factor()[I] * increment[vertices[I]][0] * cell.hoop_gradient();
      const SymmetricTensor<2, dim> delta_d = symmetrize(delta_L) - (trace(delta_L) + delta_hoop) / 3. *
                                                                      unit_symmetric_tensor<dim>();

      // 1/ψ = f and ψ'/ψ = −f'/f.
      const SymmetricTensor<2, dim> rate    = cell.plastic_rate();
      const double strain_rate              = cell.plastic_strain_rate();
      const FluidLaw::Value f               = law.plastic_part(strain_rate);
      const SymmetricTensor<2, dim> &Lambda = state.plastic_dual[c];
      const auto product = [&](const SymmetricTensor<2, dim> &a, const SymmetricTensor<2, dim> &b) {
        return law.has_exact_yield_stress() ? deviator_product<dim>(a, b) : cell.product(a, b);
      };
      const double norm       = std::sqrt(0.5 * product(Lambda, Lambda));
      const double delta_rate = 2. * product(rate, delta_d) /
                                std::max(strain_rate, std::numeric_limits<double>::min());
      base[c]  = 2. * f.value * rate;
      slope[c] = 2. * f.value * delta_d + f.derivative / f.value * delta_rate / std::max(1., norm) * Lambda;
    }
  }



  template <int dim>
  void FluidAssembler<dim>::leave_out(const FluidCell<dim> &cell, CellSystem<dim> &system)
  {
    system.clear();
    for (unsigned int I = 0; I <= dim; ++I)
    {
      const double part = cell.is_ring() ? cell.old_shares()[I] : cell.old_volume() / (dim + 1.);
      for (unsigned int a = 0; a < dim; ++a)
        system.matrix[I * (dim + 1) + a][I * (dim + 1) + a] = cell.law().density() * part *
                                                              cell.acceleration_factor()[I];
      system.matrix[I * (dim + 1) + dim][I * (dim + 1) + dim] = cell.stabilization() *
                                                                std::pow(part, 1. - 2. / dim);
    }
  }



  template <int dim>
  bool FluidAssembler<dim>::assemble(const FluidMesh<dim> &mesh, const Materials &materials,
                                     const FluidState<dim> &state, const Linearization &linearization,
                                     BlockSystem<dim> &system) const
  {
    const Inertia<dim> inertia;
    const BodyForce<dim> body_force;
    const ViscousStress<dim> viscous_stress(linearization.viscosity, linearization.plastic_weight);
    const ExactPlasticStress<dim> exact_plastic_stress(linearization.viscosity, linearization.plastic_weight);
    const PressureDivergence<dim> pressure_divergence;
    const FlatPressureDivergence<dim> flat_pressure_divergence;
    const PrescribedPressure<dim> prescribed_pressure;

    CellSystem<dim> cell_system;
    AssertDimension(mesh.n_cells(), system.cells().size());
    system.set_zero();
    auto face     = mesh.boundary_faces().begin();
    auto pressure = state.face_pressures.begin();
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const FluidCell<dim> cell = make_cell(mesh, materials, state, c, linearization.motion);
      if (state.left_out[c])
      {
        leave_out(cell, cell_system);
        system.add(c, cell_system.matrix, cell_system.residual);
        continue;
      }
      if (!(cell.volume() > 0.))
        return false;

      cell_system.clear();
      inertia.assemble(cell, cell_system);
      body_force.assemble(cell, cell_system);
      if (cell.law().has_exact_yield_stress())
        assemble_stress(cell, viscous_stress.viscous_part(cell), exact_plastic_stress.stress(cell),
                        cell_system);
      else
        viscous_stress.assemble(cell, cell_system);
      if (state.sliver[c])
        flat_pressure_divergence.assemble(cell, corners_of<dim>(mesh.cells()[c], state.position),
                                          cell_system);
      else
        pressure_divergence.assemble(cell, cell_system);
      stabilization->assemble(cell, cell_system);

      // Boundary faces come in the order of their cells.
      for (; face != mesh.boundary_faces().end() && face->cell <= c; ++face)
      {
        if (face->cell != c || !face->free_surface)
          continue;
        stabilization->assemble_free_surface(cell, face->opposite, cell_system);
        const unsigned int number = face - mesh.boundary_faces().begin();
        while (pressure != state.face_pressures.end() && pressure->face < number)
          ++pressure;
        if (pressure != state.face_pressures.end() && pressure->face == number)
          prescribed_pressure.assemble(cell, corners_of<dim>(mesh.cells()[c], state.position), face->opposite,
                                       *pressure, cell_system);
      }

      system.add(c, cell_system.matrix, cell_system.residual);
    }
    return true;
  }



  template class FluidAssembler<2>;
  template class FluidAssembler<3>;
} // namespace Lahar
