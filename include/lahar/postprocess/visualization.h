#ifndef lahar_postprocess_visualization_h
#define lahar_postprocess_visualization_h

#include <lahar/postprocess/postprocessor.h>

#include <string>
#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * Writes solution-NNNNN.vtu files and solution.pvd, which lists them with their times, for ParaView.
   *
   * Point data: velocity, pressure, particle_kind (0 fluid, 1 wall, 2 solid). Cell data: strain_rate, effective_viscosity,
   * yielded. Files are written under a temporary name first, so that each that has its final name is complete.
   */
  template <int dim>
  class Visualization
  {
  public:
    /// @param directory output directory, which exists.
    explicit Visualization(const std::string &directory);

    void write(const Snapshot<dim> &snapshot);

  private:
    std::string directory;
    std::vector<std::pair<double, std::string>> records;
  };
} // namespace Lahar

#endif
