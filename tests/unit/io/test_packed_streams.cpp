// Packing: environments of all formats come back bit by bit, and those that can be streamed are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QRandomGenerator>
#include <QtTest>
#include <algorithm>
#include <cstring>

#include "core/base/process_usage.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/packed_round_trip.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

template <class Number>
void append(QByteArray& bytes, std::initializer_list<Number> numbers) {
  for (const Number number : numbers) bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Two meshes, one of them of two primitives over one list of vertices with a stride, under turned, mirrored and nested
/// nodes, with and without names. `more` goes into the first primitive.
QByteArray binaryGltf(const QByteArray& more = {}) {
  QByteArray binary;
  append<float>(binary, {0, 0, 0, -0.0F, 0, 0.1F, 4, 0, 0, 4.3F, 1, 2, 9, 9, 9});  // 5 places, the last of no face
  append<std::uint16_t>(binary, {0, 1, 2, 2, 1, 3, 1, 1, 3, 0});                   // three faces, one degenerate
  const int second = static_cast<int>(binary.size());
  for (int i = 0; i < 6; ++i) append<float>(binary, {0.1F * static_cast<float>(i), i % 2 * 0.7F, 3, 77, 77});
  append<std::uint8_t>(binary, {0, 1, 2, 3, 4, 5, 5, 4});
  append<std::uint32_t>(binary, {5, 3, 1});
  const auto text = [](int number) { return QByteArray::number(number); };
  QByteArray json =
      "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,3]}],\"nodes\":["
      "{\"name\":\"turned\",\"mesh\":0,\"rotation\":[0.1,0.2,0.3,0.927],\"translation\":[5,0.1,2],\"children\":[1,2]},"
      "{\"mesh\":1,\"scale\":[-1.5,2,0.3]},{\"name\":\"turned\",\"mesh\":0,\"translation\":[1,2,3]},"
      "{\"mesh\":1,\"matrix\":[0,0,-2,0,0,2,0,0,2,0,0,0,7,8,9,1]}],"
      "\"materials\":[{\"name\":\"wood\",\"doubleSided\":true},{}],\"meshes\":["
      "{\"name\":\"one\",\"primitives\":[{" +
      more +
      "\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0}]},"
      "{\"primitives\":[{\"attributes\":{\"POSITION\":2},\"indices\":3,\"material\":1},"
      "{\"attributes\":{\"POSITION\":2},\"indices\":4}]}],"
      "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":5,\"type\":\"VEC3\"},"
      "{\"bufferView\":0,\"byteOffset\":60,\"componentType\":5123,\"count\":9,\"type\":\"SCALAR\"},"
      "{\"bufferView\":1,\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"},"
      "{\"bufferView\":2,\"componentType\":5121,\"count\":6,\"type\":\"SCALAR\"},"
      "{\"bufferView\":2,\"byteOffset\":8,\"componentType\":5125,\"count\":3,\"type\":\"SCALAR\"}],"
      "\"bufferViews\":[{\"buffer\":0,\"byteLength\":" +
      text(second) +
      "},"
      "{\"buffer\":0,\"byteOffset\":" +
      text(second) +
      ",\"byteLength\":120,\"byteStride\":20},"
      "{\"buffer\":0,\"byteOffset\":" +
      text(second + 120) +
      ",\"byteLength\":20}],"
      "\"buffers\":[{\"byteLength\":" +
      text(static_cast<int>(binary.size())) + "}]}";
  json += QByteArray((4 - json.size() % 4) % 4, ' ');
  QByteArray file;
  const auto size = [](const QByteArray& bytes) { return static_cast<std::uint32_t>(bytes.size()); };
  append<std::uint32_t>(file, {0x46546C67, 2, 28 + size(json) + size(binary), size(json), 0x4E4F534A});
  file += json;
  append<std::uint32_t>(file, {size(binary), 0x004E4942});
  return file + binary;
}

}  // namespace

class TestPackedStreams : public QObject {
  Q_OBJECT
 private slots:
  void environmentsComeBackBitByBit_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<bool>("isStreamed");
    const QString source = FOOTFALL_SOURCE_DIR;
    for (const char* name : {"arena", "docks", "house", "rooms", "tower", "villa"})
      for (const QString& file : QDir(source + "/samples/" + name).entryList({"*.obj", "*.glb", "*.gltf"}))
        QTest::newRow(qPrintable(file)) << source + "/samples/" + name + '/' + file << file.endsWith(".obj");
    for (const char* name :
         {"floor.stl", "polygons.ply", "floor.3ds", "transforms.gltf", "z_up.dae", "z_up_inches.fbx"})
      QTest::newRow(name) << source + "/tests/data/" + name
                          << (QString(name).endsWith("stl") || QString(name).endsWith("ply"));
    if (sharedEnvironments().isEmpty()) return;
    for (const QString& file : QDir(sharedEnvironments()).entryList({"*.obj"}))
      QTest::newRow(qPrintable(file)) << sharedEnvironments() + '/' + file << true;
  }
  void environmentsComeBackBitByBit() {
    QFETCH(QString, path);
    QFETCH(bool, isStreamed);
    QCOMPARE(roundTrip(path.toStdString(), isStreamed), QString());
  }

  void objOfAllKinds_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("isStreamed");
    const QByteArray square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    QTest::newRow("waves") << QByteArray(waves()) << true;
    QTest::newRow("relative indices") << QByteArray(square + "f -4 -3 -2\nv 5 5 5\nf -1 -2 -3 -4\n") << true;
    QTest::newRow("triangles before their vertices") << QByteArray("f 1 2 3\n" + square) << true;
    QTest::newRow("polygons before their vertices")
        << QByteArray("l 1 2\no a\nf 1 2 3 4\no b\nf 1 2 1\n" + square) << true;
    QTest::newRow("continued lines") << QByteArray(square + "f 1 \\\n2 \\\r\n3\n") << true;
    QTest::newRow("byte order mark and minus zero")
        << QByteArray("\xEF\xBB\xBF" + square + "v -0 -0.0 -0\nf 1 2 5\n") << true;
    QTest::newRow("lone carriage returns") << QByteArray(square + "f 1 2 3\n").replace('\n', '\r') << false;
    QTest::newRow("far apart") << QByteArray("v -1e308 0 0\nv 1e308 0 0\nv 0 1e308 0\nv 5e-324 0 0\nf 1 2 3\nf 1 2 4\n")
                               << true;
    QTest::newRow("no names") << QByteArray(square + "f 1 2 3\n") << true;
    QTest::newRow("names that are no text") << QByteArray(square + "o \xff\x01\nf 1 2 3\n") << true;
  }
  void objOfAllKinds() {
    QFETCH(QByteArray, text);
    QFETCH(bool, isStreamed);
    const TemporaryFolder folder;
    QCOMPARE(roundTrip(folder.write("file.obj", text), isStreamed), QString());
  }

  void objInPieces() {
    // More than one piece of 4 MiB, with a polygon that comes before its vertices in another one.
    const TemporaryFolder folder;
    QByteArray text = waves();
    const QByteArray filler = "# " + QByteArray(1000, 'x') + '\n';
    for (int i = 0; i < 5000; ++i) text += filler;
    const QByteArray later = text + "v 9 9 9\nv 8 9 9\nf -1 -2 1 3\nf 5 6 7\n";
    QCOMPARE(roundTrip(folder.write("relative.obj", later), true), QString());
    const QByteArray early = "f 1 2 3 4\nf 4 3 2\n" + text;
    QCOMPARE(roundTrip(folder.write("early.obj", early), true), QString());
    const std::string wrong = folder.write("wrong.obj", text + "f 1 2 99999999\n");
    const QString whole = messageOf<InputError>([&] { importEnvironment(wrong); });
    const auto pack = [&] { packEnvironment(wrong, folder.path("wrong.ffenv"), {}, nullptr); };
    QCOMPARE(messageOf<InputError>(pack), whole);
    QVERIFY(whole.contains("out of range"));
  }

  void stlOfAllKinds() {
    const TemporaryFolder folder;
    QRandomGenerator random(7);
    QByteArray binary(80, 'c'), ascii;
    const int facets = 20000;
    binary.append(reinterpret_cast<const char*>(&facets), 4);
    for (int i = 0; i < facets; ++i) {
      for (int k = 0; k < 12; ++k) {
        const auto x = static_cast<float>(random.bounded(1000.0) - 500);
        binary.append(reinterpret_cast<const char*>(&x), 4);
      }
      binary.append(2, '\1');
    }
    QCOMPARE(roundTrip(folder.write("binary.stl", binary), true), QString());
    for (const char* name : {" left", "", " right hand"}) {
      ascii += QByteArray("solid") + name + '\n';
      for (int i = 0; i < 2000; ++i) {
        ascii += "facet normal 0 0 1\n outer loop\n";
        for (int k = 0; k < 3; ++k) {
          ascii += "  vertex";
          for (int axis = 0; axis < 3; ++axis)
            ascii += ' ' + QByteArray::number(random.bounded(2000.0) - 1000, axis == 1 ? 'e' : 'f', 4 + 3 * axis);
          ascii += '\n';
        }
        ascii += " endloop\nendfacet\n";
      }
      ascii += QByteArray("endsolid") + name + '\n';
    }
    QCOMPARE(roundTrip(folder.write("ascii.stl", ascii), true), QString());
    // A line that no piece holds ends nothing.
    QCOMPARE(roundTrip(folder.write("long.stl", ascii + QByteArray(20 << 20, ' ') + '\n' + ascii), false), QString());
    const QByteArray oneLine = QByteArray(ascii).replace("\n outer", " outer");
    QCOMPARE(roundTrip(folder.write("lines.stl", oneLine), false), QString());
  }

  void plyOfAllKinds_data() {
    QTest::addColumn<QByteArray>("format");
    QTest::addColumn<QByteArray>("type");
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
      for (const char* type : {"float", "double", "int", "short"})
        QTest::newRow(qPrintable(QString(format) + ' ' + type)) << QByteArray(format) << QByteArray(type);
  }
  void plyOfAllKinds() {
    QFETCH(QByteArray, format);
    QFETCH(QByteArray, type);
    constexpr int kVertices = 5000, kFaces = 9000;
    QRandomGenerator random(3);
    QByteArray file = "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " +
                      QByteArray::number(kVertices) + "\nproperty uchar red\n";
    for (const char* axis : {"x", "z", "y"}) file += "property " + type + ' ' + axis + '\n';
    file += "element face " + QByteArray::number(kFaces) +
            "\nproperty list uchar int vertex_indices\nproperty short flag\nend_header\n";
    const bool isAscii = format == "ascii", isBig = format.contains("big");
    const auto add = [&](auto value) {
      if (isAscii) {
        file += QByteArray::number(value, 'g', 9) + ' ';
        return;
      }
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      if (isBig) std::reverse(bytes, bytes + sizeof value);
      file.append(bytes, sizeof value);
    };
    const auto addWhole = [&](auto value) {
      if (isAscii) {
        file += QByteArray::number(static_cast<int>(value)) + ' ';
        return;
      }
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      if (isBig) std::reverse(bytes, bytes + sizeof value);
      file.append(bytes, sizeof value);
    };
    const auto endLine = [&] {
      if (isAscii) file[file.size() - 1] = '\n';
    };
    for (int v = 0; v < kVertices; ++v) {
      addWhole(static_cast<unsigned char>(v % 256));
      for (int axis = 0; axis < 3; ++axis) {
        const double x = (random.bounded(2.0) - 1) * 1000;
        if (type == "float") add(static_cast<float>(x));
        if (type == "double") add(x);
        if (type == "int") addWhole(static_cast<std::int32_t>(x));
        if (type == "short") addWhole(static_cast<std::int16_t>(x));
      }
      endLine();
    }
    for (int f = 0; f < kFaces; ++f) {
      const int corners = 3 + f % 3;
      addWhole(static_cast<unsigned char>(corners));
      for (int k = 0; k < corners; ++k)
        addWhole(static_cast<std::int32_t>(f % 1000 == 999 ? 5 : random.bounded(kVertices)));
      addWhole(static_cast<std::int16_t>(-7));
      endLine();
    }
    const TemporaryFolder folder;
    const std::string path = folder.write("file.ply", file);
    QVERIFY(importEnvironment(path)->skipped.polygons > 0);
    QCOMPARE(roundTrip(path, true), QString());
    const std::string cut = folder.write("cut.ply", file.left(file.size() - 100));
    const QString whole = messageOf<InputError>([&] { importEnvironment(cut); });
    QVERIFY(!whole.isEmpty());
    QCOMPARE(messageOf<InputError>([&] { packEnvironment(cut, folder.path("cut.ffenv"), {}, nullptr); }), whole);
  }

  // The size that a file states for itself is allocated only if the file is as large.
  void binaryGltfWithALargeNumber() {
    QByteArray bytes;
    append<std::uint32_t>(bytes, {0x46546C67, 2, 20, 0xFFFFFFF0, 0x4E4F534A});
    const TemporaryFolder folder;
    const std::string path = folder.write("large.glb", bytes);
    const std::uint64_t before = peakRssBytes();
    const QString message = messageOf<InputError>([&] { packEnvironment(path, folder.path("a.ffenv"), {}, nullptr); });
    QVERIFY2(message.startsWith(QString::fromStdString(path) + ": ") && message.contains("ends before"),
             qPrintable(message));
    QVERIFY(peakRssBytes() < before + 500'000'000);
    QVERIFY(!folder.files().contains("a.ffenv"));
  }

  void binaryGltfOfAllKinds() {
    const TemporaryFolder folder;
    const std::string path = folder.write("plain.glb", binaryGltf());
    const auto whole = importEnvironment(path);
    QCOMPARE(whole->triangles.size(), std::size_t{10});
    QVERIFY(whole->parts.size() >= 2);
    QCOMPARE(whole->skipped.polygons, std::uint64_t{2});
    QCOMPARE(roundTrip(path, true), QString());
    ImportOptions turned;
    turned.up = UpAxis::Z;
    QCOMPARE(roundTrip(path, true, turned), QString());
    QCOMPARE(roundTrip(folder.write("lines.glb", binaryGltf("\"mode\":5,")), false), QString());
    // Errors are reported as before.
    const QByteArray good = binaryGltf();
    const std::string cut = folder.write("cut.glb", good.left(good.size() - 30));
    const QString message = messageOf<InputError>([&] { importEnvironment(cut); });
    QVERIFY(!message.isEmpty());
    QCOMPARE(messageOf<InputError>([&] { packEnvironment(cut, folder.path("cut.ffenv"), {}, nullptr); }), message);
  }
};

QTEST_GUILESS_MAIN(TestPackedStreams)
#include "test_packed_streams.moc"
