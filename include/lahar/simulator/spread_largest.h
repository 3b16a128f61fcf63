// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_spread_largest_h
#define lahar_simulator_spread_largest_h

#include <boost/pending/disjoint_sets.hpp>

#include <lahar/linear/node_partition.h>

namespace Lahar
{
  /// Give all nodes of a part the largest of their @p values, which are not negative, also over ranks. @p parts are sets of
  /// nodes that hang together, by local number. Collective.
  void spread_largest(boost::disjoint_sets_with_storage<> &parts, const NodePartition &partition,
                      IndexVector<LocalNode, double> &values);
} // namespace Lahar

#endif
