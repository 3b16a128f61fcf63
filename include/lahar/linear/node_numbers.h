// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_node_numbers_h
#define lahar_linear_node_numbers_h

#include <lahar/utilities/index.h>

namespace Lahar
{
  /// Vertex of the mesh of the particles in a rank's region.
  using RegionVertex = Index<struct RegionVertexTag>;
  /// Node as a rank numbers those that it has heard of: the vertices of its region's mesh, and behind these the solids'
  /// own nodes.
  using RegionNode = Index<struct RegionNodeTag>;
  /// Vertex of the part of that mesh that the rank works on; the fluid number of BlockSystem.
  using Vertex = Index<struct VertexTag>;
  /// Node that the rank works on: own ones, the halo, the outer ones; the local number of NodePartition.
  using LocalNode = Index<struct LocalNodeTag>;
  /// Node in the order of the ranks; the global number of NodePartition.
  using GlobalNode = Index<struct GlobalNodeTag>;
  /// Node of the solids' mesh.
  using SolidNode = Index<struct SolidNodeTag>;
} // namespace Lahar

#endif
