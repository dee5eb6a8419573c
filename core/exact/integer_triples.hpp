// Exact homogeneous coordinates and line coefficients, kept one behind the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <vector>

#include "core/exact/fixed_integer.hpp"

namespace footfall::detail {

/// Numbered triples of integers of any width, without an allocation for each.
class IntegerTriples {
 public:
  void clear() {
    triples_.clear();
    limbs_.clear();
  }

  std::int32_t add(const std::array<FixedInteger, 3>& x) { return addViews({x[0], x[1], x[2]}); }
  std::int32_t add(const std::array<mpz_class, 3>& x) {
    std::array<IntegerView, 3> views;
    for (std::size_t k = 0; k < 3; ++k)
      views[k] = {mpz_limbs_read(x[k].get_mpz_t()), static_cast<int>(mpz_size(x[k].get_mpz_t())) * sgn(x[k])};
    return addViews(views);
  }

  /// Views of a triple's numbers, good until the next triple is added.
  std::array<IntegerView, 3> operator[](std::int32_t number) const {
    const Triple& t = triples_[static_cast<std::size_t>(number)];
    std::array<IntegerView, 3> views;
    const mp_limb_t* place = limbs_.data() + t.start;
    for (std::size_t k = 0; k < 3; ++k) {
      views[k] = {place, t.sizes[k]};
      place += views[k].count();
    }
    return views;
  }

  /// A triple as numbers of GMP.
  [[nodiscard]] std::array<mpz_class, 3> wide(std::int32_t number) const {
    std::array<mpz_class, 3> result;
    const auto views = (*this)[number];
    for (std::size_t k = 0; k < 3; ++k) {
      mpz_t borrowed;
      result[k] = mpz_class(mpz_roinit_n(borrowed, views[k].limbs, views[k].size));
    }
    return result;
  }

 private:
  struct Triple {
    std::size_t start;
    std::array<int, 3> sizes;
  };

  std::int32_t addViews(const std::array<IntegerView, 3>& views) {
    triples_.push_back({limbs_.size(), {views[0].size, views[1].size, views[2].size}});
    for (const IntegerView& view : views) limbs_.insert(limbs_.end(), view.limbs, view.limbs + view.count());
    return static_cast<std::int32_t>(triples_.size()) - 1;
  }

  std::vector<Triple> triples_;
  std::vector<mp_limb_t> limbs_;
};

}  // namespace footfall::detail
