// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/communication/expression_tree.hpp"

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <typeinfo>

namespace footfall::bench {
using detail::BadBytes;
namespace {

enum NodeType : char { Constant, Negate, Add, Subtract, Multiply, Divide };

constexpr int kDeepest = 10'000;  // of a tree that is read: damaged bytes must not use up the stack

// The operands are protected; a derived type may name them.
struct BinaryNode : CORE::BinOpRep {
  static CORE::ExprRep* firstOf(const CORE::BinOpRep& node) { return node.*(&BinaryNode::first); }
  static CORE::ExprRep* secondOf(const CORE::BinOpRep& node) { return node.*(&BinaryNode::second); }
};
struct UnaryNode : CORE::UnaryOpRep {
  static CORE::ExprRep* childOf(const CORE::UnaryOpRep& node) { return node.*(&UnaryNode::child); }
};

void addNumber(std::string& out, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  char bytes[8];
  for (int i = 0; i < 8; ++i) bytes[i] = static_cast<char>(bits >> (8 * i));
  out.append(bytes, sizeof(bytes));
}

NodeType typeOf(const CORE::ExprRep& node) {
  const std::type_info& type = typeid(node);
  if (type == typeid(CORE::ConstDoubleRep)) return Constant;
  if (type == typeid(CORE::AddRep)) return Add;
  if (type == typeid(CORE::SubRep)) return Subtract;
  if (type == typeid(CORE::MultRep)) return Multiply;
  if (type == typeid(CORE::DivRep)) return Divide;
  if (type == typeid(CORE::NegRep)) return Negate;
  throw std::logic_error("an expression has a node that random expressions do not have");
}

void writeNode(std::string& out, const CORE::ExprRep& node) {
  const NodeType type = typeOf(node);
  out += type;
  if (type == Constant) {
    addNumber(out, node.ffVal.getValue());
  } else if (type == Negate) {
    writeNode(out, *UnaryNode::childOf(static_cast<const CORE::UnaryOpRep&>(node)));
  } else {
    const auto& operation = static_cast<const CORE::BinOpRep&>(node);
    writeNode(out, *BinaryNode::firstOf(operation));
    writeNode(out, *BinaryNode::secondOf(operation));
  }
}

Expression readNode(const char*& at, const char* end, int depth) {
  if (at == end) throw BadBytes("an expression ends too early");
  if (depth > kDeepest) throw BadBytes("an expression is too deep");
  const char type = *at++;
  if (type == Constant) {
    if (end - at < 8) throw BadBytes("a constant ends too early");
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint64_t{static_cast<unsigned char>(*at++)} << (8 * i);
    return {std::bit_cast<double>(bits)};
  }
  if (type < Constant || type > Divide) throw BadBytes("an expression has a node of an unknown type");
  const Expression first = readNode(at, end, depth + 1);
  if (type == Negate) return -first;
  const Expression second = readNode(at, end, depth + 1);
  switch (type) {
    case Add:
      return first + second;
    case Subtract:
      return first - second;
    case Multiply:
      return first * second;
    default:
      return first / second;
  }
}

}  // namespace

Expression growExpression(std::mt19937_64& random, int operations) {
  std::uniform_real_distribution<double> value(1, 100);
  const auto constant = [&] { return Expression(random() % 2 == 0 ? value(random) : -value(random)); };
  Expression expression = constant();
  for (int i = 0; i < operations; ++i) {
    const Expression other = constant();
    const bool isLeft = random() % 2 == 0;
    switch (random() % 4) {
      case 0:
        expression = isLeft ? other + expression : expression + other;
        break;
      case 1:
        expression = isLeft ? other - expression : expression - other;
        break;
      case 2:
        expression = isLeft ? other * expression : expression * other;
        break;
      default:
        expression = expression / other;
        break;
    }
  }
  return expression;
}

void writeTree(std::string& out, const Expression& expression) { writeNode(out, *expression.Rep()); }

Expression readTree(const char*& at, const char* end) { return readNode(at, end, 0); }

}  // namespace footfall::bench
