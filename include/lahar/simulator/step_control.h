#ifndef lahar_simulator_step_control_h
#define lahar_simulator_step_control_h

namespace Lahar
{
  /**
   * The length of the time steps.
   *
   * A step that fails is repeated with half its length, down to a smallest one. Steps become longer again, by a factor
   * of two and up to the largest length, after three easy ones in a row: such that take at most 0.4 of the allowed
   * nonlinear iterations. Where particles would move too far, a step is halved beforehand. Steps end exactly on the
   * times at which something is due.
   */
  class StepControl
  {
  public:
    /// @param largest,smallest lengths, s. @param maximum_iterations with more, a step has failed.
    StepControl(const double largest, const double smallest, const unsigned int maximum_iterations);

    /// Length of the next step from @p time, s; it does not pass @p stop. A rest below 1 % of the step joins it.
    /// Halves of it are taken while it exceeds @p limit, down to the smallest length.
    double next(const double time, const double stop, const double limit) const;

    /// A step of the length @p tried has failed: halve it. @return false if that is too short.
    bool halve(double &tried);

    /// A step was accepted after @p iterations.
    void accept(const unsigned int iterations);

    /// A length that was shortened stays so when it is read with another largest length.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      double old_largest = largest;
      archive &old_largest &present &n_easy;
      if (old_largest != largest)
        present *= largest / old_largest;
    }

  private:
    double largest, smallest, present;
    double easy_iterations;
    unsigned int n_easy = 0;
  };
} // namespace Lahar

#endif
