// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_index_h
#define lahar_utilities_index_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>

#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * The number of a thing of the kind that @p Tag names. Numbers of different kinds are different types: neither can one be
   * taken for another, nor an unsigned int for one of them, unless that is said.
   */
  template <typename Tag>
  class Index
  {
  public:
    /// Of nothing.
    constexpr Index() = default;

    constexpr explicit Index(const unsigned int number)
      : number(number)
    {}

    constexpr unsigned int value() const
    {
      return number;
    }

    /// Whether it is that of something.
    constexpr bool is_valid() const
    {
      return number != dealii::numbers::invalid_unsigned_int;
    }

    constexpr Index &operator++()
    {
      ++number;
      return *this;
    }

    /// So that a range of numbers can be run through: what an iterator of numbers points at is the number.
    constexpr Index operator*() const
    {
      return *this;
    }

    friend constexpr bool operator==(const Index a, const Index b)
    {
      return a.number == b.number;
    }

    friend constexpr bool operator!=(const Index a, const Index b)
    {
      return a.number != b.number;
    }

    friend constexpr bool operator<(const Index a, const Index b)
    {
      return a.number < b.number;
    }

  private:
    unsigned int number = dealii::numbers::invalid_unsigned_int;
  };



  /// The numbers 0 … n−1 of one kind, for range-based loops.
  template <typename I>
  class IndexRange
  {
  public:
    constexpr explicit IndexRange(const unsigned int n)
      : n(n)
    {}

    constexpr I begin() const
    {
      return I(0);
    }

    constexpr I end() const
    {
      return I(n);
    }

  private:
    unsigned int n;
  };



  /// A std::vector that is indexed by one kind of number only.
  template <typename I, typename T>
  class IndexVector
  {
  public:
    IndexVector() = default;

    explicit IndexVector(const unsigned int n, const T &value = T())
      : values(n, value)
    {}

    /// Of values that are in the order of these numbers.
    explicit IndexVector(std::vector<T> values)
      : values(std::move(values))
    {}

    decltype(auto) operator[](const I i)
    {
      AssertIndexRange(i.value(), values.size());
      return values[i.value()];
    }

    decltype(auto) operator[](const I i) const
    {
      AssertIndexRange(i.value(), values.size());
      return values[i.value()];
    }

    unsigned int size() const
    {
      return values.size();
    }

    bool empty() const
    {
      return values.empty();
    }

    /// All numbers.
    IndexRange<I> indices() const
    {
      return IndexRange<I>(size());
    }

    void push_back(const T &value)
    {
      values.push_back(value);
    }

    void assign(const unsigned int n, const T &value)
    {
      values.assign(n, value);
    }

    void clear()
    {
      values.clear();
    }

    auto begin() const
    {
      return values.begin();
    }

    auto end() const
    {
      return values.end();
    }

    /// The values in the order of the numbers, for what does not know these.
    std::vector<T> &raw()
    {
      return values;
    }

    const std::vector<T> &raw() const
    {
      return values;
    }

    friend bool operator==(const IndexVector &a, const IndexVector &b)
    {
      return a.values == b.values;
    }

    friend bool operator!=(const IndexVector &a, const IndexVector &b)
    {
      return a.values != b.values;
    }

  private:
    std::vector<T> values;
  };
} // namespace Lahar

#endif
