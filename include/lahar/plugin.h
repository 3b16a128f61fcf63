// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_plugin_h
#define lahar_plugin_h

#include <deal.II/base/config.h>

#include <lahar/version.h>

/**
 * The name of a constant in Lahar's library that says how it was built: version of Lahar and deal.II, Debug or Release. A
 * plugin refers to the one that it was built with, so that it cannot be loaded by a Lahar that was built otherwise.
 */
#ifdef DEBUG
#  define LAHAR_BUILD_NAME Debug
#else
#  define LAHAR_BUILD_NAME Release
#endif
#define LAHAR_JOIN(version, major, minor, build) lahar_##version##_dealii_##major##_##minor##_##build
#define LAHAR_JOIN_VALUES(version, major, minor, build) LAHAR_JOIN(version, major, minor, build)
#define LAHAR_BUILD \
  LAHAR_JOIN_VALUES(LAHAR_VERSION_NAME, DEAL_II_VERSION_MAJOR, DEAL_II_VERSION_MINOR, LAHAR_BUILD_NAME)

extern "C" const char LAHAR_BUILD[];

#endif
