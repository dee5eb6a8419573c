// A stand-in for the converter of IFC files and for Node.js, with the output that a test needs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <optional>
#include <string>

#include "tests/unit/environment_files.hpp"

namespace footfall::test {

/// Sets a variable of the environment for as long as it lives.
class Variable {
 public:
  Variable(const char* name, const QByteArray& value)
      : name_(name), wasSet_(qEnvironmentVariableIsSet(name)), before_(qgetenv(name)) {
    qputenv(name, value);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() {
    if (wasSet_)
      qputenv(name_, before_);
    else
      qunsetenv(name_);
  }

 private:
  const char* name_;
  bool wasSet_;
  QByteArray before_;
};

/// A converter and a program `node`, first in PATH, that run `script`.
class Converter {
 public:
  explicit Converter(const QByteArray& script) {
    QDir(QString::fromStdString(folder_.path(""))).mkpath(QStringLiteral("node_modules/web-ifc"));
    folder_.write("node_modules/web-ifc/package.json", "{}");
    const std::string node = folder_.write("node", "#!/bin/sh\n" + script);
    QFile::setPermissions(QString::fromStdString(node),
                          QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
    file_.emplace("FOOTFALL_IFC", QByteArray::fromStdString(folder_.write("footfall-ifc.mjs", "")));
    path_.emplace("PATH", QByteArray::fromStdString(folder_.path("")) + ":" + qgetenv("PATH"));
    building = folder_.write("house.ifc", "ISO-10303-21;");
  }

  std::string building;

 private:
  TemporaryFolder folder_;
  std::optional<Variable> file_, path_;
};

/// A converter's answer: a square floor of 4 m in millimetres, a door, a table; two storeys.
inline constexpr const char* kHouse =
    "cat <<'END'\n"
    "# footfall-ifc 1\n# metres per unit: 0.001\n# storey: 3000 Above\n# storey: 0 Ground\n"
    "o IfcSlab\nusemtl Ground: Floor\nv 0 0 0\nv 4000 0 0\nv 4000 4000 0\nv 0 4000 0\nf 1 2 3\nf 1 3 4\n"
    "o IfcDoor\nusemtl Ground: Door\nv 1000 1000 0\nv 2000 1000 0\nv 2000 1100 2000\nf 5 6 7\n"
    "o IfcFurniture\nusemtl Ground: Table\nv 3000 3000 800\nv 3500 3000 800\nv 3500 3500 800\nf 8 9 10\n"
    "END\n";

}  // namespace footfall::test
