// SPDX-License-Identifier: GPL-3.0-or-later

// Test the law of a table: the rows of other laws give these laws, the derivative equals differences, the stress grows, and
// wrong files are refused with the line.

#include <fstream>

#include "material/laws.h"

using namespace Tests;

/// A table with a row for each of the strain rates.
std::string write_table(const FluidLaw &law, const std::vector<double> &rates)
{
  const std::string name = "stresses.csv";
  std::ofstream file(name);
  file << "# strain rate (1/s), stress (Pa)\r\n" << std::setprecision(17);
  for (const double rate : rates)
    file << rate << " , " << law.yield_stress(0.).value + rate * law.viscous_part(rate, 0.).value << "\r\n";
  return name;
}

std::unique_ptr<FluidLaw> table(const FluidLaw &law, const std::vector<double> &rates)
{
  return make_law("table", {{"File", write_table(law, rates)}});
}

void test_tables()
{
  const auto bingham = make_law("Bingham", {{"Plastic viscosity", "2"}, {"Yield stress", "80"}});
  test_same("the table of Bingham's law is Bingham's law", *table(*bingham, {0., 0.3, 1., 40., 1000.}),
            *bingham, 1e-12);
  test_same("... with two rows", *table(*bingham, {0., 25.}), *bingham, 1e-12);
  test_same("the table of Newton's law is Newton's law", *table(*newtonian(0.3), {0.1, 1., 2.}),
            *newtonian(0.3), 1e-12);

  // Rates at which ε is nothing, and above the first of which the table is compared.
  const auto compare = [](const std::string &what, const FluidLaw &a, const FluidLaw &b,
                          const double tolerance) {
    double error = 0.;
    for (double rate = 1.0001; rate < 1e4; rate *= 1.1)
      error = std::max(
        error, std::abs(a.effective_viscosity(rate, 0.).value / b.effective_viscosity(rate, 0.).value - 1.));
    check(what, error, tolerance);
  };
  const auto thinning = herschel_bulkley(0.4, tau_0);
  compare("the table of Herschel and Bulkley's law is that law, beyond its last row too",
          *table(*thinning, {0., 1., 7., 100.}), *thinning, 1e-8);
  std::vector<double> rates;
  for (double rate = 0.1; rate < 2e4; rate *= 2.)
    rates.push_back(rate);
  const auto blood = carreau(0.056, 0.00345, 3.313, 0.3568, 2.);
  const auto law   = table(*blood, rates);
  compare("twenty rows of Carreau's law give it to half a percent", *law, *blood, 5e-3);
  check("without a row at rest: no yield stress", law->yield_stress(0.).value, 0.);
  check("... and a constant viscosity below the first row",
        law->viscous_part(0., 0.).value / blood->viscous_part(0.1, 0.).value - 1., 1e-14);
  check("... of derivative 0", law->viscous_part(0.05, 0.).derivative, 0.);

  // A law of measured values: differences, from both sides at the rows.
  std::ofstream("measured.csv")
    << "\xef\xbb\xbf# a mud\n0, 12\n\n0.1, 12.2 # slow\n1,14\n10,14.5\n100,41\n1000,180\n";
  const auto measured = make_law("table", {{"File", "measured.csv"}});
  check("the stress at rest is the yield stress", measured->yield_stress(0.).value - 12., 0.);
  double difference_error = 0., previous_stress = 0.;
  bool grows = true;
  sweep([&](const double rate) {
    const double step  = 1e-6 * rate;
    const auto at      = [&](const double r) { return measured->effective_viscosity(r, 0.).value; };
    difference_error   = std::max(difference_error,
                                  std::abs(measured->effective_viscosity(rate, 0.).derivative -
                                           (at(rate + step) - at(rate - step)) / (2. * step)) *
                                    rate / at(rate));
    const double slope = at(rate) + rate * measured->effective_viscosity(rate, 0.).derivative;
    grows              = grows && rate * at(rate) > previous_stress && slope > 0.;
    previous_stress    = rate * at(rate);
  });
  check("the table's derivative equals differences", difference_error, 1e-8);
  check("the table's stress grows", grows);
  double row_error = 0., kink = 0.;
  for (const auto &[rate, stress] : std::vector<std::pair<double, double>>{
         {0.1, 12.2}, {1., 14.}, {10., 14.5}, {100., 41.}, {1000., 180.}})
  {
    row_error = std::max(row_error, std::abs(rate * measured->viscous_part(rate, 0.).value + 12. - stress));
    if (rate > 0.1)
      kink = std::max(kink, std::abs(measured->viscous_part(rate * (1. + 1e-12), 0.).derivative /
                                       measured->viscous_part(rate * (1. - 1e-12), 0.).derivative -
                                     1.));
  }
  check("the table's stresses are met", row_error, 1e-12);
  check("its derivative is continuous at the rows", kink, 1e-8);
}

void test_refused()
{
  for (const auto &[entry, value] : Entries{{"Regularization parameter", "0"}, {"File", ""}})
    check_throws<InputError>("table: " + entry + " = " + value + " is refused",
                             {"'table/" + entry + "'", "'" + value + "'", "Allowed"},
                             [&, e = entry, v = value]() {
                               make_law("table", {{e, v}});
                             });
  const auto refuse = [](const std::string &what, const std::string &text,
                         const std::vector<std::string> &parts) {
    std::ofstream("wrong.csv") << text;
    check_throws<InputError>("table: " + what + " is refused", parts, [] {
      make_law("table", {{"File", "wrong.csv"}});
    });
  };
  const auto line = [](const unsigned int n) { return "wrong.csv:" + std::to_string(n) + ":"; };
  refuse("a head without #", "rate, stress\n0, 1\n1, 2\n", {line(1), "'rate, stress'", "2 numbers", "#"});
  refuse("text in a row", "# head\n0, 1\n1, two\n", {line(3), "'1, two'", "2 numbers"});
  refuse("a number that is none", "0, 1\n1, nan\n", {line(2), "'1, nan'"});
  refuse("a row of three", "0, 1\n1, 2, 3\n", {line(2), "'1, 2, 3'"});
  refuse("a row of one", "0, 1\n\n2\n", {line(3), "'2'"});
  refuse("another separator", "0; 1\n1; 2\n", {line(1), "'0; 1'", "separated by ','"});
  refuse("a negative strain rate", "-1, 1\n1, 2\n", {line(1), "'-1, 1'", "zero or above"});
  refuse("a negative stress", "0, -1\n1, 2\n", {line(1), "'0, -1'", "zero or above"});
  refuse("no stress in a flow", "1, 0\n2, 1\n", {line(1), "'1, 0'", "above zero"});
  refuse("a strain rate that does not grow", "0, 1\n2, 2\n2, 3\n", {line(3), "'2, 3'", "larger"});
  refuse("a stress that does not grow", "0, 1\n1, 3\n2, 3\n", {line(3), "'2, 3'", "larger"});
  refuse("a single row", "0, 1\n", {"'wrong.csv'", "1 lines", "at least two"});
  refuse("an empty file", "", {"'wrong.csv'", "0 lines", "at least two"});
  check_throws<InputError>("table: a missing file is refused", {"'nowhere.csv'", "does not exist", "Allowed"},
                           [] {
                             make_law("table", {{"File", "nowhere.csv"}});
                           });
  check_throws<InputError>("table: a directory is refused", {"'.'", "is a directory", "Allowed"}, [] {
    make_law("table", {{"File", "."}});
  });
}

int main()
{
  test_tables();
  test_refused();
  return n_failed;
}
