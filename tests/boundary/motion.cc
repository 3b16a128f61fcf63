// SPDX-License-Identifier: GPL-3.0-or-later

// Test boundaries that move: the rigid motions of the models against their definitions, tables over time, walls in a
// step, what they prescribe for particles that stick and slide, and particles in their way.

#include <lahar/boundary/boundary_motion.h>
#include <lahar/boundary/free_flight.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/utilities/factory.h>

#include <fstream>

#include "tests.h"

using namespace Tests;

/// A model with its entries set.
template <int dim>
std::unique_ptr<BoundaryMotion<dim>> create(const std::string &model,
                                            const std::vector<std::pair<std::string, std::string>> &entries)
{
  Parameters prm;
  Factory<BoundaryMotion<dim>>::declare_models(prm, "Motion", "fixed", "");
  prm.set("Motion", model);
  if (!entries.empty())
    prm.enter_subsection(model);
  for (const auto &[entry, value] : entries)
    prm.set(entry, value);
  if (!entries.empty())
    prm.leave_subsection();
  return Factory<BoundaryMotion<dim>>::create_chosen(prm, "Motion");
}

void test_models()
{
  check("fixed", !create<2>("fixed", {})->moves() &&
                   create<2>("fixed", {})->at(3.)(Point<2>(1., 2.)) == Point<2>(1., 2.));
  const auto lift = create<2>("translation", {{"Displacement", "0.5*t; 0.1*min(max(t - 1, 0), 2)"}});
  check("translation",
        (lift->at(2.)(Point<2>(1., 2.)) - Point<2>(2., 2.1)).norm() +
          (lift->at(9.)(Point<2>(1., 2.)) - Point<2>(5.5, 2.2)).norm(),
        1e-14);
  const auto turn = create<2>("rotation", {{"Centre", "1, 1"}, {"Angle", "pi/2*t"}});
  check("rotation: counterclockwise", (turn->at(1.)(Point<2>(2., 1.)) - Point<2>(1., 2.)).norm(), 1e-15);
  const auto wheel = create<3>("rotation", {{"Centre", "1, 0, 0"}, {"Axis", "0, 2, 0"}, {"Angle", "pi/2*t"}});
  check("3D rotation: right-handed about the axis",
        (wheel->at(1.)(Point<3>(1., 5., 1.)) - Point<3>(2., 5., 0.)).norm(), 1e-15);
  const auto skew             = create<3>("rotation", {{"Axis", "1, 2, 3"}, {"Angle", "t"}});
  const RigidMotion<3> by_one = skew->at(1.);
  const Tensor<2, 3> &R       = by_one.rotation;
  check("3D rotation: orthogonal, right-handed",
        (R * transpose(R) - unit_symmetric_tensor<3>()).norm() + std::abs(determinant(R) - 1.), 1e-14);
  check("3D rotation: its trace is 1 + 2 cos", trace(R) - 1. - 2. * std::cos(1.), 1e-14);
  const Point<3> p(0.3, -0.4, 0.5);
  check("motions follow each other",
        (skew->at(0.7).after(skew->at(0.3))(p) - by_one(p)).norm() + (by_one.inverse()(by_one(p)) - p).norm(),
        1e-14);

  check_throws<InputError>("rotation without an axis", {"rotation/Axis", "0, 0, 0", "llowed"}, [] {
    create<3>("rotation", {{"Axis", "0, 0, 0"}});
  });
  check_throws<InputError>("a displacement of one component",
                           {"translation/Displacement", "llowed: 2 functions"}, [] {
                             create<2>("translation", {{"Displacement", "t"}});
                           });
  check_throws<InputError>("a displacement of x", {"translation/Displacement", "x; 0", "time t"}, [] {
    create<2>("translation", {{"Displacement", "x; 0"}});
  });
  check_throws<RunError>("an angle that is not finite", {"rotation/Angle", "1/(t - 2)", "t = 2.0"}, [] {
    create<2>("rotation", {{"Angle", "1/(t - 2)"}})->at(2.);
  });
}

void test_table()
{
  const std::string name = "motion_table.csv";
  const auto write       = [&](const std::string &text) { std::ofstream(name) << text; };
  write("# a gate: t (s), x (m), y (m)\n0, 0, 0\n1, 0.5, -1\n\n3, 0.5, 1 # up again\n");
  const auto table = create<2>("table", {{"File", name}});
  check("table: linear between its times",
        (table->at(0.5)(Point<2>()) - Point<2>(0.25, -0.5)).norm() +
          (table->at(2.)(Point<2>()) - Point<2>(0.5, 0.)).norm(),
        1e-15);
  check("table: constant before and after",
        table->at(-1.)(Point<2>()) == Point<2>() && table->at(9.)(Point<2>()) == Point<2>(0.5, 1.));
  for (const auto &[text, part] :
       std::vector<std::pair<std::string, std::string>>{{"0, 0, 0\n1, 1\n", ":2: found '1, 1'"},
                                                        {"0, 0, 0\n1, 1, one\n", ":2: found '1, 1, one'"},
                                                        {"0, 0, 0\n1, 0, 0\n1, 1, 0\n",
                                                         ":3: found '1, 1, 0'"},
                                                        {"t, x, y\n0, 0, 0\n", ":1: found 't, x, y'"},
                                                        {"# t, x, y\n", "has no line with numbers"}})
  {
    write(text);
    check_throws<InputError>("table: " + part, {name, part, "llowed"}, [&] {
      create<2>("table", {{"File", name}});
    });
  }
  check_throws<InputError>("no table", {"nowhere.csv", "does not exist", "llowed"}, [] {
    create<2>("table", {{"File", "nowhere.csv"}});
  });
}

/// A floor that stands, and a wall that goes to the right and turns a little in a step of 0.1 s.
struct Piston
{
  explicit Piston(const bool slip)
  {
    std::vector<WallFacet<2>> facets = {{{{{-1., 0.}, {2., 0.}}}, true, 0, false},
                                        {{{{0., -0.1}, {0., 1.}}}, slip, 1, true}};
    start                            = Walls<2>(facets, {"floor", "piston"});
    for (Point<2> &corner : facets[1].corners)
      corner = motion(corner);
    end = Walls<2>(facets, {"floor", "piston"});
  }

  WallStep<2> step() const
  {
    return WallStep<2>(start, end, {{}, motion}, 0.1);
  }

  const RigidMotion<2> motion = create<2>("rotation", {{"Centre", "1, 5"}, {"Angle", "0.01*t"}})->at(1.);
  Walls<2> start, end;
};

void test_no_slip()
{
  const Piston piston(false);
  const WallStep<2> step = piston.step();
  const WallContact<2> condition(step);
  check("moves", step.any_moves() && step.moves(1) && !step.moves(0) && step.facet_moves(1));
  ParticleCloud<2> cloud;
  const unsigned int stuck          = cloud.append({0., 0.5}, ParticleKind::wall, 0.1, 1),
                     stands         = cloud.append({1., 0.}, ParticleKind::wall, 0.1, 0),
                     ahead          = cloud.append({0.01, 0.4}, ParticleKind::fluid, 0.1),
                     far            = cloud.append({0.2, 0.4}, ParticleKind::fluid, 0.1),
                     behind         = cloud.append({-0.01, 0.4}, ParticleKind::fluid, 0.1);
  const Point<2> old_place          = cloud.position[stuck];
  const NodeConstraint<2> of_stuck  = condition.constraint(stuck, cloud),
                          of_stands = condition.constraint(stands, cloud);
  check("its particles have its mean velocity",
        of_stuck.n_fixed == 2 && of_stuck.moves &&
          (of_stuck.velocity - (piston.motion(old_place) - old_place) / 0.1).norm() < 1e-14 &&
          of_stuck.velocity[0] > 0.3);
  check("those of a wall that stands have none",
        of_stands.n_fixed == 2 && !of_stands.moves && of_stands.velocity.norm() == 0.);

  const std::vector<Point<2>> old_position = cloud.position;
  step.carry_particles(old_position, cloud);
  check("its particles are carried",
        (cloud.position[stuck] - piston.motion(old_place)).norm() == 0. &&
          cloud.position[stands] == old_position[stands] &&
          std::abs(piston.end.signed_distance(1, cloud.position[stuck])) < 1e-15);
  stop_at_walls(old_position, step, cloud);
  const double side = piston.start.signed_distance(1, old_position[ahead]);
  check("what stands in its way is pushed along",
        piston.end.signed_distance(1, cloud.position[ahead]) * side > 0. &&
          (cloud.velocity[ahead] - step.velocity_at_end(1, cloud.position[ahead])).norm() < 1e-15);
  check("and keeps its distance where that is small",
        std::abs(piston.end.signed_distance(1, cloud.position[ahead])) - 0.01, 1e-12);
  check("what is farther away stays", cloud.position[far] == old_position[far]);
  check("what is behind it stays", cloud.position[behind] == old_position[behind]);
}

void test_slip()
{
  const Piston piston(true);
  const WallStep<2> step = piston.step();
  const WallContact<2> condition(step);
  ParticleCloud<2> cloud;
  for (const Point<2> &p : {Point<2>(0., 0.5), Point<2>(0., 0.), Point<2>(0.02, 0.3)})
    cloud.append(p, ParticleKind::fluid, 0.1);
  const WallStep<2> standing(piston.start);
  WallContact<2>(standing).initialize(cloud);
  check("in contact at the start", cloud.in_contact(0) && cloud.in_contact(1) && !cloud.in_contact(2));
  const std::vector<Point<2>> old_position = cloud.position;
  for (const unsigned int i : {0, 1})
  {
    const NodeConstraint<2> prescribed = condition.constraint(i, cloud);
    check("what is prescribed: number " + std::to_string(i), prescribed.moves && prescribed.n_fixed == i + 1);
    // Along what is free it may go as it likes.
    cloud.velocity[i] = prescribed.velocity;
    for (unsigned int a = prescribed.n_fixed; a < 2; ++a)
    {
      check("nothing is prescribed along what is free", prescribed.velocity * prescribed.frame[a], 1e-15);
      cloud.velocity[i] += 0.7 * prescribed.frame[a];
    }
    cloud.position[i] += 0.1 * cloud.velocity[i];
    check("the particle is on the wall at the end",
          std::abs(piston.end.signed_distance(1, cloud.position[i])) - contact_offset * cloud.spacing[i],
          1e-15);
  }
  check("in the corner it is on the floor, too",
        std::abs(cloud.position[1][1]) - contact_offset * cloud.spacing[1], 1e-15);
  condition.update(old_position, cloud);
  check("the wall meets a particle that stands", cloud.in_contact(2));
  check("and puts it before itself",
        std::abs(piston.end.signed_distance(1, cloud.position[2])) - contact_offset * cloud.spacing[2],
        1e-15);
  const Tensor<1, 2> normal = piston.end.normal(1);
  check("with its normal velocity", (cloud.velocity[2] - step.velocity_at_end(1, cloud.position[2])) * normal,
        1e-15);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_models();
  test_table();
  test_no_slip();
  test_slip();
  return n_failed > 0;
}
