// Random expressions and their tree format, as the thesis has them (4.2.3, 5.3.1): CORE::Expr graphs are walked and
// each node is written as its type and its constant. Only the communication benchmark uses them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/CORE_Expr.h>

#include <random>
#include <string>

#include "core/base/byte_stream.hpp"

namespace footfall::bench {

using Expression = CORE::Expr;

/// A constant to which `operations` random binary operations (+, -, *, /) with random constants are applied, on random
/// sides. A divisor is never 0.
Expression growExpression(std::mt19937_64& random, int operations);

/// One byte for each node's type, eight more for each constant; an operation stands before its left and right operand.
/// Throws std::logic_error for a constant that is no double, which growExpression() does not make.
void writeTree(std::string& out, const Expression& expression);

/// Builds the graph again; only divisors are evaluated, because CORE tests them. Throws detail::BadBytes.
Expression readTree(const char*& at, const char* end);

}  // namespace footfall::bench
