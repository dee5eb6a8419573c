// Packed environments: opening, parts of them, damage, full disks, and what runs make of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <QRandomGenerator>
#include <QtTest>
#include <cstring>

#include "core/base/vector.hpp"
#include "core/io/packed/pack.hpp"
#include "core/io/packed/packed_description.hpp"
#include "core/io/packed/packed_environment.hpp"
#include "footfall/up_axis.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/first_packed_version.hpp"
#include "tests/unit/packed_round_trip.hpp"
#include "tests/unit/program_run.hpp"
#include "tests/unit/small_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

std::uint64_t read64(const QByteArray& bytes, int at) {
  std::uint64_t value;
  std::memcpy(&value, bytes.constData() + at, sizeof value);
  return value;
}

/// Puts its check sum into a header that was changed.
}  // namespace

class TestPackedEnvironment : public QObject {
  Q_OBJECT
 private slots:
  void whatBuildingsSayComesBack() {
    Environment building;
    building.source = "/somewhere/house.ifc";
    building.up = UpAxis::NegativeX;
    building.metresPerUnit = 0.001;
    building.scaleGuessed = false;
    building.parts = {{"IfcDoor/a", "wood"}, {"wall", ""}, {"\xc3\xa4", "x"}};
    building.usualRoles = {PartRole::Ignored, PartRole::Floor, PartRole::ObstacleOnly};
    building.storeys = {{"cellar", -2.5}, {"ground", 0.1}};
    building.notes = {Text(FOOTFALL_TEXT("a %1 of %2"), Text(Pattern{"%1 x"}, 3), Text::count(12345)), "plain %1",
                      Text(FOOTFALL_TEXT("no places")), Text(Pattern{"%1%2%3%4%5%6%7%8%9"}, 1, 2, 3, 4, 5, 6, 7, 8, 9)};
    building.skipped = {1, 2, 3, {{SkipReason::RepeatedCorners, 4, 0, 7, "wall", {{1, 2, 3}, {4, 5, 6}}}}};
    const std::string bytes = encodeDescription(building);
    Environment decoded = decodeDescription(bytes);
    QCOMPARE(decoded.origin, std::string("house.ifc"));
    for (Vec3& p : decoded.skipped.listed[0].corners) p = fromFileFrame(p, decoded.up);
    QCOMPARE(differenceOf(building, decoded), QString());
    for (std::size_t size = 0; size < bytes.size(); ++size)
      QVERIFY_EXCEPTION_THROWN(decodeDescription(std::string_view(bytes).substr(0, size)), std::runtime_error);
    QVERIFY_EXCEPTION_THROWN(decodeDescription(bytes + 'x'), std::runtime_error);
  }

  void foldersAndPackedOnes() {
    const TemporaryFolder folder, other;
    folder.write("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
    folder.write("b.obj", waves());
    QCOMPARE(roundTrip(folder.path(""), false), QString());
    packEnvironment(folder.path("b.obj"), other.path("b.ffenv"), {}, nullptr);
    QCOMPARE(roundTrip(other.path("b.ffenv"), false), QString());  // and the name is that of the first file
    packEnvironment(other.path("b.ffenv"), other.path("c.ffenv"), {}, nullptr);
    QVERIFY(readAll(other.path("b.ffenv")) == readAll(other.path("c.ffenv")));
  }

  void optionsAreAsIfTheFileSaidThem() {
    const TemporaryFolder folder;
    const std::string path = folder.write("file.obj", "v 1 2 3\nv 4 0 0\nv 0 4 0\nf 1 2 3\nf 1 2\n");
    for (const UpAxis packed : kUpAxes)
      for (const UpAxis opened : kUpAxes) {
        ImportOptions packing, opening;
        packing.up = packed;
        QCOMPARE(roundTrip(path, true, packing), QString());
        opening.up = opened;
        QCOMPARE(roundTrip(path, true, packing, opening), QString());
        QCOMPARE(roundTrip(path, true, {}, opening), QString());
      }
    ImportOptions sides;
    sides.bothSides = true;
    QCOMPARE(roundTrip(path, true, sides), QString());
    QCOMPARE(roundTrip(path, true, {}, sides), QString());
  }

  void facesOfABox() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const auto whole = importEnvironment(path);
    const PackedEnvironment packed(target);
    QVERIFY(packed.blocks().size() > 2);
    const std::uint64_t atFirst = packed.bytesRead();
    QVERIFY(packed.facesTouching({{100, 100, 100}, {101, 101, 101}}).faceNumbers.empty());
    QCOMPARE(packed.bytesRead(), atFirst);
    const std::vector<Box> boxes{{{1, -2, -1}, {1.05, -1.9, 1}},
                                 {{0, -9, 0.02}, {9, 0, 0.02}},
                                 {{0.5, -0.5, 0}, {0.5, -0.5, 0}},
                                 {{-100, -100, -100}, {100, 100, 100}}};
    for (const Box& box : boxes) {
      const PackedFaces found = packed.facesTouching(box);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t t = 0; t < whole->triangles.size(); ++t) {
        bool isTouching = true;
        for (int axis = 0; axis < 3; ++axis) {
          const auto at = [&](int k) {
            const Vec3& p = whole->vertices[whole->triangles[t][static_cast<std::size_t>(k)]];
            return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
          };
          const auto i = static_cast<std::size_t>(axis);
          isTouching = isTouching && std::max({at(0), at(1), at(2)}) >= box.lower[i] &&
                       std::min({at(0), at(1), at(2)}) <= box.upper[i];
        }
        if (isTouching) expected.push_back(t);
      }
      QVERIFY(!expected.empty());
      QVERIFY(found.faceNumbers == expected);
      for (std::size_t f = 0; f < expected.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t local = found.soup.triangles[f][k];
          QCOMPARE(found.vertexNumbers[local], whole->triangles[expected[f]][k]);
          QVERIFY(found.soup.vertices[local] == whole->vertices[found.vertexNumbers[local]]);
        }
        QCOMPARE(found.partOf[f], whole->partOf[expected[f]]);
      }
      if (&box == &boxes.front()) {
        std::uint64_t ofBlocks = 0;
        for (const std::size_t block : packed.blocksTouching(box)) ofBlocks += packed.blocks()[block].size;
        QCOMPARE(packed.bytesRead() - atFirst, ofBlocks);
        QVERIFY(packed.blocksTouching(box).size() < packed.blocks().size());
      }
    }
  }

  void blocksAreKeptAsLongAsTheyMay() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const PackedEnvironment packed(target);
    const auto readFor = [&](std::size_t block) {
      const std::uint64_t before = packed.bytesRead();
      static_cast<void>(packed.block(block));
      return packed.bytesRead() - before;
    };
    const std::uint64_t first = packed.blocks()[0].size, second = packed.blocks()[1].size;
    QVERIFY(first > 0 && second > 0);
    packed.keepBlocks(first + second);
    QCOMPARE(readFor(0), first);
    QCOMPARE(readFor(1), second);
    QCOMPARE(readFor(0), std::uint64_t{0});
    QCOMPARE(readFor(1), std::uint64_t{0});
    // The last request stays.
    QCOMPARE(readFor(0), std::uint64_t{0});
    packed.keepBlocks(first);
    QCOMPARE(readFor(0), std::uint64_t{0});
    QCOMPARE(readFor(1), second);
    QCOMPARE(readFor(0), first);
    packed.forgetBlocks();
    QCOMPARE(readFor(0), first);
  }

  void damageIsToldInOneLine() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const QByteArray good = readAll(target);
    const auto message = [&](const QByteArray& bytes) {
      const std::string file = folder.write("bad.ffenv", bytes);
      const QString text = messageOf<InputError>([&] { importEnvironment(file); });
      if (!text.startsWith(QString::fromStdString(file)) || !text.contains("; ")) return "no message: " + text;
      return text;
    };
    QVERIFY(message("").contains("is empty"));
    QVERIFY(message("ffenv").contains("no packed environment"));
    QVERIFY(message(QByteArray(500, 'x')).contains("is no packed environment"));
    QVERIFY(message(good.left(good.size() - 1)).contains("cut off"));
    QVERIFY(message(good + 'x').contains("is damaged"));
    for (int size = 0; size < good.size(); size += 9973) QVERIFY(!message(good.left(size)).startsWith("no message"));
    QByteArray later = good;
    later[8] = 4;
    QVERIFY(message(later).contains("of version 4, and this program reads versions up to 3"));
    QRandomGenerator random(1);
    for (int i = 0; i < 300; ++i) {
      QByteArray changed = good;
      const int at = random.bounded(i < 150 ? 200 : static_cast<int>(good.size()));
      changed[at] = static_cast<char>(changed[at] ^ (1 << random.bounded(8)));
      const std::string file = folder.write("bad.ffenv", changed);
      // Bytes between the arrays count for nothing.
      if (messageOf<InputError>([&] { importEnvironment(file); }).isEmpty())
        QCOMPARE(differenceOf(*importEnvironment(path), *importEnvironment(file)), QString());
    }
  }

  void coarseFacesStandForBlocks() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const PackedEnvironment packed(target);
    std::vector<std::size_t> counts(packed.blocks().size());
    double area = 0;
    const std::uint64_t atFirst = packed.bytesRead();
    packed.forCoarseFaces([&](std::size_t block, const CoarseFace& face) {
      ++counts[block];
      const Box box = packed.boxOf(block);
      for (const Vec3& p : face) {
        constexpr double kStep = 1e-6;
        QVERIFY(p.x >= box.lower[0] - kStep && p.x <= box.upper[0] + kStep);
        QVERIFY(p.y >= box.lower[1] - kStep && p.y <= box.upper[1] + kStep);
        QVERIFY(p.z >= box.lower[2] - kStep && p.z <= box.upper[2] + kStep);
      }
      area += std::abs(normalOf(face[0], face[1], face[2]).z) / 2;
    });
    std::uint64_t coarse = 0;
    for (const PackedBlock& block : packed.blocks()) coarse += block.coarse;
    QCOMPARE(packed.bytesRead() - atFirst, coarse * sizeof(PackedCoarseFace));
    double all = 0;
    const auto whole = importEnvironment(path);
    for (const Triangle& t : whole->triangles)
      all += std::abs(normalOf(whole->vertices[t[0]], whole->vertices[t[1]], whole->vertices[t[2]]).z) / 2;
    // Triangles of one size: they are moved together, and cover what they covered, with folds here and there.
    QVERIFY2(area > 0.85 * all && area < 1.5 * all, qPrintable(QString("%1 of %2").arg(area).arg(all)));
    for (std::size_t b = 0; b < counts.size(); ++b) {
      QCOMPARE(counts[b], std::size_t{packed.blocks()[b].coarse});
      QVERIFY(counts[b] <= 512 && (counts[b] > 64 || packed.blocks()[b].faces <= 512));
    }
  }

  void largeFacesStandForThemselves() {
    // A floor under many crumbs.
    std::vector<Vec3> places{{0, 0, 0}, {100, 0, 0}, {0, 100, 0}};
    std::vector<std::array<std::uint16_t, 3>> corners{{0, 1, 2}};
    for (int i = 0; i < 1000; ++i) {
      const auto first = static_cast<std::uint16_t>(places.size());
      for (const Vec3& p : {Vec3{0, 0, 1}, Vec3{0.1, 0, 1}, Vec3{0, 0.1, 1}})
        places.push_back({p.x + i / 25, p.y, p.z});
      corners.push_back({first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2)});
    }
    const std::vector<CoarseFace> faces = coarseFaces(places, corners, 10);
    QCOMPARE(faces.size(), std::size_t{10});
    QVERIFY(faces[0] == (CoarseFace{places[0], places[1], places[2]}));
    QVERIFY(coarseFaces({}, {}, 10).empty());
    const std::vector<Vec3> far{{-1e308, -1e308, 0}, {1e308, 0, 1e308}, {0, 1e308, -1e308}};
    QCOMPARE(coarseFaces(far, std::vector(20, std::array<std::uint16_t, 3>{0, 1, 2}), 10).size(), std::size_t{10});
  }

  void filesOfTheFirstVersionAreRead() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const QByteArray first = firstPackedVersion(readAll(target));
    const std::string old = folder.write("first.ffenv", first);
    QCOMPARE(differenceOf(*importEnvironment(path), *importEnvironment(old)), QString());
    int coarse = 0;
    PackedEnvironment(old).forCoarseFaces([&](std::size_t, const CoarseFace&) { ++coarse; });
    QCOMPARE(coarse, 0);
    packEnvironment(old, folder.path("again.ffenv"), {}, nullptr);
    QVERIFY(readAll(folder.path("again.ffenv")) == readAll(target));
  }

  void damagedCoarseFacesAreTold() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    QByteArray bytes = readAll(target);
    PackedHeader header;
    std::memcpy(&header, bytes.constData(), sizeof header);
    const auto coarse = static_cast<int>(read64(bytes, static_cast<int>(bytes.size() - sizeof(PackedCoarse))));
    bytes[coarse + 100] = static_cast<char>(bytes[coarse + 100] ^ 1);
    const PackedEnvironment packed(folder.write("bad.ffenv", bytes));
    const QString message =
        messageOf<InputError>([&] { packed.forCoarseFaces([](std::size_t, const CoarseFace&) {}); });
    QVERIFY2(message.contains("is damaged"), qPrintable(message));
  }

  void sizesThatOverflow() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const QByteArray good = readAll(target);
    for (int at = 16; at < 72; at += 8)  // sizes, counts and offsets
      for (const std::uint64_t value : {~std::uint64_t{0}, std::uint64_t{1} << 63, std::uint64_t{0xffffffff},
                                        read64(good, at) + 1, read64(good, at) - 1, std::uint64_t{0}}) {
        QByteArray changed = good;
        std::memcpy(changed.data() + at, &value, sizeof value);
        sealPacked(changed);
        if (changed == good) continue;
        const std::string file = folder.write("bad.ffenv", changed);
        QVERIFY2(!messageOf<InputError>([&] { importEnvironment(file); }).isEmpty(), qPrintable(QString::number(at)));
      }
  }

  void whatIsCutOffWhileItIsOpenIsNoticed() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const PackedEnvironment packed(target);
    QCOMPARE(::truncate(target.c_str(), 4096), 0);
    const QString message = messageOf<InputError>([&] { static_cast<void>(packed.block(0)); });
    QVERIFY2(message.contains("cut off while it was open"), qPrintable(message));
  }

  void whatIsWrittenOverWhileItIsOpenIsNoticed() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves()), target = folder.path("waves.ffenv");
    packEnvironment(path, target, {}, nullptr);
    const QByteArray good = readAll(target);
    const PackedEnvironment packed(target);
    const BlockArrays before = packed.block(0);
    const std::vector<std::uint32_t> faces(before.faces.begin(), before.faces.end());
    folder.write("waves.ffenv", QByteArray(good.size(), '\xff'));  // The file is changed in place.
    // Blocks that were read stay as they were until they are given back, also when they are read again.
    QVERIFY(std::equal(faces.begin(), faces.end(), before.faces.begin(), before.faces.end()));
    QCOMPARE(packed.block(0).faces.size(), faces.size());
    packed.forgetBlocks();
    for (std::size_t b = 0; b < packed.blocks().size(); ++b)
      QVERIFY(messageOf<InputError>([&] { static_cast<void>(packed.block(b)); }).contains("is damaged"));
    QVERIFY(messageOf<InputError>([&] { static_cast<void>(packed.readAll()); }).contains("is damaged"));
  }

  void cancellingAndAFullDiskLeaveNothing() {
    const TemporaryFolder folder;
    const std::string path = folder.write("waves.obj", waves());
    const std::string target = folder.write("waves.ffenv", "earlier");
    for (const double last : {0.0, 0.5, 0.6, 0.76}) {
      RunContext* running = nullptr;
      RunContext context([&](const RunEvent& event) {
        if (event.kind == RunEvent::Kind::Progress && event.fraction >= last) running->cancel();
      });
      running = &context;
      QVERIFY_EXCEPTION_THROWN(packEnvironment(path, target, {}, &context, kLittle), Cancelled);
      QCOMPARE(folder.files().size(), 2);
      QCOMPARE(readAll(target), QByteArray("earlier"));
    }
    for (const rlim_t size : {1000, 100000, 500000}) {
      const SmallFiles small(size);
      QVERIFY(!messageOf<RunError>([&] { packEnvironment(path, target, {}, nullptr, kLittle); }).isEmpty());
      QCOMPARE(folder.files().size(), 2);
      QCOMPARE(readAll(target), QByteArray("earlier"));
    }
    QVERIFY(!messageOf<RunError>([&] { packEnvironment(path, "/nowhere/x.ffenv", {}, nullptr); }).isEmpty());
  }

  void runsHaveTheSameBytes() {
    const TemporaryFolder folder;
    const QString house = QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/house/house.obj");
    const auto in = [&](const char* name) { return QString::fromStdString(folder.path(name)); };
    const Outcome packed = runProgram({"pack", house, "-o", in("house.ffenv")});
    QVERIFY2(packed.exitCode == 0, packed.err.constData());
    QVERIFY2(packed.out.contains("1 block, "), packed.out.constData());
    for (const char* ending : {"obj", "glb", "geojson", "tres", "svg"}) {
      const QString a = in("a.") + ending, b = in("b.") + ending;
      const bool isPlan = QString(ending) == "svg";
      const QString command = isPlan ? "plan" : "run";
      QCOMPARE(runProgram({command, house, "-o", a}).exitCode, 0);
      QCOMPARE(runProgram({command, in("house.ffenv"), "-o", b}).exitCode, 0);
      const QByteArray expected = contentOf(isPlan ? in("a-0.svg") : a);
      QVERIFY2(!expected.isEmpty() && expected == contentOf(isPlan ? in("b-0.svg") : b), ending);
    }
    const Outcome info = runProgram({"info", in("house.ffenv")});
    QVERIFY2(info.out.contains("packed from             house.obj"), info.out.constData());
  }

  void refusals() {
    const TemporaryFolder folder;
    const QString obj = QString::fromStdString(folder.write("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"));
    const auto in = [&](const char* name) { return QString::fromStdString(folder.path(name)); };
    const auto refused = [](const QStringList& arguments, const char* words) {
      const Outcome outcome = runProgram(arguments);
      return outcome.exitCode == 2 && outcome.err.contains(words);
    };
    QVERIFY(refused({"pack", obj}, "--output"));
    QVERIFY(refused({"pack", obj, "-o", in("b.obj")}, "ends in .ffenv"));
    QVERIFY(refused({"pack", in("no.obj"), "-o", in("b.ffenv")}, "no such file"));
    QCOMPARE(runProgram({"pack", obj, "-o", in("b.ffenv")}).exitCode, 0);
    QVERIFY(refused({"pack", in("b.ffenv"), "-o", in("b.ffenv")}, "would be overwritten"));
    QVERIFY(refused({"pack", in(""), "-o", in("c.ffenv")}, "would be a part of the environment"));
    QVERIFY(refused({"run", in("b.ffenv"), "-o", in("b.ffenv")}, ""));
  }
};

QTEST_GUILESS_MAIN(TestPackedEnvironment)
#include "test_packed_environment.moc"
