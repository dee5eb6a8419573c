// A small closed level for the suites that look into one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <array>
#include <utility>

namespace footfall::test {

/// A house of 6 x 4 x 3 with walls and a roof 0.2 thick and a floor inside, on a meadow of 20 x 20.
inline QByteArray houseObj() {
  QByteArray text = "v -10 -10 0\nv 10 -10 0\nv 10 10 0\nv -10 10 0\nf 1 2 3 4\n";
  int next = 5;
  const auto box = [&](double x0, double y0, double z0, double x1, double y1, double z1) {
    for (const double z : {z0, z1}) {
      for (const auto& [x, y] : {std::pair{x0, y0}, std::pair{x1, y0}, std::pair{x1, y1}, std::pair{x0, y1}})
        text += "v " + QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' + QByteArray::number(z) + '\n';
    }
    for (const auto& face : {std::array{3, 2, 1, 0}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                             std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}}) {
      text += 'f';
      for (const int corner : face) text += ' ' + QByteArray::number(next + corner);
      text += '\n';
    }
    next += 8;
  };
  box(-3, -2, 0, 3, 2, 0.1);
  box(-3, -2, 0.1, -2.8, 2, 3);
  box(2.8, -2, 0.1, 3, 2, 3);
  box(-2.8, -2, 0.1, 2.8, -1.8, 3);
  box(-2.8, 1.8, 0.1, 2.8, 2, 3);
  box(-3, -2, 3, 3, 2, 3.2);
  return text;
}

}  // namespace footfall::test
