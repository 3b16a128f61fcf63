#ifndef lahar_particles_particle_cloud_h
#define lahar_particles_particle_cloud_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// What a particle is: it moves with the fluid, it rests on a rigid no-slip wall, or it is a node of a solid's
  /// contour.
  enum class ParticleKind : unsigned char
  {
    fluid,
    wall,
    solid
  };

  /**
   * The particles: the only state of the fluid that persists from step to step.
   *
   * A structure of arrays, one entry a particle in each. Indices stay valid until remove() or append(); meshes refer to
   * particles by index. Units are SI; pressure is positive in tension.
   */
  template <int dim>
  class ParticleCloud
  {
  public:
    /// Marks an unused entry of #slip_facets.
    static constexpr int no_facet = -1;

    std::vector<Point<dim>> position;         ///< m
    std::vector<Tensor<1, dim>> velocity;     ///< m/s
    std::vector<Tensor<1, dim>> acceleration; ///< m/s²
    std::vector<double> pressure;             ///< Pa
    std::vector<double> pressure_rate;        ///< Pa/s
    std::vector<ParticleKind> kind;
    std::vector<double> spacing;                   ///< wanted distance h to the next particles, m
    std::vector<std::array<int, dim>> slip_facets; ///< facets of the slip walls on which the particle slides

    std::size_t size() const
    {
      return position.size();
    }

    /// Append a particle at rest, without pressure and without contact to a slip wall. Return its index.
    unsigned int append(const Point<dim> &position, const ParticleKind kind, const double spacing);

    /**
     * Append a fluid particle in the middle between particles @p a and @p b: position, velocity, acceleration,
     * pressure, its rate and spacing are their means; it slides on the slip facets that both share. Return its index.
     */
    unsigned int append_midpoint(const unsigned int a, const unsigned int b);

    /**
     * Remove the particles whose entry in @p removed is true; the others keep their order.
     *
     * @return for each old index the new one, numbers::invalid_unsigned_int for a removed particle.
     */
    std::vector<unsigned int> remove(const std::vector<bool> &removed);

    /// Number of particles of one kind.
    unsigned int n_particles(const ParticleKind kind) const;

    /// Whether the particle slides on at least one slip wall.
    bool on_slip_wall(const unsigned int particle) const;

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &position &velocity &acceleration &pressure &pressure_rate &kind &spacing &slip_facets;
    }
  };
} // namespace Lahar

#endif
