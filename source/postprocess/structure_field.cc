// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_structure.h>
#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The structure parameter λ of thixotropic fluids, zero in others.
  template <int dim>
  class StructureField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::cells;
    }

    unsigned int position() const override
    {
      return 6;
    }

    bool is_there(const Snapshot<dim> &snapshot) const override
    {
      return snapshot.materials.any_thixotropic();
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      const std::vector<double> values = FluidStructure<dim>::of_cells(snapshot.mesh, snapshot.materials,
                                                                       snapshot.cloud);
      return Vector<double>(values.begin(), values.end());
    }
  };



  static const Factory<OutputField<2>>::Registration<StructureField<2>>
    structure_2d("structure", "Structure parameter λ where a fluid is thixotropic, 0 in others.");
  static const Factory<OutputField<3>>::Registration<StructureField<3>>
    structure_3d("structure", "Structure parameter λ where a fluid is thixotropic, 0 in others.");
} // namespace Lahar
