// Runs in the background: pauses, overtaking, events and states.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0\n";

}  // namespace

class TestRunController : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    ImportOptions options;
    options.up = UpAxis::Z;
    environment_ = importEnvironment(writeFile(folder_, "waves.obj", wavesObj(60)).toStdString(), options);
    document_ = std::make_unique<Document>();
    controller_ = std::make_unique<RunController>();
    connect(document_.get(), &Document::filtersChanged, controller_.get(),
            [this] { controller_->setFilters(document_->filters()); });
    document_->reset(parsePipeline(kPipeline, "test"), {});
    controller_->setEnvironment(environment_, {});
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
  }
  void cleanup() {
    controller_.reset();
    document_.reset();
  }

  void quickEditsEndInTheLast() {
    const QSignalSpy started(controller_.get(), &RunController::started);
    for (const double angle : {3.0, 30.0, 30.5}) {
      document_->setValue(document_->filters()[1].id, 0, angle, 1);
      QVERIFY(controller_->busy());  // busy at once
    }
    const QSignalSpy finished(controller_.get(), &RunController::finished);
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    QCOMPARE(started.count(), 1);
    QCOMPARE(finished.count(), 1);
    QCOMPARE(controller_->finishedRun()->pipeline.steps[1].values[0], 30.5);
  }

  void anEditOvertakesTheRunUnderWay() {
    const QSignalSpy finished(controller_.get(), &RunController::finished);
    const QSignalSpy failed(controller_.get(), &RunController::failed);
    QSignalSpy started(controller_.get(), &RunController::started);
    document_->setValue(document_->filters()[1].id, 0, 20, 1);
    // The edit comes in the middle of the first run.
    const auto overtake = connect(controller_.get(), &RunController::started, this, [this, &started] {
      if (started.count() == 1) document_->setValue(document_->filters()[1].id, 0, 25, 2);
    });
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    disconnect(overtake);
    QCOMPARE(started.count(), 2);
    QCOMPARE(finished.count(), 1);
    QCOMPARE(failed.count(), 0);
    QCOMPARE(controller_->finishedRun()->pipeline.steps[1].values[0], 25.0);
  }

  void anEditMakesOnlyWhatFollowsStale() {
    const auto state = [this](std::size_t row) { return controller_->status(document_->filters()[row].id).state; };
    document_->setValue(document_->filters()[2].id, 0, 1, 1);
    QVERIFY(state(0) == StepState::Done && state(1) == StepState::Done);
    QVERIFY(state(2) == StepState::Stale && state(3) == StepState::Stale);
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    QVERIFY(state(1) == StepState::Cached);
    QVERIFY(state(2) == StepState::Done && state(3) == StepState::Done);
  }

  void whatWasRemovedComesFromTheCacheToo() {
    ViewContent last;
    connect(controller_.get(), &RunController::contentReady, this, [&](const ViewContent& content) { last = content; });
    document_->replacePipeline(parsePipeline("SlopeFilter 45\nSlopeFilter 10\nVerticalClearanceFilter 2\n", "test"),
                               "");
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    QVERIFY(last.firstRemoval == removalStyle(FilterType::Slope));
    // The waves slope by 19 or 47 degrees, and nothing is above them: the clearance removes nothing.
    QCOMPARE(last.removed.size(), std::size_t{1});
    document_->addFilter(filterDescriptor(FilterType::Degeneracy), 1);
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    QVERIFY(controller_->status(document_->filters()[1].id).state == StepState::Cached);
    QCOMPARE(last.removed.size(), std::size_t{1});
    QVERIFY(last.removed[0].style == removalStyle(FilterType::Slope) && !last.removed[0].before->surface.empty());
    QCOMPARE(last.walkable.size(), std::size_t{1});
  }

  void anEditShowsItsChangeAtOnceAndCancellingTakesItBack() {
    std::vector<ViewContent> contents;
    connect(controller_.get(), &RunController::contentReady, this,
            [&](const ViewContent& content) { contents.push_back(content); });
    waitForPreviews();
    // The waves slope by 19 or 47 degrees: a limit of 10 removes all of them, before anything is computed.
    document_->setValue(document_->filters()[1].id, 0, 10, 1);
    QCOMPARE(contents.size(), std::size_t{1});  // The content changes during the edit itself.
    QVERIFY(controller_->busy());
    QCOMPARE(contents[0].changes.size(), std::size_t{1});
    QCOMPARE(contents[0].walkable.size(), std::size_t{1});  // the result before, as it was
    const std::size_t gone = contents[0].changes[0]->surface.size();
    QVERIFY(gone > 0);
    QCOMPARE(int{contents[0].changes[0]->surface[0].colour[0]}, removalStyle(FilterType::Slope)->paint.colour.red());

    controller_->cancel();
    QCOMPARE(contents.size(), std::size_t{2});
    QVERIFY(contents[1].changes.empty());
    QVERIFY(contents[1].walkable == contents[0].walkable);
    QVERIFY(!controller_->busy());
    QCOMPARE(controller_->finishedRun()->pipeline.steps[1].values[0], 45.0);

    // The run confirms the preview.
    const std::size_t before = controller_->finishedRun()->result.mesh->triangles.size();
    controller_->runNow();
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    QVERIFY(contents.back().changes.empty());
    QCOMPARE(controller_->finishedRun()->result.mesh->triangles.size() + gone / 3, before);
  }

  void withoutAPreviewTheFirstStepShowsTheChange() {
    std::vector<ViewContent> contents;
    connect(controller_.get(), &RunController::contentReady, this,
            [&](const ViewContent& content) { contents.push_back(content); });
    // Two edits at the same time have no preview.
    document_->replacePipeline(
        parsePipeline("DegeneracyFilter\nSlopeFilter 10\nVerticalClearanceFilter 1\nAreaFilter 0\n", "test"), "");
    QVERIFY(contents.empty());
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    QVERIFY(!contents.empty());
    const ViewContent last = contents.back();
    QVERIFY(last.changes.empty());
    // The earlier contents are the result before with its change, as far as there was time.
    contents.pop_back();
    for (const ViewContent& content : contents) QVERIFY(!content.changes.empty() || content.walkable.size() > 1);
    QCOMPARE(last.walkable[0]->surface.size() / 3, controller_->finishedRun()->result.mesh->triangles.size());
  }

  void theRunGivesWayToTheFrameButNotForEver() {
    waitForPreviews();
    QElapsedTimer clock;
    clock.start();
    document_->setValue(document_->filters()[1].id, 0, 10, 1);
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);  // here no frame is ever shown
    QVERIFY(clock.elapsed() >= 50);
  }

  void goingBackToAKnownResultRunsNothing() {
    const auto before = controller_->finishedRun();
    document_->setValue(document_->filters()[1].id, 0, 10, 1);
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    ViewContent last;
    connect(controller_.get(), &RunController::contentReady, this, [&](const ViewContent& content) { last = content; });
    QSignalSpy finished(controller_.get(), &RunController::finished);
    document_->undoStack()->undo();
    QCOMPARE(finished.count(), 1);  // finished during the edit itself
    QVERIFY(controller_->upToDate());
    QCOMPARE(controller_->finishedRun(), before);
    QCOMPARE(last.walkable[0]->surface.size() / 3, before->result.mesh->triangles.size());
    for (const FilterEntry& entry : document_->filters())
      QVERIFY(controller_->status(entry.id).state == StepState::Cached);
    // A requested run happens all the same, and another level does not use it.
    controller_->runNow();
    QVERIFY(controller_->busy());
    controller_->setEnvironment(environment_, {});
    QCOMPARE(controller_->finishedRuns().count(), std::size_t{0});
    QVERIFY(controller_->busy());
  }

  void slowRunsWaitUntilEditsStop() {
    openSlow();
    document_->setValue(clearanceId(), 0, 1.5, 1);
    QVERIFY(controller_->busy() && !controller_->settling());  // the first edit runs at once
    QElapsedTimer clock;
    clock.start();
    for (const double height : {1.4, 1.3, 1.2}) {
      document_->setValue(clearanceId(), 0, height, 1);
      const bool isClose = clock.elapsed() < 250;  // a loaded machine may have waited for longer
      QVERIFY(controller_->settling() || !isClose);
      QVERIFY(!controller_->remaining().has_value() || !isClose);
      clock.start();
      QTest::qWait(50);
    }
    QTRY_VERIFY(!controller_->settling());
    QVERIFY(clock.elapsed() >= 290);
    QVERIFY(controller_->busy());
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 60000);
    QCOMPARE(controller_->finishedRun()->pipeline.steps[2].values[0], 1.2);
    // A first edit that is dragged waits as well; it can be cancelled, and runs at once when the mouse lets go.
    controller_->setEnvironment(slow_, {});  // there is nothing to reuse, so it is slow again
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 60000);
    controller_->setDragging(true);
    document_->setValue(clearanceId(), 0, 1.1, 2);
    QVERIFY(controller_->settling());
    controller_->cancel();
    QVERIFY(!controller_->busy());
    document_->setValue(clearanceId(), 0, 1.0, 2);
    QVERIFY(controller_->settling());
    controller_->setDragging(false);  // nothing follows any more
    QVERIFY(controller_->busy() && !controller_->settling());
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 60000);
  }

  void quickRunsFollowADrag() {
    // The result is known to be quick.
    document_->replacePipeline(parsePipeline("SlopeFilter 45\n", "test"), "");
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    const QSignalSpy finished(controller_.get(), &RunController::finished);
    controller_->setDragging(true);
    for (int i = 0; i < 60; ++i) {
      document_->setValue(document_->filters()[0].id, 0, 20 + 0.25 * i, 1);
      QTest::qWait(15);
    }
    QVERIFY2(finished.count() > 3, "no result followed the mouse");
    controller_->setDragging(false);
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    QCOMPARE(controller_->finishedRun()->pipeline.steps[0].values[0], 34.75);
  }

  void theTimeLeftIsToldFromEarlierRuns() {
    openSlow();
    QVERIFY(!controller_->remaining().has_value());
    QList<std::chrono::milliseconds> told;
    connect(controller_.get(), &RunController::progressed, this, [&] {
      if (const auto left = controller_->remaining()) told << *left;
    });
    document_->setValue(clearanceId(), 0, 1, 1);
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 60000);
    QVERIFY(!told.isEmpty());
    QVERIFY(told.first().count() < 60000);
    QVERIFY(told.last() <= told.first());
  }

  void editsWaitForTheUserWhereTheyShould() {
    controller_->setAutomatic(false);
    document_->setValue(document_->filters()[1].id, 0, 10, 1);
    QVERIFY(!controller_->busy() && !controller_->upToDate());
    QVERIFY(controller_->status(document_->filters()[1].id).state == StepState::Stale);
    document_->undoStack()->undo();
    QVERIFY(controller_->upToDate());  // back where the result is
    document_->undoStack()->redo();
    controller_->runNow();
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
    document_->setValue(document_->filters()[1].id, 0, 12, 2);
    controller_->setAutomatic(true);
    QVERIFY(controller_->busy());
    QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 20000);
  }

  void workAheadGivesWayAndIsThereWhenWanted() {
    std::vector<Pipeline> wanted;
    for (const double height : {0.5, 0.25, 0.125}) {
      wanted.push_back(document_->pipeline());
      wanted.back().steps[2].values[0] = height;
    }
    QSignalSpy ahead(controller_.get(), &RunController::aheadChanged);
    controller_->runAhead(wanted);
    document_->setValue(document_->filters()[1].id, 0, 30, 1);  // interrupts
    QVERIFY(controller_->busy());
    QTRY_VERIFY_WITH_TIMEOUT(!ahead.isEmpty() && ahead.last()[0] == 3, 60000);
    QCOMPARE(ahead.last()[1].toInt(), 3);
    QVERIFY(controller_->upToDate());
    QCOMPARE(controller_->finishedRun()->pipeline.steps[1].values[0], 30.0);
    for (const Pipeline& pipeline : wanted) QVERIFY(controller_->finishedRunOf(pipeline));
    document_->replacePipeline(wanted[1], "");
    QVERIFY(controller_->upToDate());  // no run
    QCOMPARE(controller_->finishedRun()->pipeline.steps[2].values[0], 0.25);
    // Stopped, and going away in the middle.
    wanted[0].steps[2].values[0] = 0.6;
    controller_->runAhead({wanted[0]});
    controller_->runAhead({});
    QCOMPARE(ahead.last()[1].toInt(), 0);
    wanted[0].steps[2].values[0] = 0.7;
    controller_->runAhead({wanted[0]});
    controller_.reset();
  }

  void goingAwayInTheMiddleIsSafe() {
    document_->setValue(document_->filters()[1].id, 0, 33, 1);
    connect(controller_.get(), &RunController::started, this, [this] { sawStart_ = true; });
    QTRY_VERIFY(sawStart_);
    controller_.reset();
    QVERIFY(!controller_);
  }

  void eventsAreFetchedNotPushed() {
    int calls = 0;
    RunEventBuffer buffer([&] { ++calls; });
    buffer.add({RunEvent::Kind::Progress, 0, 0.5, {}, nullptr});  // The progress belongs to a step that has not begun.
    QCOMPARE(buffer.fetch().size(), std::size_t{0});
    buffer.add({RunEvent::Kind::StepStarted, 0, 0, "SlopeFilter", nullptr});
    for (int i = 0; i < 1000; ++i) buffer.add({RunEvent::Kind::Progress, 0, i / 1000.0, {}, nullptr});
    buffer.add({RunEvent::Kind::PartReady, 0, 0, {}, std::make_shared<NavigationMesh>()});
    QCOMPARE(calls, 1);
    const auto steps = buffer.fetch();
    QCOMPARE(steps.size(), std::size_t{1});
    QCOMPARE(steps[0].fraction, 0.999);
    QCOMPARE(steps[0].parts.size(), std::size_t{1});
    buffer.add({RunEvent::Kind::StepFinished, 0, 1, {}, nullptr});
    QCOMPARE(calls, 2);
    QVERIFY(buffer.fetch()[0].finished);
    QVERIFY(buffer.fetch()[0].parts.empty());
  }

 private:
  // Previews are made one after the other in the background, once the result has been shown; this test has no view.
  void waitForPreviews() { QTRY_VERIFY_WITH_TIMEOUT(controller_->previews(document_->filters()[1].id), 20000); }

  // Runs that take longer than people like to wait.
  void openSlow() {
    ImportOptions options;
    options.up = UpAxis::Z;
    double ms = 0;
    for (int size = 150; ms < 200; size *= 2) {  // whatever the machine
      slow_ = importEnvironment(writeFile(folder_, "slow.obj", wavesObj(size)).toStdString(), options);
      controller_->setEnvironment(slow_, {});
      QTRY_VERIFY_WITH_TIMEOUT(controller_->upToDate(), 60000);
      ms = controller_->status(clearanceId()).wallMs.value_or(0);
    }
  }
  int clearanceId() const { return document_->filters()[2].id; }

  QTemporaryDir folder_;
  std::shared_ptr<const Environment> slow_;
  std::shared_ptr<const Environment> environment_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<RunController> controller_;
  bool sawStart_ = false;
};

QTEST_MAIN(TestRunController)
#include "test_run_controller.moc"
