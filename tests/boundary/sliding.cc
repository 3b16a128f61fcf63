// SPDX-License-Identifier: GPL-3.0-or-later

// Test the friction of surfaces along which fluid slides: the traction of each law, its derivatives against differences
// on either side of sliding, the iteration of the multiplier, and the shares of a boundary that vertices have.

#include <lahar/boundary/sliding_contact.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/utilities/factory.h>

#include <sstream>

#include "tests.h"

using namespace Tests;

std::unique_ptr<SurfaceLaw> create(const std::string &model,
                                   const std::vector<std::pair<std::string, std::string>> &entries)
{
  Parameters prm;
  Factory<SurfaceLaw>::declare_models(prm, "Law", "no slip", "");
  prm.set("Law", model);
  prm.enter_subsection(model);
  for (const auto &[entry, value] : entries)
    prm.set(entry, value);
  prm.leave_subsection();
  return Factory<SurfaceLaw>::create_chosen(prm, "Law");
}

template <int dim>
SlidingContact<dim> contact_of(const SurfaceLaw &law)
{
  SlidingContact<dim> contact;
  contact.law              = &law;
  contact.area             = 0.3;
  contact.stiffness        = 50.;
  contact.normal[0]        = 0.6;
  contact.normal[1]        = -0.8;
  contact.wall_velocity    = {};
  contact.wall_velocity[1] = 0.2;
  return contact;
}

template <int dim>
void test_tangent(const std::string &name, const SurfaceLaw &law)
{
  const SlidingContact<dim> contact = contact_of<dim>(law);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  double error = 0., normal_force = 0., largest = 0.;
  bool sticks = false, slides = false;
  for (unsigned int trial = 0; trial < 200; ++trial)
  {
    Tensor<1, dim> v, lambda;
    for (unsigned int d = 0; d < dim; ++d)
    {
      v[d]      = uniform(random) * (trial % 2 == 0 ? 1. : 1e-3);
      lambda[d] = uniform(random) / std::sqrt(3.);
    }
    const double p = 30. * uniform(random);
    SlidingState<dim> state;
    state.multiplier                                       = lambda;
    state.excess_stress                                    = 5.;
    const SlidingForce<dim> here                           = contact.force(v, p, state);
    (here.multiplier.norm() < 1. - 1e-9 ? sticks : slides) = true;
    normal_force = std::max(normal_force, std::abs(here.value * contact.normal));
    largest      = std::max(largest, here.multiplier.norm());
    // Central differences. The force has kinks where sliding begins and where pressure turns into tension.
    constexpr double step = 1e-6;
    if (std::abs(here.multiplier.norm() - 1.) < 1e-3 && here.multiplier.norm() < 1.)
      continue;
    for (unsigned int d = 0; d < dim; ++d)
    {
      Tensor<1, dim> e;
      e[d] = step;
      const Tensor<1, dim> slope =
        (contact.force(v + e, p, state).value - contact.force(v - e, p, state).value) / (2. * step);
      for (unsigned int c = 0; c < dim; ++c)
        error = std::max(error, std::abs(slope[c] - here.by_velocity[c][d]));
    }
    if (std::abs(5. - p) > 1e-3)
      error = std::max(error,
                       ((contact.force(v, p + step, state).value - contact.force(v, p - step, state).value) /
                          (2. * step) -
                        here.by_pressure)
                         .norm());
  }
  check(name + ": derivatives", error, 1e-5);
  check(name + ": no force along the normal", normal_force, 1e-14);
  check(name + ": the multiplier is at most one", largest <= 1. + 1e-14);
  check(name + ": some stick, some slide", law.resistance(1.).threshold == 0. || (sticks && slides));
}

/// A vertex that a force pulls, whatever it did before: the iteration of velocity and multiplier ends at rest or sliding.
void test_iteration()
{
  const auto law = create("yield slip", {{"Sliding yield stress", "10"}, {"Slip coefficient", "2"}});
  SlidingContact<2> contact = contact_of<2>(*law);
  contact.wall_velocity     = {};
  const Tensor<1, 2> along  = Point<2>(0.8, 0.6);
  constexpr double inertia  = 10.; // m/Δt
  for (const double stiffness : {5., 50., 5e6})
    for (const double pull : {2.5, -2.9, 3.5})
      for (const double old_direction : {0., 1., -1.})
      {
        contact.stiffness = stiffness;
        Tensor<1, 2> v    = 0.3 * along;
        SlidingState<2> state;
        state.multiplier = old_direction * along;
        bool settled     = true;
        for (unsigned int step = 0; step < 300; ++step)
        {
          for (unsigned int iteration = 0; iteration < 20; ++iteration)
          {
            const SlidingForce<2> force = contact.force(v, 0., state);
            const double residual       = inertia * (v * along) + force.value * along - pull,
                         slope          = inertia + along * (force.by_velocity * along);
            v -= residual / slope * along;
            settled = !state.held;
            contact.iterate(v, 0., 6. * contact.normal, true, state);
          }
          state.multiplier = contact.force(v, 0., state).multiplier;
        }
        check("the iteration ends", settled);
        // The surface holds 10 Pa on 0.3 m.
        const double expected = std::abs(pull) > 3. ? (pull - 3.) / (inertia + 0.3 * 2.) : 0.;
        std::ostringstream name;
        name << "pulled by " << pull << ", k = " << stiffness << ", before " << old_direction;
        check(name.str() + (expected > 0. ? ": slides" : ": sticks"), v * along - expected, 1e-9);
        check("... its multiplier", state.multiplier * along - std::min(pull / 3., 1.), 1e-6);
        check("... the normal stress is the reaction", state.excess_stress - 6. / 0.3, 1e-12);
      }
}

void test_laws()
{
  const auto navier  = create("Navier slip", {{"Slip coefficient", "30"}});
  const auto yield   = create("yield slip", {{"Sliding yield stress", "10"}, {"Slip coefficient", "2"}});
  const auto coulomb = create("Coulomb", {{"Friction coefficient", "0.5"}, {"Cohesion", "4"}});
  check("they slide and resist", navier->lands() && navier->resists() && yield->lands() && yield->resists() &&
                                   coulomb->lands() && coulomb->resists());
  check("Navier slip", navier->resistance(7.).viscous == 30. && navier->resistance(7.).threshold == 0.);
  check("yield slip", yield->resistance(7.).viscous == 2. && yield->resistance(7.).threshold == 10.);
  check("Coulomb",
        coulomb->resistance(7.).threshold == 7.5 && coulomb->resistance(7.).threshold_derivative == 0.5);
  for (const auto &[name, law] :
       {std::make_pair("Navier slip", navier.get()), std::make_pair("yield slip", yield.get()),
        std::make_pair("Coulomb", coulomb.get())})
  {
    test_tangent<2>(name, *law);
    test_tangent<3>(std::string("3D ") + name, *law);
  }
  check_throws<InputError>("a slip coefficient of zero", {"Navier slip/Slip coefficient", "llowed"}, [] {
    create("Navier slip", {{"Slip coefficient", "0"}});
  });
  check_throws<InputError>("a negative coefficient of friction",
                           {"Coulomb/Friction coefficient", "-1", "llowed"}, [] {
                             create("Coulomb", {{"Friction coefficient", "-1"}});
                           });
}

/// A square of four particles and one in its middle on a floor and beside a wall of another law.
void test_shares()
{
  const auto floor = create("Coulomb", {}), side = create("Navier slip", {});
  const Walls<2> walls({{{{{-1., 0.}, {2., 0.}}}, true, 0}, {{{{0., -1.}, {0., 2.}}}, true, 1}});
  const WallStep<2> step(walls);
  ParticleCloud<2> cloud;
  for (const Point<2> &p :
       {Point<2>(0., 0.), Point<2>(1., 0.), Point<2>(1., 1.), Point<2>(0., 1.), Point<2>(0.5, 0.5)})
    cloud.append(p, ParticleKind::fluid, 1.);
  WallContact<2>(step).initialize(cloud);
  FluidMesh<2> mesh;
  mesh.reinit(cloud, {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}});
  const auto contacts = SlidingContact<2>::find(mesh, cloud, step, {floor.get(), side.get()});
  std::vector<double> areas(2);
  for (const SlidingContact<2> &contact : contacts)
    areas[contact.law == side.get()] += contact.area;
  check("two vertices of each face", contacts.size() == 4);
  check("the whole of both walls", std::abs(areas[0] - 1.) + std::abs(areas[1] - 1.), 2.001 * contact_offset);
  check("of the first boundary alone",
        SlidingContact<2>::find(mesh, cloud, step, {create("Coulomb", {}).get()}).size() == 2);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_laws();
  test_iteration();
  test_shares();
  return n_failed > 0;
}
