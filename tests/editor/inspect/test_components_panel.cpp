// The panel "Components" as a person uses it: opening, choosing, filtering, copying; and with very many of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <memory>
#include <utility>

#include "tests/editor/editor_driver.hpp"
#include "ui/inspect/inspection_feature.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Squares of 1 x 1, 2 x 2, 3 x 3 ... beside each other; Z up.
QByteArray squaresObj(int count) {
  QByteArray text;
  double x = 0;
  for (int i = 1; i <= count; ++i) {
    for (const auto& [dx, dy] : {std::pair{0, 0}, std::pair{i, 0}, std::pair{i, i}, std::pair{0, i}})
      text += "v " + QByteArray::number(x + dx) + ' ' + QByteArray::number(dy) + " 0\n";
    const int v = 4 * i - 3;
    text += "f " + QByteArray::number(v) + ' ' + QByteArray::number(v + 1) + ' ' + QByteArray::number(v + 2) + ' ' +
            QByteArray::number(v + 3) + '\n';
    x += i + 1;
  }
  return text;
}

/// An Inspector over so many separate triangles of different size.
std::shared_ptr<const Inspector> manyComponents(int count) {
  auto environment = std::make_shared<Environment>();
  for (int i = 0; i < count; ++i) {
    const double x = i % 100 * 3, y = i / 100 * 3, size = 1 + i / double(count);
    const auto v = static_cast<std::uint32_t>(environment->vertices.size());
    for (const Vec3& p : {Vec3{x, y, 0}, Vec3{x + size, y, 0}, Vec3{x, y + size, 0}})
      environment->vertices.push_back(p);
    environment->triangles.push_back({v, v + 1, v + 2});
  }
  RunContext context;
  ResultCache cache;
  const RunResult result = runPipeline(environment, {}, context, &cache);
  return std::make_shared<Inspector>(environment, Pipeline{}, result.mesh, &cache, &context);
}

constexpr const char* kPipeline = "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0\n";

}  // namespace

class TestComponentsPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    feature_ = window_->findChild<InspectionFeature*>();
    QVERIFY(feature_ != nullptr);
  }
  void cleanup() { window_.reset(); }

  void largestFirst() {
    const QTemporaryDir folder;
    QVERIFY(openZUp(*window_, writeFile(folder, "squares.obj", squaresObj(4)), kPipeline));
    QVERIFY(feature_->watch().inspector() == nullptr);  // no components are computed before the panel is shown
    open();
    QTRY_COMPARE(table()->model()->rowCount(), 4);
    QCOMPARE(text(0, ComponentsModel::Rank), QStringLiteral("1"));
    QCOMPARE(text(0, ComponentsModel::Area), QStringLiteral("16"));
    QCOMPARE(text(3, ComponentsModel::Area), QStringLiteral("1"));
    QCOMPARE(text(0, ComponentsModel::Triangles), QStringLiteral("2"));
    QCOMPARE(text(3, ComponentsModel::Centre), QStringLiteral("0.5, 0.5, 0"));
    QVERIFY2(panel().totalText().startsWith("4 components, 30.00 units²"), qPrintable(panel().totalText()));
    // The list follows edits.
    partOf<Document>(*window_).setEnabled(partOf<Document>(*window_).filters()[3].id, false);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_COMPARE(table()->model()->rowCount(), 4);
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[3].id, 0, 5, 1);
    partOf<Document>(*window_).setEnabled(partOf<Document>(*window_).filters()[3].id, true);
    QTRY_COMPARE(table()->model()->rowCount(), 2);
  }

  void clickFramesAndHighlights() {
    const QTemporaryDir folder;
    QVERIFY(openZUp(*window_, writeFile(folder, "squares.obj", squaresObj(5)), kPipeline));
    open();
    QTRY_COMPARE(table()->model()->rowCount(), 5);
    const auto pose = [&] { return window_->view().cameraController().pose().position; };
    const Vec3 before = pose();
    QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, table()->visualRect(index(4)).center());
    QVERIFY(!(pose() == before));
    // The smallest one fills the view now, in the colour of what is selected.
    const auto corner = window_->view().project({1, 1, 0}), other = window_->view().project({0, 0, 0});
    QVERIFY(corner && other && (*corner - *other).manhattanLength() > 0.3 * window_->view().height());
    QTRY_VERIFY(shows(selectedCellColour()));
    // Selects by keyboard: up, and Return.
    QTest::keyClick(table(), Qt::Key_Up);
    QCOMPARE(table()->currentIndex().row(), 3);
    const Vec3 small = pose();
    QTest::keyClick(table(), Qt::Key_Return);
    QTRY_VERIFY(!(pose() == small));
    // Closing the panel takes the highlight back.
    dock()->close();
    QTRY_VERIFY(!shows(selectedCellColour()));
    QVERIFY(feature_->watch().inspector() == nullptr);
  }

  void smallerThan() {
    const QTemporaryDir folder;
    QVERIFY(openZUp(*window_, writeFile(folder, "squares.obj", squaresObj(5)), kPipeline));
    open();
    QTRY_COMPARE(table()->model()->rowCount(), 5);
    QLineEdit* field = panel().smallerThanField();
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("9"));
    QCOMPARE(table()->model()->rowCount(), 2);  // 4 and 1: 9 is not smaller than 9
    QCOMPARE(text(0, ComponentsModel::Rank), QStringLiteral("4"));
    QVERIFY2(panel().totalText().startsWith("2 of 5 components, 5.00 units²"), qPrintable(panel().totalText()));
    QTest::keyClicks(field, QStringLiteral(".5x"));
    QVERIFY(field->property("invalid").toBool());
    QVERIFY(panel().findChild<QLabel*>(QStringLiteral("rowError"))->text().contains("9.5x"));
    QCOMPARE(table()->model()->rowCount(), 3);  // the last valid one: 9.5
    QTest::keyClick(field, Qt::Key_Backspace);
    QVERIFY(!field->property("invalid").toBool());
    for (const char* wrong : {"-1", "0", "nan", "inf"}) {
      field->setText(QString::fromLatin1(wrong));
      QVERIFY(field->property("invalid").toBool());
    }
    field->clear();
    QCOMPARE(table()->model()->rowCount(), 5);

    QTest::mouseClick(panel().copyButton(), Qt::LeftButton);
    const QStringList lines = QApplication::clipboard()->text().split('\n');
    QCOMPARE(lines.size(), 7);
    QVERIFY(lines[0].startsWith("Rank\tArea (units²)\tTriangles"));
    QVERIFY2(lines[1].startsWith("1\t25\t2\t"), qPrintable(lines[1]));
  }

  void tenThousand() {
    const auto many = manyComponents(10000);
    open();
    QElapsedTimer clock;
    clock.start();
    panel().setInspector(many);
    QApplication::processEvents();
    QVERIFY2(clock.elapsed() < 300, qPrintable(QString::number(clock.elapsed())));
    QCOMPARE(table()->model()->rowCount(), 10000);
    clock.restart();
    for (int i = 0; i < 20; ++i) {
      table()->scrollTo(index(i * 500));
      QApplication::processEvents();
    }
    QVERIFY2(clock.elapsed() < 20 * 100, qPrintable(QString::number(clock.elapsed())));
    clock.restart();
    panel().smallerThanField()->setText(QStringLiteral("1"));
    QApplication::processEvents();
    QVERIFY2(clock.elapsed() < 300, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(table()->model()->rowCount() > 1000 && table()->model()->rowCount() < 10000);
  }

  void emptyWithoutResult() {
    open();
    QCOMPARE(table()->model()->rowCount(), 0);
    QVERIFY(!panel().copyButton()->isEnabled());
    QVERIFY(!panel().totalText().isEmpty());
  }

 private:
  [[nodiscard]] ComponentsPanel& panel() const { return feature_->componentsPanel(); }
  [[nodiscard]] QTableView* table() const { return panel().table(); }
  [[nodiscard]] QModelIndex index(int row) const { return table()->model()->index(row, 0); }
  [[nodiscard]] QString text(int row, int column) const {
    return table()->model()->index(row, column).data().toString();
  }
  [[nodiscard]] QDockWidget* dock() const {
    return window_->findChild<QDockWidget*>(QStringLiteral("inspect.components"));
  }
  void open() {
    QAction* action = window_->findChild<QAction*>(QStringLiteral("inspect.components"));
    QVERIFY(action != nullptr);
    action->trigger();
    QTRY_VERIFY(panel().isVisible());
  }
  /// Blended with what lies under it, yellow stays far redder than blue.
  [[nodiscard]] bool shows(const QColor& colour) const {
    const QImage image = window_->view().grabFramebuffer();
    int count = 0;
    for (int y = 0; y < image.height(); y += 2)
      for (int x = 0; x < image.width(); x += 2) {
        const QColor p = image.pixelColor(x, y);
        count += std::abs(p.red() - colour.red()) + std::abs(p.green() - colour.green()) +
                             std::abs(p.blue() - colour.blue()) <
                         40
                     ? 1
                     : 0;
      }
    return count > 20;
  }

  std::unique_ptr<EditorWindow> window_;
  InspectionFeature* feature_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestComponentsPanel)
#include "test_components_panel.moc"
