// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/walls.h>
#include <lahar/solid/solids.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace Lahar
{
  namespace
  {
    /// No solid is wider than so many mesh sizes, or narrower than the inverse.
    constexpr double largest_extent = 1e5;
  } // namespace



  template <int dim>
  void Solids<dim>::declare_parameters(Parameters &prm, const std::vector<std::string> &names)
  {
    prm.enter_subsection("Solids");
    prm.declare_count(
      "Degree", "2", "Degree of the solids' displacements: 1 or 2. Linear elements are too stiff in bending.",
      1, 2);
    prm.declare_count("Largest number of nodes", "1000000",
                      "A case is refused if its solids ask for more nodes than this, 1 to 100000000.", 1,
                      100000000);
    prm.declare_number(
      "Newmark gamma", "1.5",
      "Newmark's γ for the solids, 0.5 to 1.5. 0.5 keeps the energy; larger values damp vibrations.", 0.5,
      1.5);
    const std::map<std::string, std::string> entries = prm.values();
    for (const std::string &name : names)
    {
      if (entries.count(prm.path(name)) > 0)
        throw InputError("'Solids' has the name '" + name +
                         "', which is an entry of subsection 'Solids'. Allowed: "
                         "another name.");
      prm.enter_subsection(name);
      SolidBody<dim>::declare_parameters(prm);
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }



  template <int dim>
  void Solids<dim>::parse_parameters(Parameters &prm, const std::vector<std::string> &names)
  {
    prm.enter_subsection("Solids");
    degree    = prm.get_count("Degree", 1, 2);
    max_nodes = prm.get_count("Largest number of nodes", 1, 100000000);
    gamma     = prm.get_in_range("Newmark gamma", 0.5, 1.5);
    for (const std::string &name : names)
    {
      prm.enter_subsection(name);
      bodies.emplace_back();
      bodies.back().parse_parameters(prm, name);
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<std::string> Solids<dim>::create(const MeshSize<dim> &mesh_size, const double time,
                                               const bool is_loaded)
  {
    const double h = mesh_size.coarsest();
    std::vector<std::string> warnings;
    solid_mesh = std::make_unique<SolidMesh<dim>>(degree);
    if (empty())
      return warnings;
    std::vector<Point<dim>> vertices, drawn_vertices;
    std::vector<CellData<dim>> cells;
    double n_asked = 0.;
    for (unsigned int body = 0; body < bodies.size(); ++body)
    {
      const double size = mesh_size.finest_in(bodies[body].box());
      n_asked += bodies[body].shape->estimate_size(degree * size, degree);
      if (!(n_asked <= max_nodes))
      {
        std::ostringstream message;
        message << "The solids up to '" << bodies[body].name << "' have about " << n_asked
                << " nodes at the mesh size " << size
                << " m. Allowed: 'Solids/Largest number of nodes', which is " << max_nodes
                << "; 'box/Elements' sets the number of elements of a box.";
        throw InputError(message.str());
      }
      const Box<dim> box = bodies[body].shape->box();
      for (unsigned int d = 0; d < dim; ++d)
        if (const double extent = (box.upper[d] - box.lower[d]) / h;
            !(extent > 1. / largest_extent && extent < largest_extent))
        {
          std::ostringstream message;
          message << "Solid '" << bodies[body].name << "' is " << extent << " times 'Mesh size', which is "
                  << h << " m, wide in direction "
                  << "xyz"[d] << ". Allowed: " << 1. / largest_extent << " to " << largest_extent
                  << " times.";
          throw InputError(message.str());
        }
      if (const std::string path = bodies[body].shape->scale_path(); !path.empty())
        for (const std::string &text : warn_of_extent("the elements of solid '" + bodies[body].name + "'",
                                                      bodies[body].shape->box(), h, path))
          warnings.push_back(text);
      bodies[body].shape->append(degree * size, body, vertices, cells);
      for (unsigned int v = drawn_vertices.size(); v < vertices.size(); ++v)
      {
        drawn_vertices.push_back(vertices[v]);
        if (bodies[body].ground)
          vertices[v] = bodies[body].ground->raised(vertices[v]);
      }
    }
    solid_mesh->reinit(vertices, cells);
    find_drawn(drawn_vertices);
    const SolidMesh<dim> &mesh = *solid_mesh;
    const unsigned int n       = mesh.n_nodes();
    tolerance                  = 1e-6 * h;

    check_contour();
    double widest = 0., narrowest = std::numeric_limits<double>::max();
    for (const auto &facet : mesh.contour())
      for (unsigned int v = 0; v < dim; ++v)
      {
        const double length = mesh.reference_position(facet[v]).distance(
          mesh.reference_position(facet[(v + 1) % dim]));
        widest    = std::max(widest, length);
        narrowest = std::min(narrowest, length);
      }
    place_tolerance = 1e-3 * narrowest;
    find_unevenness();

    present.position.resize(n);
    present.velocity.resize(n);
    present.acceleration.assign(n, Tensor<1, dim>());
    present.algorithmic_acceleration.assign(n, Tensor<1, dim>());
    present.reaction.assign(n, Tensor<1, dim>());
    present.stress.assign(mesh.n_cells() * mesh.points_per_cell(), SymmetricTensor<2, 3>());
    clamped.assign(n, false);
    driven.assign(n, false);
    std::vector<unsigned int> n_clamped(bodies.size(), 0), n_driven(bodies.size(), 0),
      n_loaded(bodies.size(), 0);
    for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int b        = mesh.body_of_node(i);
      const SolidBody<dim> &body  = bodies[b];
      const Point<dim> &reference = mesh.reference_position(i);
      present.position[i]         = reference;
      for (unsigned int d = 0; d < dim; ++d)
        present.velocity[i][d] = body.initial_velocity->value(reference, d);
      if (i < mesh.n_contour_nodes())
      {
        clamped[i] = body.clamped.contains(drawn[i], place_tolerance);
        driven[i]  = !clamped[i] && body.driven.contains(drawn[i], place_tolerance);
        n_clamped[b] += clamped[i];
        n_driven[b] += driven[i];
      }
      if (is_fixed(i))
        present.velocity[i] = prescribed_velocity(i, time);
    }
    for (const auto &cell : mesh.dof_handler().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) &&
            bodies[cell->material_id()].loaded.contains(drawn_middle(cell, f), place_tolerance))
          ++n_loaded[cell->material_id()];
    any_loads = std::any_of(n_loaded.begin(), n_loaded.end(), [](const unsigned int k) { return k > 0; });

    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const std::pair<const typename SolidBody<dim>::Prescribed *, unsigned int> parts[] = {
        {&bodies[b].clamped, n_clamped[b]},
        {&bodies[b].driven, n_driven[b]},
        {&bodies[b].loaded, n_loaded[b]}};
      for (const auto &[part, count] : parts)
        if (!part->where.empty() && count == 0)
          throw InputError("Parameter '" + part->path + "' is '" + part->text +
                           "', which holds no part of the contour of solid '" + bodies[b].name +
                           "'. Allowed: boxes that hold nodes of the contour (for loads: middles of faces).");
    }
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (!is_loaded && n_clamped[b] + n_driven[b] + n_loaded[b] == 0)
        warnings.push_back(
          "Warning: solid '" + bodies[b].name +
          "' is neither clamped, driven nor loaded, and there is no fluid and no gravity: only "
          "its initial velocity moves it.");

    if (widest > 3. * h)
    {
      std::ostringstream text;
      text << "Warning: nodes on the solids' contour are up to " << widest
           << " m apart, more than three times the mesh size of " << h << " m.";
      warnings.push_back(text.str());
    }
    return warnings;
  }



  template <int dim>
  void Solids<dim>::check_contour() const
  {
    std::vector<WallFacet<dim>> facets;
    for (const auto &nodes : solid_mesh->contour())
    {
      WallFacet<dim> facet;
      for (unsigned int v = 0; v < dim; ++v)
        facet.corners[v] = solid_mesh->reference_position(nodes[v]);
      facets.push_back(facet);
    }
    const Walls<dim> contour(facets);
    for (unsigned int i = 0; i < solid_mesh->n_contour_nodes(); ++i)
    {
      const Point<dim> &point = solid_mesh->reference_position(i);
      for (const unsigned int f : contour.near(point, tolerance))
      {
        const auto &nodes = solid_mesh->contour()[f];
        if (std::find(nodes.begin(), nodes.end(), i) != nodes.end() ||
            std::abs(contour.signed_distance(f, point)) > tolerance || !contour.is_above(f, point, tolerance))
          continue;
        const unsigned int a = solid_mesh->body_of_node(i), b = solid_mesh->body_of_node(nodes[0]);
        std::ostringstream message;
        message << "Solid '" << bodies[a].name << "' "
                << (a == b ? "has a hanging node" : "touches solid '" + bodies[b].name + "'") << " at ("
                << point
                << ") m. Allowed: solids apart from each other, whose elements share whole edges and faces.";
        throw InputError(message.str());
      }
    }
  }



  template <int dim>
  void Solids<dim>::append_particles(const MeshSize<dim> &mesh_size, const std::vector<bool> &slick,
                                     ParticleCloud<dim> &cloud) const
  {
    Assert(cloud.size() == 0, ExcInternalError());
    if (empty())
      return;
    std::vector<double> spacing;
    for (unsigned int i = 0; i < solid_mesh->n_contour_nodes(); ++i)
      spacing.push_back(mesh_size(present.position[i]));
    for (const auto &facet : solid_mesh->contour())
      for (unsigned int v = 0; v < dim; ++v)
        for (const unsigned int other : facet)
          spacing[facet[v]] = std::max(spacing[facet[v]],
                                       present.position[facet[v]].distance(present.position[other]));
    for (unsigned int i = 0; i < solid_mesh->n_contour_nodes(); ++i)
    {
      const unsigned int body = solid_mesh->body_of_node(i);
      cloud.append(present.position[i], slick[body] ? ParticleKind::slick_solid : ParticleKind::solid,
                   spacing[i], body);
      cloud.velocity[i] = present.velocity[i];
    }
  }



  template <int dim>
  Tensor<1, dim> Solids<dim>::prescribed_velocity(const unsigned int node, const double time) const
  {
    if (clamped[node])
      return Tensor<1, dim>();
    const SolidBody<dim> &body = bodies[solid_mesh->body_of_node(node)];
    return body.driven.value(solid_mesh->reference_position(node), time);
  }



  template <int dim>
  std::vector<Tensor<1, dim>> Solids<dim>::external_forces(const double time) const
  {
    std::vector<Tensor<1, dim>> forces;
    if (!any_loads)
      return forces;
    forces.resize(solid_mesh->n_nodes());
    const auto &dofs = solid_mesh->dof_handler();
    FEFaceValues<dim> values(solid_mesh->mapping(), dofs.get_fe(), QGaussSimplex<dim - 1>(3),
                             update_values | update_JxW_values | update_quadrature_points);
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
      {
        const auto &loaded = bodies[cell->material_id()].loaded;
        if (!cell->at_boundary(f) || !loaded.contains(drawn_middle(cell, f), place_tolerance))
          continue;
        values.reinit(cell, f);
        const unsigned int *nodes = solid_mesh->cell_nodes(cell->active_cell_index());
        for (const unsigned int q : values.quadrature_point_indices())
        {
          const Tensor<1, dim> force = values.JxW(q) * loaded.value(values.quadrature_point(q), time);
          for (unsigned int I = 0; I < solid_mesh->nodes_per_cell(); ++I)
            forces[nodes[I]] += values.shape_value(I, q) * force;
        }
      }
    return forces;
  }



  template <int dim>
  void Solids<dim>::move_particles(const std::vector<bool> &in_mesh, ParticleCloud<dim> &cloud) const
  {
    if (empty())
      return;
    for (unsigned int i = 0; i < solid_mesh->n_contour_nodes(); ++i)
    {
      cloud.position[i] = present.position[i];
      if (!in_mesh[i])
      {
        cloud.velocity[i]                 = present.velocity[i];
        cloud.acceleration[i]             = present.acceleration[i];
        cloud.algorithmic_acceleration[i] = present.algorithmic_acceleration[i];
        cloud.pressure[i]                 = 0.;
        cloud.pressure_rate[i]            = 0.;
      }
    }
  }



  template <int dim>
  double Solids<dim>::longest_edge() const
  {
    double longest_square = 0.;
    if (!empty())
      for (unsigned int c = 0; c < solid_mesh->n_cells(); ++c)
      {
        const unsigned int *nodes = solid_mesh->cell_nodes(c);
        for (unsigned int I = 0; I < solid_mesh->nodes_per_cell(); ++I)
          for (unsigned int J = 0; J < I; ++J)
            longest_square = std::max(longest_square,
                                      present.position[nodes[I]].distance_square(present.position[nodes[J]]));
      }
    return std::sqrt(longest_square);
  }



  template class Solids<2>;
  template class Solids<3>;
} // namespace Lahar
