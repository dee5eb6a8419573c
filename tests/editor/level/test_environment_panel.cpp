// Meshes and materials in the editor: the tree, roles by mouse and keys, what they do to the result, undo and sessions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QHeaderView>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "tests/unit/ifc_stand_in.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/level/environment_tools.hpp"
#include "ui/level/import_panel.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

/// A ground of 8 x 8; one above it a table of two materials, 2 x 2 each.
QByteArray roomObj() {
  return "o ground\nusemtl stone\n" + floorObj() +
         "v -2 -1 1\nv 0 -1 1\nv 0 1 1\nv -2 1 1\nv 2 -1 1\nv 2 1 1\n"
         "o table\nusemtl wood\nf 5 6 7 8\nusemtl steel\nf 6 9 10 7\n";
}

/// An OBJ of `count` crates in rows.
QByteArray cratesObj(int count) {
  QByteArray text;
  for (int i = 0; i < count; ++i) {
    const QByteArray x = QByteArray::number(i % 100 * 2), y = QByteArray::number(i / 100 * 2);
    text += "o crate" + QByteArray::number(i) + "\nv " + x + ' ' + y + " 0\nv " + x + ".9 " + y + " 0\nv " + x + ' ' +
            y + ".9 0\nf -3 -2 -1\n";
  }
  return text;
}

}  // namespace

class TestEnvironmentPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1200, 800);
    QVERIFY(showWindow(*window_));
    room_ = writeFile(*folder_, "room.obj", roomObj());
    QVERIFY(openZUp(*window_, room_, kPipeline));
    window_->findChild<QAction*>("view.parts")->trigger();  // hides or shows
    if (!tools().dock()->isVisible()) window_->findChild<QAction*>("view.parts")->trigger();
    tools().dock()->raise();
    QVERIFY(QTest::qWaitFor([this] { return tree().isVisible(); }));
  }
  void cleanup() { window_.reset(); }

  void meshesAndTheirMaterials() {
    QAbstractItemModel& rows = *tree().model();
    QCOMPARE(rows.rowCount(), 2);
    QCOMPARE(rows.index(0, 0).data().toString(), QString("ground · stone"));
    QCOMPARE(rows.index(0, 1).data().toString(), QString("2"));
    const QModelIndex table = rows.index(1, 0);
    QCOMPARE(table.data().toString(), QString("table"));
    QCOMPARE(rows.index(1, 1).data().toString(), QString("4"));
    QCOMPARE(rows.rowCount(table), 2);
    QCOMPARE(rows.index(0, 0, table).data().toString(), QString("wood"));
    QCOMPARE(rows.index(1, 2, table).data().toString(), QString("as usual"));
    QCOMPARE(area(), 64.0);  // The table has the area that it removes from the ground.
  }

  void aBoxLeavesOutAndTakesIn() {
    clickBox(row("table"));
    QCOMPARE(area(), 64.0);
    QCOMPARE(partOf<LevelComposer>(*window_).level()->triangles.size(), std::size_t{2});
    QCOMPARE(row("table").data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
    QCOMPARE(partOf<Document>(*window_).undoStack()->undoText(), QString("Ignore 2 parts"));
    tree().expand(row("table"));
    clickBox(row("wood"));
    QCOMPARE(row("table").data(Qt::CheckStateRole).toInt(), int(Qt::PartiallyChecked));
    QCOMPARE(partOf<LevelComposer>(*window_).level()->triangles.size(), std::size_t{4});
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(area(), 64.0);
    QCOMPARE(partOf<LevelComposer>(*window_).level()->triangles.size(), std::size_t{6});
    QCOMPARE(row("table").data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
  }

  void rolesByKeysAndButtons() {
    select("table");
    QTest::keyClick(&tree(), Qt::Key_2, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(area(), 56.0);  // it still blocks
    QCOMPARE(row("table").siblingAtColumn(2).data().toString(), QString("obstacle only"));
    // A box that is ticked again restores the earlier state.
    QTest::keyClick(&tree(), Qt::Key_Space);
    QCOMPARE(area(), 64.0);
    QTest::keyClick(&tree(), Qt::Key_Space);
    QCOMPARE(area(), 56.0);
    QTest::keyClick(&tree(), Qt::Key_1, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(area(), 64.0);
    QVERIFY(partOf<Document>(*window_).state().partRules.empty());
    select("ground · stone");
    auto* ignore = tools().panel().findChild<QAction*>("roleIgnored");
    for (QToolButton* button : tools().panel().findChildren<QToolButton*>())
      if (button->defaultAction() == ignore) QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(area(), 8.0);
    QCOMPARE(partOf<Document>(*window_).undoStack()->undoText(), QString("Ignore ground/stone"));
  }

  void aBuildingHasUsualRolesAndStoreys() {
    const Converter converter(kHouse);
    QVERIFY(openZUp(*window_, QString::fromStdString(converter.building),
                    "SlopeFilter 45\nVerticalClearanceFilter 600\nLayerSubdivisionFilter\n"));
    const auto role = [&](const char* name) { return row(name).siblingAtColumn(PartModel::Role).data().toString(); };
    QCOMPARE(role("IfcSlab · Ground: Floor"), QString("as usual"));
    QCOMPARE(role("IfcDoor · Ground: Door"), QString("ignored"));
    QCOMPARE(role("IfcFurniture · Ground: Table"), QString("obstacle only"));
    QCOMPARE(area(), 16e6);
    QVERIFY(partOf<Document>(*window_).state().partRules.empty());
    auto* layers = window_->findChild<QTreeWidget*>(QStringLiteral("layerList"));
    QCOMPARE(layers->topLevelItem(0)->text(1), QString("0 · Ground"));
    // Roles that differ are the user's, and usual ones are not stored.
    select("IfcDoor · Ground: Door");
    QTest::keyClick(&tree(), Qt::Key_1, Qt::AltModifier | Qt::ShiftModifier);
    QVERIFY(area() < 16e6);
    QVERIFY((partOf<Document>(*window_).state().partRules ==
             std::vector<PartRule>{{"IfcDoor", "Ground: Door", PartRole::Floor}}));
    QTest::keyClick(&tree(), Qt::Key_3, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(area(), 16e6);
    QVERIFY(partOf<Document>(*window_).state().partRules.empty());
  }

  void everythingIgnoredAndBack() {
    partOf<MessageBar>(*window_).clear();  // the note that the level is small
    tree().selectAll();
    QTest::keyClick(&tree(), Qt::Key_3, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(area(), 0.0);
    QVERIFY(partOf<LevelComposer>(*window_).level()->triangles.empty());
    QVERIFY(partOf<MessageBar>(*window_).text().isEmpty());
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(area(), 64.0);
  }

  void filterByTyping() {
    QLineEdit* filter = tools().panel().filterField();
    QTest::mouseClick(filter, Qt::LeftButton);
    QTest::keyClicks(filter, "WOO");
    QCOMPARE(tree().model()->rowCount(), 1);
    QVERIFY(tree().isExpanded(row("table")));
    QCOMPARE(tree().model()->rowCount(row("table")), 1);
    QTest::keyClick(filter, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(filter, Qt::Key_Delete);
    QCOMPARE(tree().model()->rowCount(), 2);
  }

  void sortedByAClickOnTheHeader() {
    const QHeaderView* header = tree().header();
    const auto click = [&](int column) {
      QTest::mouseClick(header->viewport(), Qt::LeftButton, Qt::NoModifier,
                        {header->sectionViewportPosition(column) + 20, header->height() / 2});
    };
    click(PartModel::Triangles);
    QCOMPARE(tree().model()->index(0, 0).data().toString(), QString("ground · stone"));
    click(PartModel::Triangles);
    QCOMPARE(tree().model()->index(0, 0).data().toString(), QString("table"));
  }

  void selectionIsHighlightedAndDoubleClickFrames() {
    const auto picture = [this] {
      QTest::qWait(100);
      return window_->view().grabFramebuffer();
    };
    tree().clearSelection();
    const QImage before = picture();
    select("table");
    const QImage after = picture();
    QVERIFY(before != after);
    const CameraPose pose = window_->view().cameraController().pose();
    const QRect place = tree().visualRect(row("table"));
    window_->view().cameraController().setCovered(
        {});  // A place beside overlays is not in the middle: test_view_overlays.
    QTest::mouseDClick(tree().viewport(), Qt::LeftButton, Qt::NoModifier, place.center());
    const CameraPose framed = window_->view().cameraController().pose();
    QVERIFY(!(framed.position == pose.position));
    const auto middle = window_->view().project({0, 0, 1});
    QVERIFY(middle && std::abs(middle->x() - window_->view().width() / 2.0) < 30);
    QVERIFY(picture() != after);
  }

  void rolesAreKeptInSessions() {
    select("table");
    QTest::keyClick(&tree(), Qt::Key_2, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(area(), 56.0);
    const QString session = folder_->filePath("room.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    window_ = std::make_unique<EditorWindow>();
    QVERIFY(showWindow(*window_));
    window_->open(session);
    QVERIFY(waitUntilIdle(*window_) &&
            QTest::qWaitFor([this] { return window_->controller().finishedRun() != nullptr; }));
    QCOMPARE(area(), 56.0);
    QCOMPARE(row("table").siblingAtColumn(2).data().toString(), QString("obstacle only"));
  }

  // Rules outlive a change of the import options, and parts keep their numbers in the view.
  void rolesOutliveAReload() {
    select("table");
    QTest::keyClick(&tree(), Qt::Key_3, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(area(), 64.0);
    QTest::mouseClick(partOf<ImportPanel>(*window_).bothSidesBox(), Qt::LeftButton);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(partOf<LevelComposer>(*window_).level()->triangles.size(), std::size_t{2});
    QTRY_COMPARE(window_->view().environmentGeometry()->surface.size(), std::size_t{6});
  }

  void coordinatesArePutOnAGrid() {
    QCOMPARE(window_->file().environment()->grid.step, 0.0);
    QComboBox& grid = *partOf<ImportPanel>(*window_).gridBox();
    grid.setCurrentIndex(1);
    emit grid.activated(1);
    QTRY_VERIFY(window_->file().environment()->grid.step > 0);
    QVERIFY(waitUntilIdle(*window_));
    partOf<Document>(*window_).undoStack()->undo();
    QTRY_COMPARE(window_->file().environment()->grid.step, 0.0);
    QCOMPARE(grid.currentIndex(), 0);
  }

  void tenThousandParts() {
    const QString crates = writeFile(*folder_, "crates.obj", cratesObj(10000));
    QVERIFY(openZUp(*window_, crates, kPipeline));
    QCOMPARE(tree().model()->rowCount(), 10000);
    // The panel's own work; pictures of the view are as slow as software OpenGL is on this machine.
    qint64 worst = 0;
    const auto time = [&worst](const char* what, const auto& action) {
      QElapsedTimer clock;
      clock.start();
      action();
      worst = std::max(worst, clock.elapsed());
      qInfo("%s: %lld ms", what, static_cast<long long>(clock.elapsed()));
    };
    time("typing", [&] { QTest::keyClicks(tools().panel().filterField(), "9"); });
    time("clearing", [&] { tools().panel().filterField()->clear(); });
    time("drawing", [&] { tree().viewport()->repaint(); });
    tree().setFocus();
    time("selecting all", [&] { tree().selectAll(); });
    time("a role for all", [&] { QTest::keyClick(&tree(), Qt::Key_2, Qt::AltModifier | Qt::ShiftModifier); });
    time("undo", [&] { partOf<Document>(*window_).undoStack()->undo(); });
    partOf<Document>(*window_).undoStack()->redo();
    QVERIFY2(worst < 500, qPrintable(QString::number(worst)));  // generous: the machine may be busy
    QCOMPARE(area(), 0.0);
    QCOMPARE(partOf<Document>(*window_).state().partRules.size(), std::size_t{10000});
  }

 private:
  EnvironmentTools& tools() { return *window_->findChild<EnvironmentTools*>(); }
  QTreeView& tree() { return *tools().panel().tree(); }

  /// The area of the finished run, once all parts are in.
  double area() {
    if (!waitUntilIdle(*window_) || !window_->controller().upToDate()) return -1;
    return window_->controller().finishedRun()->result.summary.area;
  }
  QModelIndex row(const QString& name) {
    const auto found = tree().model()->match(tree().model()->index(0, 0), Qt::DisplayRole, name, 1,
                                             Qt::MatchExactly | Qt::MatchRecursive);
    return found.value(0);
  }
  void select(const QString& name) {
    tree().setFocus();
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, Qt::NoModifier, tree().visualRect(row(name)).center());
  }
  void clickBox(const QModelIndex& index) {
    QStyleOptionViewItem option;
    option.initFrom(&tree());
    option.rect = tree().visualRect(index);
    option.features |= QStyleOptionViewItem::HasCheckIndicator | QStyleOptionViewItem::HasDisplay;
    const QRect box = tree().style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, &tree());
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, Qt::NoModifier, box.center());
    QVERIFY(waitUntilIdle(*window_));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString room_;
};

FOOTFALL_EDITOR_SUITE(TestEnvironmentPanel)
#include "test_environment_panel.moc"
