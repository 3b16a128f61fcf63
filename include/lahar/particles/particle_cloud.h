// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_particles_particle_cloud_h
#define lahar_particles_particle_cloud_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// What a particle is: it moves with the fluid, it belongs to a rigid wall, or it is a node of a solid's contour. On a
  /// contour along which fluid slides it is slick: no vertex of the fluid's mesh, since fluid lands on its facets.
  enum class ParticleKind : unsigned char
  {
    fluid,
    wall,
    solid,
    slick_solid
  };

  /**
   * The particles: the only state of the fluid that persists from step to step.
   *
   * A structure of arrays, one entry a particle in each. Indices stay valid until remove() or append(); meshes refer to
   * particles by index. Units are SI; pressure is positive in tension.
   *
   * On several ranks a cloud holds the particles that its rank owns and copies of others; particles are in the order of
   * their numbers, which are the same on all ranks.
   */
  template <int dim>
  class ParticleCloud
  {
  public:
    /// Marks an unused entry of #contact_facets.
    static constexpr int no_facet = -1;

    /// Marks a particle in #structure that has none.
    static constexpr double no_structure = -1.;

    std::vector<Point<dim>> position;         ///< m
    std::vector<Tensor<1, dim>> velocity;     ///< m/s
    std::vector<Tensor<1, dim>> acceleration; ///< m/s²
    std::vector<Tensor<1, dim>>
      algorithmic_acceleration;        ///< of the time integration, m/s², see TimeIntegration
    std::vector<double> pressure;      ///< Pa
    std::vector<double> pressure_rate; ///< Pa/s
    std::vector<double> owed_volume;   ///< m^dim; what the fluid has too much around it, see VolumeCorrection
    std::vector<Tensor<1, dim>> reaction; ///< mean force of wall or solid on the fluid in the last step, N
    std::vector<Tensor<1, dim>>
      friction; ///< where it slides: the multiplier of the friction, see SlidingContact
    std::vector<std::vector<double>>
      structure; ///< by fluid, and then by particle: the structure parameter λ of Thixotropy, none where below zero;
                 ///< empty if no fluid is thixotropic
    std::vector<ParticleKind> kind;
    std::vector<unsigned int>
      part; ///< of a fluid particle the FluidSet that it belongs to, of others the number of their boundary or solid
    std::vector<double> spacing;                      ///< wanted distance h to the next particles, m
    std::vector<std::array<int, dim>> contact_facets; ///< facets of walls on which the particle lies
    std::vector<std::uint64_t> number;                ///< identifies the particle, ascending
    std::vector<unsigned int> owner;                  ///< the rank that it belongs to

    unsigned int rank         = 0; ///< this rank
    std::uint64_t next_number = 0; ///< of the next new particle

    std::size_t size() const
    {
      return position.size();
    }

    bool is_own(const unsigned int particle) const
    {
      return owner[particle] == rank;
    }

    /// The owner of a cell, by its corners: that of its first fluid particle (of its first one if none is fluid).
    unsigned int owner_of(const std::array<unsigned int, dim + 1> &cell) const;

    bool is_own(const std::array<unsigned int, dim + 1> &cell) const
    {
      return owner_of(cell) == rank;
    }

    /// Append a particle of this rank at rest, without pressure and without contact to a wall. Return its index.
    unsigned int append(const Point<dim> &position, const ParticleKind kind, const double spacing,
                        const unsigned int part = 0);

    /**
     * Append a fluid particle in the middle between particles @p a and @p b: position, velocity, accelerations,
     * pressure, its rate, friction, structure and spacing are their means; it lies on the facets that both share and
     * belongs to the owner of @p a, and to the fluids that those of them share that are fluid, or else to all of theirs.
     * Return its index.
     */
    unsigned int append_midpoint(const unsigned int a, const unsigned int b);

    /// Let the particle have, of each fluid, the mean structure of particles @p a and @p b; that of one if only one has it.
    void set_mean_structure(const unsigned int particle, const unsigned int a, const unsigned int b);

    /**
     * Remove the particles whose entry in @p removed is true; the others keep their order.
     *
     * @return for each old index the new one, numbers::invalid_unsigned_int for a removed particle.
     */
    std::vector<unsigned int> remove(const std::vector<bool> &removed);

    /// How many numbers tell all of a particle, to send it. The last one is its owner.
    unsigned int record_size() const
    {
      return 7 * dim + 8 + structure.size();
    }

    /// Append the numbers of a particle.
    void append_record(const unsigned int particle, std::vector<double> &records) const;

    /// Make a particle what record_size() numbers say.
    void set(const unsigned int particle, const double *record);

    /// Add the particles of some records, in each one behind the other in any order, and sort all by their numbers; of
    /// those with the same number the first one counts. Rank and next number stay.
    void add(std::vector<std::vector<double>> records);

    /// Replace all particles by those of @p records.
    void reinit(const std::vector<double> &records);

    /// Index of the particle with a number; numbers::invalid_unsigned_int if it is not here.
    unsigned int find(const std::uint64_t particle_number) const;

    /// Number of this rank's own particles of one kind.
    unsigned int n_particles(const ParticleKind kind) const;

    /// Whether the particle lies on at least one wall.
    bool in_contact(const unsigned int particle) const;

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &position &velocity &acceleration &algorithmic_acceleration &pressure &pressure_rate
        &owed_volume &reaction &friction &structure &kind &part &spacing &contact_facets &number &owner
          &next_number;
    }

  private:
    /// Do something with each array that has an entry a particle.
    template <typename Action>
    void for_each_array(const Action &action)
    {
      action(position);
      action(velocity);
      action(acceleration);
      action(algorithmic_acceleration);
      action(pressure);
      action(pressure_rate);
      action(owed_volume);
      action(reaction);
      action(friction);
      for (std::vector<double> &of_fluid : structure)
        action(of_fluid);
      action(kind);
      action(part);
      action(spacing);
      action(contact_facets);
      action(number);
      action(owner);
    }
  };
} // namespace Lahar

#endif
