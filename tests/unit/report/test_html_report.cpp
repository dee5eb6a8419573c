// The report as one HTML file: its content, that everything is inside, and that no text can break it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QXmlStreamReader>
#include <QtTest>

#include "core/environment/skipped_polygons.hpp"
#include "core/io/base64.hpp"
#include "core/report/html_report.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// The first error of it as a document that holds everything itself; empty when there is none.
QString findError(const std::string& html) {
  QXmlStreamReader reader(QByteArray::fromStdString(html));
  QStringList open;
  while (!reader.atEnd()) {
    reader.readNext();
    if (!reader.isStartElement()) continue;
    for (const char* attribute : {"src", "href", "srcset", "data"})
      if (reader.attributes().hasAttribute(attribute) &&
          !reader.attributes().value(attribute).startsWith(QLatin1String("data:image/png;base64,")))
        return QString("<%1> reaches out").arg(reader.name());
    if (reader.name() == QLatin1String("script") || reader.name() == QLatin1String("link")) return "script or link";
    if (reader.name() == QLatin1String("img") && !reader.attributes().hasAttribute("alt"))
      return "picture without words";
  }
  if (reader.hasError()) return reader.errorString() + QString(" in line %1").arg(reader.lineNumber());
  if (!html.starts_with("<!DOCTYPE html>\n<html lang=\"en\">")) return "no HTML5";
  return html.find("url(") != std::string::npos || html.find("@import") != std::string::npos ? "style reaches out" : "";
}

struct Ran {
  std::shared_ptr<Environment> environment;
  Pipeline pipeline;
  RunResult result;
};

Ran run(const Soup& soup, const char* pipeline) {
  Ran ran;
  ran.environment = soup.environment();
  ran.environment->source = "/a/b/<level> & \"more\".obj";
  ran.pipeline = parsePipeline(pipeline, "test");
  RunContext context;
  ran.result = runPipeline(ran.environment, ran.pipeline, context, nullptr, 2);
  return ran;
}

Ran run(const char* pipeline) {
  return run(Soup().floor(0, 0, 4, 4, 0).floor(8, 0, 10, 4, 0).floor(0, 0, 4, 4, 3), pipeline);
}

}  // namespace

class TestHtmlReport : public QObject {
  Q_OBJECT
 private slots:
  void tellsWhatThereIs() {
    const Ran ran = run("SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n");
    const std::string html = formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {});
    QCOMPARE(findError(html), QString());
    for (const char* text : {"<title>&lt;level&gt; &amp; &quot;more&quot;.obj: walkable area</title>",
                             "slope 45 degrees, height 2", "VerticalClearanceFilter 2", "3 connected parts", "2 layers",
                             "layer_1", ">40<", "prefers-color-scheme: dark", "6 triangles, 18 vertices; Z up"})
      QVERIFY2(html.find(text) != std::string::npos, text);
    QVERIFY(html.find("Pictures") == std::string::npos);
    QVERIFY(html.find("Cells and threads") == std::string::npos);
    QVERIFY(html.find("/a/b") == std::string::npos);
  }

  void areasAreInSquareMetresWhereTheScaleIsKnown() {
    const Ran ran = run("SlopeFilter 45\n");
    ran.environment->metresPerUnit = 0.5;
    ran.environment->scaleGuessed = false;
    const std::string known = formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {});
    for (const char* text : {"Areas are in square metres", "0.5 m each", ">10 m²<", ", area 10 m²;"})
      QVERIFY2(known.find(text) != std::string::npos, text);
    QCOMPARE(findError(known), QString());
    ran.environment->scaleGuessed = true;
    const std::string guessed = formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {});
    for (const char* text : {"whose scale is a guess", ">40<", ", area 40;"})
      QVERIFY2(guessed.find(text) != std::string::npos, text);
    QVERIFY(guessed.find("m²") == std::string::npos);
  }

  void hasCellsAndThreads() {
    const Ran ran = run("GridStrategy 2 1\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n");
    const std::string html = formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {});
    QCOMPARE(findError(html), QString());
    QVERIFY(html.find("Cells and threads") != std::string::npos);
    QVERIFY(html.find("2 cells") != std::string::npos);
  }

  void picturesAreInside() {
    const Ran ran = run("SlopeFilter 45\n");
    const std::array pictures{ReportPicture{"From the \"top\" <b>", "\x89PNG\r\n"}};
    const std::array legend{ReportPicture{"Walkable & dry", "\x89PNG\r\n"}};
    const std::string html =
        formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {}, {"2026-11-22 <10:15>", pictures, legend});
    QCOMPARE(findError(html), QString());
    QVERIFY(html.find("<img alt=\"From the &quot;top&quot; &lt;b&gt;\" src=\"data:image/png;base64,iVBORw0K\"/>") !=
            std::string::npos);
    QVERIFY(html.find("\"/> Walkable &amp; dry</li>") != std::string::npos);
    QVERIFY(html.find(" on 2026-11-22 &lt;10:15&gt;. Lengths") != std::string::npos);
    // The bytes depend on the input only, which includes the date.
    const std::string undated =
        formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {}, {"", pictures, legend});
    QVERIFY(undated.find(" on 20") == std::string::npos && undated.size() < html.size());
  }

  void bottlenecksAreATable() {
    // Two rooms with a passage of 1 between them, and two with one of 0.08.
    Ran ran = run(Soup()
                      .floor(0, 0, 4, 4, 0)
                      .floor(4, 1.5, 6, 2.5, 0)
                      .floor(6, 0, 10, 4, 0)
                      .floor(20, 0, 24, 4, 0)
                      .floor(24, 1.5, 26, 1.58, 0)
                      .floor(26, 0, 30, 4, 0),
                  "SlopeFilter 45\n");
    const CorridorMap map = makeCorridorMap(*ran.result.mesh);
    const auto html = [&](const CorridorMap* corridors) {
      return formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {}, {{}, {}, {}, corridors});
    };
    QVERIFY(html(nullptr).find("Bottlenecks") == std::string::npos);
    QCOMPARE(findError(html(&map)), QString());
    ran.environment->scaleGuessed = true;
    const auto holds = [&](const char* text) { return html(&map).find(text) != std::string::npos; };
    QVERIFY(holds("<h2>Bottlenecks</h2>\n<p>1 bottleneck, the narrowest first."));
    QVERIFY(holds("<tr><td>5 2 0</td><td>areas of 17 and 17</td><td>yes</td><td class=\"number\">1</td></tr>"));
    QVERIFY(holds("<p class=\"quiet\">Left out: 1, at most 0.1 wide.</p>"));
    QVERIFY(!holds("RadiusFilter"));
    ran.environment->metresPerUnit = 2;
    ran.environment->scaleGuessed = false;
    QVERIFY(holds("<p>2 bottlenecks"));
    QVERIFY(
        holds("<td>areas of 68 m\u00b2 and 68 m\u00b2</td><td>yes</td><td class=\"number\">1</td>"
              "<td class=\"number\">2 m</td></tr>"));
    ran.pipeline = parsePipeline("SlopeFilter 45\nRadiusFilter 0.3\n", "test");
    QVERIFY(holds("A RadiusFilter has made every passage narrower."));
    QCOMPARE(findError(html(&map)), QString());
  }

  void thereAreFiftyBottlenecksAtMost() {
    const Ran ran = run("SlopeFilter 45\n");
    CorridorMap map;
    map.vertices.push_back({{}, 100, 0});
    map.bottlenecks.resize(1053);
    for (std::size_t i = 0; i < map.bottlenecks.size(); ++i) map.bottlenecks[i].width = 1 + static_cast<double>(i) / 64;
    const std::string html = formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {}, {{}, {}, {}, &map});
    QVERIFY(html.find("<p>1,053 bottlenecks") != std::string::npos);
    QVERIFY(html.find(">widths of up to 100 and 100</td><td>no</td><td class=\"number\">1.76562<") !=
            std::string::npos);
    QVERIFY(html.find(">1.78125<") == std::string::npos);
    QVERIFY(html.find("Left out: 1,003 that are wider.") != std::string::npos);
  }

  void tellsWhatWasSkipped() {
    Ran ran = run("SlopeFilter 45\n");
    const auto html = [&] { return formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {}); };
    QVERIFY(html().find("<p>Nothing was left out on import.</p>") != std::string::npos);
    ran.environment->skipped.points = 2;
    SkippedPolygon polygon;
    polygon.line = 12;
    polygon.cornerCount = 2;
    addSkipped(ran.environment->skipped, polygon);
    QVERIFY(html().find("<p>Left out on import: 1 polygon, 2 points.</p>\n<pre>  line 12: ") != std::string::npos);
    QCOMPARE(findError(html()), QString());
  }

  void theDateCanBeGiven() {
    QVERIFY(QRegularExpression("^20\\d\\d-\\d\\d-\\d\\d \\d\\d:\\d\\d UTC$").match(reportDate().c_str()).hasMatch());
    qputenv("SOURCE_DATE_EPOCH", "86400");
    const std::string given = reportDate();
    qputenv("SOURCE_DATE_EPOCH", "yesterday");
    const std::string bad = reportDate();
    qunsetenv("SOURCE_DATE_EPOCH");
    QCOMPARE(given, std::string("1970-01-02 00:00 UTC"));
    QVERIFY(bad.starts_with("20"));
  }

  void nothingWalkable() {
    Ran ran = run("SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 1000\n");
    QCOMPARE(findError(formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {})), QString());
    QCOMPARE(findError(formatHtmlReport(Environment(), Pipeline(), RunResult(), {})), QString());
  }

  void noTextBreaksIt() {
    QCOMPARE(escapeHtml("a<b>&\"'\x01\x7F\n"), std::string("a&lt;b&gt;&amp;&quot;&#39;\n"));
    QCOMPARE(escapeHtml("gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x98\x80"),
             std::string("gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x98\x80"));
    const std::string replaced = "\xEF\xBF\xBD";
    for (const char* bad : {"\xFF", "\xC0\xAF", "\xE2\x82", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80"})
      QVERIFY2(escapeHtml(bad).starts_with(replaced), bad);
    QCOMPARE(escapeHtml("\xE2<"), replaced + "&lt;");
    Ran ran = run("SlopeFilter 45\n");
    ran.environment->source = "\xFF\xFE</title><script>\x02";
    QCOMPARE(findError(formatHtmlReport(*ran.environment, ran.pipeline, ran.result, {})), QString());
  }

  void base64() {
    QCOMPARE(toBase64(""), std::string());
    QCOMPARE(toBase64("f"), std::string("Zg=="));
    QCOMPARE(toBase64("fo"), std::string("Zm8="));
    QCOMPARE(toBase64("foo"), std::string("Zm9v"));
    QByteArray all;
    for (int i = 0; i < 256; ++i) all.append(static_cast<char>(i));
    QCOMPARE(QByteArray::fromStdString(toBase64(all.toStdString())), all.toBase64());
  }

  void theCommandLineWritesIt() {
    const TemporaryFolder folder;
    const QString in = QString::fromStdString(folder.write("in.obj", "v 0 0 0\nv 4 0 0\nv 4 0 -4\nf 1 2 3\n"));
    const std::string out = folder.path("report.html");
    const auto run = [&](const QString& target) { return runProgram({"run", in, "--quiet", "--report", target}); };
    QCOMPARE(run(QString::fromStdString(out)).exitCode, 0);
    QCOMPARE(findError(readAll(out).toStdString()), QString());
    QVERIFY(!readAll(out).contains("Bottlenecks"));
    const QString house = FOOTFALL_SOURCE_DIR "/samples/house/house.obj";
    const Outcome noReport = runProgram({"run", house, "--quiet", "--bottlenecks"});
    QCOMPARE(noReport.exitCode, 2);
    QVERIFY2(noReport.err.contains("give --report or --stats"), noReport.err.constData());
    const QString statistics = QString::fromStdString(folder.path("stats.json"));
    QCOMPARE(runProgram({"run", house, "--quiet", "--bottlenecks", "--stats", statistics, "--report",
                         QString::fromStdString(out)})
                 .exitCode,
             0);
    QVERIFY(readAll(out).contains("<h2>Bottlenecks</h2>"));
    QCOMPARE(findError(readAll(out).toStdString()), QString());
    QVERIFY(readAll(statistics.toStdString()).contains("\"bottlenecks\""));
    const Outcome full = run("/dev/full");
    QCOMPARE(full.exitCode, 1);
    QVERIFY2(full.err.contains("the disk is full"), full.err.constData());
    QCOMPARE(run("/nowhere/report.html").exitCode, 1);
    QCOMPARE(run(QString::fromStdString(folder.path("report.obj"))).exitCode, 2);
    QCOMPARE(run(in).exitCode, 2);
  }
};

QTEST_GUILESS_MAIN(TestHtmlReport)
#include "test_html_report.moc"
