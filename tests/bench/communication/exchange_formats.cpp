// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/communication/exchange_formats.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <system_error>
#include <utility>
#include <vector>

#include "core/distributed/cell_share.hpp"
#include "tests/bench/communication/expression_tree.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

/// Points whose three coordinates are expressions.
class ExpressionFormat : public ExchangeFormat {
 public:
  explicit ExpressionFormat(int operations) : operations_(operations) {}

  void prepare(std::uint64_t seed, std::size_t points) override {
    std::mt19937_64 random(seed);
    given_.clear();
    for (std::size_t i = 0; i < 3 * points; ++i) given_.push_back(growExpression(random, operations_));
  }

 protected:
  [[nodiscard]] const std::vector<Expression>& given() const { return given_; }

 private:
  int operations_;
  std::vector<Expression> given_;
};

/// Both formats of evaluated coordinates.
class RoundedFormat : public ExpressionFormat {
 public:
  using ExpressionFormat::ExpressionFormat;

  [[nodiscard]] bool isSame() const override {
    const std::vector<Expression>& exact = given();
    return std::equal(exact.begin(), exact.end(), taken_.begin(), taken_.end(),
                      [](const Expression& e, double d) { return e.doubleValue() == d; });
  }

 protected:
  std::vector<double> taken_;
};

class AsciiFormat : public RoundedFormat {
 public:
  using RoundedFormat::RoundedFormat;

  void write(std::string& out) override {
    char digits[32];
    int column = 0;
    for (const Expression& expression : given()) {
      const auto end =
          std::to_chars(digits, digits + sizeof(digits), expression.doubleValue(), std::chars_format::general, 17).ptr;
      out.append(digits, end);
      column = (column + 1) % 3;
      out += column == 0 ? '\n' : ' ';
    }
  }

  void read(const std::string& bytes, std::size_t points) override {
    taken_.clear();
    const char *at = bytes.data(), *const end = at + bytes.size();
    for (std::size_t i = 0; i < 3 * points; ++i) {
      double value = 0;
      const auto [next, error] = std::from_chars(at, end, value);
      if (error != std::errc() || next == end) throw BadBytes("a number cannot be read");
      taken_.push_back(value);
      at = next + 1;
    }
    if (at != end) throw BadBytes("there is more than the points");
  }
};

class BinaryFormat : public RoundedFormat {
 public:
  using RoundedFormat::RoundedFormat;

  void write(std::string& out) override {
    ByteWriter writer;
    writer.bytes = std::move(out);
    for (const Expression& expression : given()) writer.real(expression.doubleValue());
    out = std::move(writer.bytes);
  }

  void read(const std::string& bytes, std::size_t points) override {
    taken_.clear();
    ByteReader in(bytes);
    for (std::size_t i = 0; i < 3 * points; ++i) taken_.push_back(in.real());
    in.expectEnd();
  }
};

class TreeFormat : public ExpressionFormat {
 public:
  using ExpressionFormat::ExpressionFormat;

  void write(std::string& out) override {
    for (const Expression& expression : given()) writeTree(out, expression);
  }

  void read(const std::string& bytes, std::size_t points) override {
    taken_.clear();
    const char *at = bytes.data(), *const end = at + bytes.size();
    for (std::size_t i = 0; i < 3 * points; ++i) taken_.push_back(readTree(at, end));
    if (at != end) throw BadBytes("there is more than the points");
  }

  // The same bytes again are the same graphs.
  [[nodiscard]] bool isSame() const override {
    std::string a, b;
    for (const Expression& expression : given()) writeTree(a, expression);
    for (const Expression& expression : taken_) writeTree(b, expression);
    return a == b;
  }

 private:
  std::vector<Expression> taken_;
};

class ProvenanceFormat : public ExchangeFormat {
 public:
  void prepare(std::uint64_t seed, std::size_t points) override {
    std::mt19937_64 random(seed);
    const auto below = [&](Index end) { return static_cast<Index>(random() % static_cast<std::uint64_t>(end)); };
    const auto edge = [&] {
      const Index a = below(kRange.vertices - 8);
      return PlanLine{PlanLine::Edge, a, a + 1 + below(7)};
    };
    given_ = {};
    for (std::size_t i = 0; i < points; ++i) {
      const PlanLine first = edge(), second{PlanLine::Trace, below(kRange.triangles), 1};
      given_.points.push_back(PlanPoint::crossing(first, second, below(kRange.triangles)));
    }
    given_.borders.resize(points);
  }

  void write(std::string& out) override {
    ByteWriter writer;
    writer.bytes = std::move(out);
    writeCuts(writer, given_);
    out = std::move(writer.bytes);
  }

  void read(const std::string& bytes, std::size_t points) override {
    ByteReader in(bytes);
    taken_ = readCuts(in, kRange);
    in.expectEnd();
    if (taken_->points.size() != points) throw BadBytes("the number of points is another");
  }

  [[nodiscard]] bool isSame() const override {
    return std::equal(given_.points.begin(), given_.points.end(), taken_->points.begin(), taken_->points.end());
  }

 private:
  /// An environment of about a million triangles, so that numbers are as long as there.
  static constexpr ShareRange kRange{500'000, 1'000'000, 1, 0};
  FaceCuts given_;
  std::shared_ptr<const FaceCuts> taken_;
};

}  // namespace

std::unique_ptr<ExchangeFormat> makeAsciiFormat(int operations) { return std::make_unique<AsciiFormat>(operations); }
std::unique_ptr<ExchangeFormat> makeBinaryFormat(int operations) { return std::make_unique<BinaryFormat>(operations); }
std::unique_ptr<ExchangeFormat> makeTreeFormat(int operations) { return std::make_unique<TreeFormat>(operations); }
std::unique_ptr<ExchangeFormat> makeProvenanceFormat() { return std::make_unique<ProvenanceFormat>(); }

}  // namespace footfall::bench
