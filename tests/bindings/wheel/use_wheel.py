# SPDX-License-Identifier: GPL-3.0-or-later
# use_wheel.py FOOTFALL LEVEL.obj: uses the package of a wheel that is installed; the program FOOTFALL says what is right.
import importlib.metadata
import pathlib
import re
import subprocess
import sys

import footfall
import numpy as np

program, level = sys.argv[1:]
package = pathlib.Path(footfall.__file__).parent
assert package.is_relative_to(sys.prefix), package
assert importlib.metadata.version("footfall") == footfall.__version__
assert any(name.startswith("numpy") for name in importlib.metadata.requires("footfall"))

def bytes_match(level, **options):
    """The area of a level has the bytes that the program writes; returns it."""
    area = footfall.run(footfall.load(level, **options))
    area.save("wheel.obj")
    given = [f"--{name}={value}" for name, value in {"up": options.get("up"), "scale": options.get("metres_per_unit")}.items()
             if value is not None]
    subprocess.run([program, "run", level, "-o", "program.obj", "--quiet", *given], check=True)
    assert pathlib.Path("wheel.obj").read_bytes() == pathlib.Path("program.obj").read_bytes(), level
    return area


area = bytes_match(level)
assert area.area > 0

# Another format goes through footfall-import, which lies beside the library.
assert (package / "footfall-import").stat().st_mode & 0o111
vertices, triangles = area.environment.vertices, area.environment.triangles
with open("level.off", "w") as file:
    file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
    np.savetxt(file, vertices, "%.17g")
    np.savetxt(file, np.insert(triangles, 0, 3, axis=1), "%d")
assert abs(bytes_match("level.off", up="z", metres_per_unit=1).area - area.area) < 0.05 * area.area

# The libraries are those of the wheel, or of those that every system has.
of_machine = re.compile(r"/(ld-linux[^/]*|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|z))\.so(\.[^/]*)?$")
for file in [next(package.glob("_core.*.so")), package / "footfall-import", *(package.parent / "footfall.libs").iterdir()]:
    for line in subprocess.run(["ldd", file], check=True, capture_output=True, text=True).stdout.splitlines():
        path = line.partition(" => ")[2].split(" (")[0]
        assert "not found" not in line, (file, line)
        assert not path or of_machine.search(path) or path.startswith(sys.prefix), (file, line)
with open("/proc/self/maps") as maps:
    loaded = [line.split()[-1] for line in maps if re.search(r"/lib(tbb|gmp|mpfr|Detour)", line)]
assert loaded and all(name.startswith(sys.prefix) for name in loaded), loaded
print(f"{len(area.triangles)} walkable triangles")
