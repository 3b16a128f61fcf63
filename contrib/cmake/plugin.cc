// SPDX-License-Identifier: GPL-3.0-or-later

// A part of each plugin: what Lahar looks for in it, and the build of Lahar that it must be loaded by.
#include <lahar/plugin.h>

extern "C" const char *const lahar_plugin;
extern "C" const char *const lahar_plugin = LAHAR_BUILD;
