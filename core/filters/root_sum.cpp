// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/root_sum.hpp"

#include <mpfr.h>

namespace footfall::detail {

// Intervals of growing precision.
int compareRootSum(std::span<const mpq_class> squares, const mpq_class& limit) {
  constexpr mpfr_prec_t kFinestPrecision = 4096;
  for (mpfr_prec_t precision = 128; precision <= kFinestPrecision; precision *= 4) {
    mpfr_t low, high, term;
    mpfr_inits2(precision, low, high, term, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_zero(low, 1);
    mpfr_set_zero(high, 1);
    for (const mpq_class& square : squares) {
      mpfr_set_q(term, square.get_mpq_t(), MPFR_RNDD);
      mpfr_sqrt(term, term, MPFR_RNDD);
      mpfr_add(low, low, term, MPFR_RNDD);
      mpfr_set_q(term, square.get_mpq_t(), MPFR_RNDU);
      mpfr_sqrt(term, term, MPFR_RNDU);
      mpfr_add(high, high, term, MPFR_RNDU);
    }
    const bool above = mpfr_cmp_q(low, limit.get_mpq_t()) > 0, below = mpfr_cmp_q(high, limit.get_mpq_t()) < 0;
    mpfr_clears(low, high, term, static_cast<mpfr_ptr>(nullptr));
    if (above) return 1;
    if (below) return -1;
  }
  return 0;
}

}  // namespace footfall::detail
