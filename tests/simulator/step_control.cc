// SPDX-License-Identifier: GPL-3.0-or-later

// Test the length of the time steps: that they end on the stops, are halved after failures and grow after easy steps.

#include <lahar/simulator/step_control.h>

#include "tests.h"

using namespace Tests;

int main()
{
  {
    StepControl control(0.1, 0.01, 0.1, 30);
    check("the largest length at first", control.next(0., 1., 1e-9, 2.) - 0.1, 1e-15);
    check("a step ends on a stop", control.next(0.95, 1., 1e-9, 2.) - 0.05, 1e-15);
    check("a rest below a hundredth of a step joins it", control.next(0.8995, 1., 1e-9, 2.) - 0.1005, 1e-14);
    check("a larger one does not", control.next(0.898, 1., 1e-9, 2.) - 0.1, 1e-14);
    check("halves are taken where a limit asks for it", control.next(0., 1., 50., 2.) - 0.025, 1e-15);
    check("not below the smallest length", control.next(0., 1., 2000., 2.) - 0.0125, 1e-15);
    check("afterwards the length is as before", control.next(0., 1., 1e-9, 2.) - 0.1, 1e-15);
  }
  {
    StepControl control(0.1, 0.01, 0.1, 30);
    double tried = control.next(0., 1., 1e-9, 2.);
    check("a failed step is halved", control.halve(tried) && std::abs(tried - 0.05) < 1e-15);
    check("and halved again", control.halve(tried) && std::abs(tried - 0.025) < 1e-15);
    check("the next step has that length", control.next(0.025, 1., 1e-9, 2.) - 0.025, 1e-15);
    control.accept(5);
    control.accept(12);
    check("two easy steps are not enough to grow", control.next(0.1, 1., 1e-9, 2.) - 0.025, 1e-15);
    control.accept(13);
    control.accept(5);
    control.accept(5);
    check("a hard one starts the count anew", control.next(0.1, 1., 1e-9, 2.) - 0.025, 1e-15);
    control.accept(5);
    check("after three it is doubled", control.next(0.1, 1., 1e-9, 2.) - 0.05, 1e-15);
    for (unsigned int i = 0; i < 6; ++i)
      control.accept(5);
    check("up to the largest length", control.next(0.1, 1., 1e-9, 2.) - 0.1, 1e-15);
  }
  {
    StepControl control(0.1, 0.01, 0.1, 30);
    double tried = control.next(0.97, 1., 1e-9, 2.); // shortened by the stop
    check("a shortened step is halved from its own length",
          control.halve(tried) && std::abs(tried - 0.015) < 1e-14);
    check("below the smallest length there is no further one", !control.halve(tried));
  }
  {
    const StepControl control(0.1, 0.01, 0.1, 30);
    check("steps stop where something is due", control.stop(0.5, 1.) - 0.5, 1e-15);
    check("or at the end if that comes before", control.stop(1.5, 1.) - 1., 1e-15);
    check("and where that comes right after", control.stop(1. - 1e-6, 1.) - 1., 1e-15);
    check("but not where a step fits between", control.stop(0.998, 1.) - 0.998, 1e-15);
  }
  {
    StepControl control(0.1, 0.01, 0.35, 30);
    check("the first step has the usual length", control.next(0., 2., 1e-9, 2.) - 0.1, 1e-15);
    for (unsigned int i = 0; i < 3; ++i)
      control.accept(5);
    check("slow flow lets easy steps grow beyond it", control.next(0., 2., 1e-9, 2.) - 0.2, 1e-15);
    for (unsigned int i = 0; i < 6; ++i)
      control.accept(5);
    check("up to the largest length", control.next(0., 2., 1e-9, 2.) - 0.35, 1e-15);
    check("as far as particles move by a tenth of their spacing", control.next(0., 2., 0.5, 2.) - 0.2, 1e-15);
    check("faster flow has the usual length", control.next(0., 2., 10., 2.) - 0.1, 1e-15);
    check("or half of it", control.next(0., 2., 30., 2.) - 0.05, 1e-15);
    double tried = control.next(0., 2., 1e-9, 2.);
    check("a long step that fails is halved", control.halve(tried) && std::abs(tried - 0.175) < 1e-15);
    check("and so is the next", control.next(0., 2., 1e-9, 2.) - 0.175, 1e-15);
  }
  return n_failed;
}
