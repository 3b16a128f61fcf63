// SPDX-License-Identifier: GPL-3.0-or-later

// Test the registry of models: which of them have entries and a subsection, what is read when one is created, the
// answer to a wrong name, and a second model of one name.

#include <lahar/utilities/factory.h>

#include "tests.h"

#include <sstream>

using namespace Tests;

/// A kind with a function declare_parameters() of its own, as laws and schemes have it.
struct Shape
{
  virtual ~Shape() = default;

  static void declare_parameters(Parameters &prm)
  {
    Factory<Shape>::declare_choice(prm, "Shape", "point", "What it looks like.");
    Factory<Shape>::declare_parameters(prm);
  }

  virtual void parse_parameters(Parameters &prm)
  {
    size = prm.get_positive("Size");
  }

  double size = 0.;
};

struct PointShape : Shape
{};

struct Ball : Shape
{
  static void declare_parameters(Parameters &prm)
  {
    prm.declare_entry("Size", "2", Patterns::Anything());
  }
};

/// Inherits the entries of another model.
struct HollowBall : Ball
{};

/// A kind without such a function.
struct Colour
{
  virtual ~Colour() = default;
  virtual void parse_parameters(Parameters & /*prm*/) {}
};

struct Red : Colour
{};

static const Factory<Shape>::Registration<PointShape> point("point", "Without extent.");
static const Factory<Shape>::Registration<Ball> ball("ball", "Round.", "Sphere");
static const Factory<Shape>::Registration<HollowBall> hollow_ball("hollow ball", "Round and empty.");
static const Factory<Colour>::Registration<Red> red("red", "Like a rose.");

int main()
{
  Parameters prm;
  Shape::declare_parameters(prm);
  Factory<Colour>::declare_parameters(prm);
  const std::map<std::string, std::string> expected = {{"Shape", "point"},
                                                       {"Sphere/Size", "2"},
                                                       {"hollow ball/Size", "2"}};
  check("each model's own entries, in the subsection of its name or of its choice", prm.values() == expected);
  const auto has = [&](const ParameterHandler::OutputStyle style, const std::string &part) {
    std::ostringstream text;
    prm.print_parameters(text, style);
    return text.str().find(part) != std::string::npos;
  };
  check("no subsection for a model without entries",
        !has(ParameterHandler::PRM, "subsection point") && !has(ParameterHandler::PRM, "subsection red"));
  check("the choice explains the models, and has their names for programs",
        has(ParameterHandler::JSON, "'ball': Round.") &&
          has(ParameterHandler::JSON, "'point': Without extent.") &&
          has(ParameterHandler::JSON, "[Selection ball|hollow ball|point"));

  check("a model without entries", Factory<Shape>::create("point", prm)->size, 0.);
  check("a model with entries", Factory<Shape>::create("ball", prm)->size - 2., 0.);
  prm.enter_subsection("hollow ball");
  prm.set("Size", "3");
  prm.leave_subsection();
  check("a model with another model's entries", Factory<Shape>::create("hollow ball", prm)->size - 3., 0.);
  check("a kind without entries", dynamic_cast<Red *>(Factory<Colour>::create("red", prm).get()) != nullptr);
  check("the default is one of the names", Factory<Shape>::choice(prm, "Shape") == "point");

  prm.set("Shape", "cube");
  check_throws<InputError>("a wrong name is answered with all names",
                           {"Parameter 'Shape' is 'cube'. Allowed: ball|hollow ball|point."},
                           [&] { Factory<Shape>::choice(prm, "Shape"); });

  const Factory<Shape>::Registration<Ball> second("point", "The second of this name.");
  check("a second model of one name is not taken", doubled_model_names().size() == 1 &&
                                                     doubled_model_names()[0] == "point" &&
                                                     Factory<Shape>::create("point", prm)->size == 0.);
  return n_failed;
}
