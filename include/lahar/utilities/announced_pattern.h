// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_announced_pattern_h
#define lahar_utilities_announced_pattern_h

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace Lahar
{
  using namespace dealii;

  /**
   * What is allowed, for those who read the output of --print-parameters and for editors, in deal.II's words. The pattern
   * itself lets every text pass: values are checked where they are read, by functions whose messages name the entry's
   * path and that know more, such as the values of other entries.
   */
  class AnnouncedPattern : public Patterns::PatternBase
  {
  public:
    explicit AnnouncedPattern(const Patterns::PatternBase &pattern)
      : pattern(pattern.clone())
    {}

    bool match(const std::string & /*text*/) const override
    {
      return true;
    }

    std::string description(const OutputStyle style = Machine) const override
    {
      return pattern->description(style);
    }

    std::unique_ptr<PatternBase> clone() const override
    {
      return std::make_unique<AnnouncedPattern>(*pattern);
    }

  private:
    std::unique_ptr<PatternBase> pattern;
  };
} // namespace Lahar

#endif
