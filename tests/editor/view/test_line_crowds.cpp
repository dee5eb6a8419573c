// Lines that are many are drawn the fainter: from far they do not make one surface of their colour.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "tests/editor/editor_driver.hpp"
#include "ui/view/geometry/line_crowds.hpp"
#include "ui/view/scene/appearance.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Lines along y at each whole x below `count`, as long as all of them are wide, in so many pieces each.
std::vector<LineSegment> fence(int count, int pieces = 1) {
  std::vector<LineSegment> lines;
  const auto size = static_cast<float>(count);
  for (int x = 0; x < count; ++x)
    for (int i = 0; i < pieces; ++i) {
      const auto part = size / static_cast<float>(pieces);
      const auto place = static_cast<float>(x), begin = part * static_cast<float>(i);
      lines.push_back({{place, begin, 0}, {place, begin + part, 0}});
    }
  return lines;
}

}  // namespace

class TestLineCrowds : public QObject {
  Q_OBJECT

 private slots:
  void lengthAndNumberAroundALine() {
    // The lines are 1 apart: a length of 1 for each unit of area. Each is `pieces` lines on 200 units.
    for (const int pieces : {1, 50}) {
      std::vector<LineSegment> lines = fence(200, pieces);
      setCrowds(lines);
      const LineSegment& middle = lines[lines.size() / 2];
      QVERIFY2(std::abs(middle.crowd[0] - 1) < 0.35F, qPrintable(QString::number(middle.crowd[0])));
      const float number = static_cast<float>(pieces) / 200;
      QVERIFY2(std::abs(middle.crowd[1] / number - 1) < 0.35F, qPrintable(QString::number(middle.crowd[1])));
    }
  }

  void whatIsAloneHasNoCrowd() {
    std::vector<LineSegment> few = fence(60);
    setCrowds(few);
    for (const LineSegment& line : few) QVERIFY(line.crowd == (std::array<float, 2>{}));
    // A line far from a fence, in pieces, and all lines in one place.
    std::vector<LineSegment> lines = fence(200);
    for (int i = 0; i < 100; ++i)
      lines.push_back({{400, static_cast<float>(2 * i), 0}, {400, static_cast<float>(2 * i + 2), 0}});
    setCrowds(lines);
    QVERIFY(lines[100].crowd[0] > 0.5F);
    QCOMPARE(lines[250].crowd[0], 0.0F);
    std::vector<LineSegment> places(100, LineSegment{{1, 2, 3}, {1, 2, 3}});
    setCrowds(places);
    QVERIFY(places[0].crowd == (std::array<float, 2>{}));
  }

  void crowdsAreByStoreys() {
    // Two fences far over each other: as many around each line as in one.
    std::vector<LineSegment> one = fence(200);
    std::vector<LineSegment> two = one;
    for (LineSegment line : one) {
      line.from[2] = line.to[2] = 100;
      two.push_back(line);
    }
    setCrowds(one);
    setCrowds(two);
    QVERIFY(std::abs(one[100].crowd[0] - two[100].crowd[0]) < 0.01F);
  }

  void obstacleEdgesStaySeenApart() {
    // A floor with 200 low walls, a unit apart.
    QByteArray text = "v 0 0 0\nv 200 0 0\nv 200 200 0\nv 0 200 0\n";
    QByteArray faces = "f 1 2 3 4\n";
    for (int i = 0; i < 199; ++i) {
      const QByteArray x = QByteArray::number(i + 1);
      for (const char* end : {" 5 0\n", " 195 0\n", " 195 1\n", " 5 1\n"}) text += "v " + x + end;
      faces += 'f';
      for (int k = 0; k < 4; ++k) faces += ' ' + QByteArray::number(5 + 4 * i + k);
      faces += '\n';
    }
    EditorWindow window;
    window.resize(900, 700);
    QVERIFY(showWindow(window));
    const QTemporaryDir folder;
    QVERIFY(
        openZUp(window, writeFile(folder, "walls.obj", text + faces), "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    LevelView& view = window.view();
    SceneParts parts;
    parts.environment = false;
    view.setParts(parts);
    view.cameraController().viewFromTop();
    // Every few pixels a line as wide: floor is seen between them, and lines on it.
    const double far = shareOf(view, obstacleEdgeColour());
    QVERIFY2(far < 0.01, qPrintable(QString::number(far)));
    QVERIFY(shareOf(view, walkablePaint().colour) < 0.1);
    // Each line has its colour from near.
    view.cameraController().zoomBy(20);
    const double near = shareOf(view, obstacleEdgeColour());
    QVERIFY2(near > 0.02, qPrintable(QString::number(near)));
    QVERIFY(shareOf(view, walkablePaint().colour) > 0.3);
  }

 private:
  /// The share of the middle of the view that has a colour, but for its light.
  static double shareOf(LevelView& view, const QColor& colour) {
    const QImage picture = view.grabFramebuffer();
    const QRect middle(picture.width() / 2 - 80, picture.height() / 2 - 80, 160, 160);
    int count = 0;
    for (int y = middle.top(); y <= middle.bottom(); ++y)
      for (int x = middle.left(); x <= middle.right(); ++x) {
        const QColor pixel = picture.pixelColor(x, y);
        const int hue = std::abs(pixel.hsvHue() - colour.hsvHue());
        count += std::min(hue, 360 - hue) < 8 && std::abs(pixel.hsvSaturationF() - colour.hsvSaturationF()) < 0.1F;
      }
    return count / double(middle.width() * middle.height());
  }
};

FOOTFALL_EDITOR_SUITE(TestLineCrowds)
#include "test_line_crowds.moc"
