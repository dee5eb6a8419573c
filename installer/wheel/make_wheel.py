#!/usr/bin/env python3
# make_wheel.py BUILD_FOLDER OUTPUT_FOLDER: makes a wheel of the Python package in a finished build and prints its path.
# The wheel holds footfall-import, which reads other formats, and the libraries that both need beyond those that manylinux
# (PEP 600) leaves to the machine. Needs patchelf, ldd and strip.
# SPDX-License-Identifier: GPL-3.0-or-later
import base64
import csv
import hashlib
import io
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Libraries of the machine, as in the policies of auditwheel. All others go into the wheel.
OF_MACHINE = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|util|nsl|resolv|gcc_s|stdc\+\+|z))\.so(\..*)?|linux-vdso.*")
# pybind11 before 2.12 reads arrays as numpy 1 lays them out.
NUMPY = "numpy>=1.20,<2"
PAGE = """# Footfall

The exact walkable area of 3D environments: game levels, buildings, city blocks.

    import footfall
    area = footfall.run(footfall.load("level.glb"), footfall.Agent(slope=30, height=1.8, radius=0.3))
    area.save("walkable.obj")

`help(footfall)` is the reference.
"""


def fail(message):
    sys.exit("make_wheel.py: " + message)


def output_of(*command):
    try:
        return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout
    except FileNotFoundError:
        fail(f"{command[0]} is missing; run installer/install_dependencies.sh --wheel first")
    except subprocess.CalledProcessError as error:
        fail(f"'{' '.join(map(str, command))}' failed: {error.stderr.strip()}")


def version():
    header = (ROOT / "core/include/footfall/version.hpp").read_text()
    return re.search(r'#define FOOTFALL_VERSION "(.*)"', header).group(1)


def libraries_of(file):
    """{name: path} of the libraries that a file needs, those of the machine left out."""
    found = {}
    for line in output_of("ldd", file).splitlines():
        name, _, path = line.strip().partition(" => ")
        if OF_MACHINE.fullmatch(pathlib.Path(name.split()[0]).name):
            continue
        path = path.split(" (")[0]
        if not os.path.isfile(path):
            fail(f"{file.name} needs {name}, which is not there; install it")
        found[name] = pathlib.Path(path)
    return found


def needed_by(file):
    return output_of("patchelf", "--print-needed", file).split()


def bundle(package, libraries, licences):
    """Copy what the package needs into `libraries`, by names that no other package has, and point everything there."""
    programs = [next(package.glob("_core.*.so")), package / "footfall-import"]
    paths = {}
    for program in programs:
        paths.update(libraries_of(program))
    names = {}
    libraries.mkdir()
    for name, path in sorted(paths.items()):
        digest = hashlib.sha256(path.read_bytes()).hexdigest()[:8]
        stem, _, ending = name.partition(".so")
        names[name] = f"{stem}-{digest}.so{ending}"
        shutil.copyfile(path, libraries / names[name])
        (libraries / names[name]).chmod(0o755)
        copy_licence(path, licences)
    for file in programs + sorted(libraries.iterdir()):
        for name in needed_by(file):
            if name in names:
                output_of("patchelf", "--replace-needed", name, names[name], file)
        if file.parent == libraries:
            output_of("patchelf", "--set-soname", file.name, file)
        output_of("patchelf", "--force-rpath", "--set-rpath",
                  "$ORIGIN" if file.parent == libraries else "$ORIGIN/../" + libraries.name, file)


def copy_licence(library, licences):
    """The notice of a library, as Debian ships it."""
    for path in (library, library.resolve(), pathlib.Path("/usr") / library.relative_to("/")):
        found = subprocess.run(["dpkg-query", "-S", str(path)], capture_output=True, text=True)
        if found.returncode == 0:
            owner = found.stdout.split(":")[0]
            notice = pathlib.Path("/usr/share/doc", owner, "copyright")
            if notice.is_file():
                shutil.copyfile(notice, licences / (owner + ".txt"))
            return


def python_tag(package):
    """cp311 for a module of CPython 3.11."""
    module = next(package.glob("_core.*.so"), None)
    found = module and re.match(r"_core\.cpython-(\d+)-", module.name)
    if not found:
        fail(f"{package} holds no module of CPython; build the target footfall_python first")
    return "cp" + found.group(1)


def platform_tag():
    library, number = platform.libc_ver()
    if library != "glibc":
        fail("wheels are made on systems with glibc")
    return f"manylinux_{number.replace('.', '_')}_{platform.machine()}"


def metadata(python):
    minor = python[len("cp3"):]
    return (f"Metadata-Version: 2.1\nName: footfall\nVersion: {version()}\n"
            "Summary: Exact walkable areas of 3D environments\nLicense: GPL-3.0-or-later\n"
            "Classifier: Operating System :: POSIX :: Linux\nClassifier: Programming Language :: C++\n"
            f"Requires-Python: ==3.{minor}.*\nRequires-Dist: {NUMPY}\n"
            f"Description-Content-Type: text/markdown\n\n{PAGE}")


def write_wheel(staging, wheel, record):
    """A zip with the same bytes for the same files, and the list of its files in `record`."""
    rows = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        def add(name, content, mode):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)

        for file in sorted(path for path in staging.rglob("*") if path.is_file()):
            content = file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            name = file.relative_to(staging).as_posix()
            rows.append((name, "sha256=" + digest, len(content)))
            add(name, content, 0o755 if os.access(file, os.X_OK) else 0o644)
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows(rows + [(record, "", "")])
        add(record, text.getvalue(), 0o644)


def main():
    if len(sys.argv) != 3:
        fail("usage: make_wheel.py BUILD_FOLDER OUTPUT_FOLDER")
    build, output = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    source, reader = build / "python/footfall", build / "footfall-import"
    if not reader.is_file():
        fail(f"{build} holds no footfall-import; build the target footfall_python first")
    python = python_tag(source)
    tag = f"{python}-{python}-{platform_tag()}"
    with tempfile.TemporaryDirectory() as folder:
        staging = pathlib.Path(folder)
        package, information = staging / "footfall", staging / f"footfall-{version()}.dist-info"
        licences = information / "licenses"
        licences.mkdir(parents=True)
        shutil.copytree(source, package, ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copy(reader, package)
        for file in (next(package.glob("_core.*.so")), package / "footfall-import"):
            output_of("strip", "--strip-unneeded", file)
        bundle(package, staging / "footfall.libs", licences)
        shutil.copy(ROOT / "LICENSE", licences)
        (information / "METADATA").write_text(metadata(python))
        (information / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: footfall\nRoot-Is-Purelib: false\nTag: {tag}\n")
        output.mkdir(parents=True, exist_ok=True)
        wheel = output / f"footfall-{version()}-{tag}.whl"
        write_wheel(staging, wheel, information.name + "/RECORD")
    print(wheel)


if __name__ == "__main__":
    main()
