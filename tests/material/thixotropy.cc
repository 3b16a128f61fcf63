// SPDX-License-Identifier: GPL-3.0-or-later

// Test the structure of thixotropic fluids against the closed forms of Roussel's equation, in steps of any length, and what
// it makes of the yield stress of each law that has the entries.

#include "material/laws.h"

using namespace Tests;

const Entries thixotropic = {{"Flocculation time", "20"},
                             {"Deflocculation parameter", "0.05"},
                             {"Initial structure", "0.7"}};
constexpr double T = 20., alpha = 0.05, initial = 0.7;

std::unique_ptr<FluidLaw> make(const std::string &law, Entries entries)
{
  entries.insert(entries.end(), thixotropic.begin(), thixotropic.end());
  return make_law(law, entries);
}

void test_equation()
{
  const auto law               = make("Bingham", {});
  const Thixotropy &thixotropy = law->thixotropy();
  check("it is there", thixotropy.is_there());
  check("structure at the start", thixotropy.initial_structure(), initial);
  double at_rest = 0., steady = 0., transient = 0., in_parts = 0., continuous = 0.;
  bool between = true;
  for (const double time : {1e-9, 1e-3, 1., 50., 1e9})
  {
    at_rest = std::max(at_rest, std::abs(thixotropy.after(initial, 0., time) / (initial + time / T) - 1.));
    for (double rate = 1e-12; rate < 1e6; rate *= 3.)
    {
      const double limit = 1. / (T * alpha * rate), now = thixotropy.after(initial, rate, time),
                   s = alpha * rate * time;
      // Where the exponential is near one the difference of the two terms has lost its digits, not the function.
      if (s > 1e-3)
        transient = std::max(transient, std::abs(now / (limit + (initial - limit) * std::exp(-s)) - 1.));
      else
        continuous = std::max(continuous, std::abs(now - initial -
                                                   time * (1. / T - alpha * initial * rate) *
                                                     (1. - 0.5 * s + s * s / 6.)) /
                                            (initial + time / T));
      steady   = std::max(steady, std::abs(thixotropy.after(limit, rate, time) / limit - 1.));
      in_parts = std::max(
        in_parts,
        std::abs(thixotropy.after(thixotropy.after(initial, rate, 0.3 * time), rate, 0.7 * time) / now - 1.));
      between = between && now >= std::min(initial, limit) * (1. - 1e-14) &&
                now <= std::max(initial, limit) * (1. + 1e-14);
    }
  }
  check("at rest it grows by t/T", at_rest, 1e-15);
  check("in steady shear 1/(T α γ̇) stays", steady, 1e-13);
  check("the way there", transient, 1e-11);
  check("short times", continuous, 1e-10);
  check("two steps are one", in_parts, 1e-13);
  check("it stays between start and limit", between);
}

void test_yield_stress()
{
  const std::vector<std::pair<std::string, Entries>> laws = {
    {"Bingham", {{"Plastic viscosity", "2"}, {"Yield stress", "80"}}},
    {"Herschel-Bulkley", {{"Consistency", "30"}, {"Flow index", "0.4"}, {"Yield stress", "80"}}},
    {"Casson", {{"Casson viscosity", "2"}, {"Yield stress", "80"}}}};
  for (const auto &[name, entries] : laws)
  {
    const auto law = make(name, entries), without = make_law(name, entries);
    check(name + ": thixotropic if it is said",
          law->thixotropy().is_there() && !without->thixotropy().is_there());
    double error = 0., slope = 0., same = 0.;
    bool yields = true;
    sweep([&](const double rate) {
      const auto plain = without->effective_viscosity(rate, 0.),
                 found = law->effective_viscosity(rate, 0., 1.5), fresh = law->effective_viscosity(rate, 0.);
      const auto plastic    = law->plastic_part(rate);
      const double expected = plain.value + 1.5 * 80. * plastic.value;
      error                 = std::max(error, std::abs(found.value / expected - 1.));
      slope  = std::max(slope, std::abs(found.derivative - plain.derivative - 120. * plastic.derivative) *
                                 rate / expected);
      same   = std::max(same,
                        std::abs(fresh.value - plain.value) + std::abs(fresh.derivative - plain.derivative));
      yields = yields && law->is_yielded(rate, 0., 1.5) == (found.value * rate > 200.);
    });
    check(name + ": (1 + λ) τ0", law->structured_yield_stress(0., 1.5).value - 200., 1e-12);
    check(name + ": viscosity", error, 1e-14);
    check(name + ": its derivative", slope, 1e-12);
    check(name + ": without structure the same to the last digit", same, 0.);
    check(name + ": yields at (1 + λ) τ0", yields);
  }
}

void test_refused()
{
  const auto refused = [](const std::string &entry, const std::string &value, const Entries &more = {}) {
    Entries entries = more;
    entries.emplace_back(entry, value);
    check_throws<InputError>(entry + " = " + value + " is refused", {"Bingham/" + entry, value, "llowed"},
                             [&] { make_law("Bingham", entries); });
  };
  for (const char *time : {"0", "-1", "nan", "inf", "soon", ""})
    refused("Flocculation time", time);
  refused("Deflocculation parameter", "-0.1");
  refused("Initial structure", "-1");
  refused("Flocculation time", "10", {{"Yield stress", "0"}});
  refused("Initial structure", "1", {{"Yield stress", "0"}});
}

int main()
{
  test_equation();
  test_yield_stress();
  test_refused();
  return n_failed;
}
