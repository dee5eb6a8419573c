#!/usr/bin/env bash
# test_packages.sh: installs the Debian packages that package.sh made into a clean Debian 12 with nothing but a virtual
# display, runs the programs and the Python module as a user would, removes them and looks for what is left; runs the
# portable archive in the same clean root, before Qt comes into it. Needs root (or sudo) for the clean root and a Debian mirror, which is the
# machine's own. Where the machine allows no clean root, it says so and checks package and archive from the outside,
# in an empty environment. Ends with 1 at the first real failure. The root lies in a temporary folder and goes at the
# end; pictures stay in build/package-test.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
[ "$#" -eq 0 ] || fail "unknown arguments $*; usage: test_packages.sh"

shopt -s nullglob
debs=("${repository}"/build/footfall_*.deb)
python_debs=("${repository}"/build/python3-footfall_*.deb)
mpi_debs=("${repository}"/build/footfall-mpi_*.deb)
archives=("${repository}"/build/footfall-*.tar.gz)
[ "${#debs[@]}" -eq 1 ] || fail "build/ does not hold exactly one footfall_*.deb; run installer/package.sh first"
[ "${#python_debs[@]}" -eq 1 ] ||
  fail "build/ does not hold exactly one python3-footfall_*.deb; run installer/package.sh first"
[ "${#mpi_debs[@]}" -eq 1 ] || fail "build/ does not hold exactly one footfall-mpi_*.deb; run installer/package.sh first"
[ "${#archives[@]}" -eq 1 ] || fail "build/ does not hold exactly one footfall-*.tar.gz; run installer/package.sh first"
deb="${debs[0]}" python_deb="${python_debs[0]}" mpi_deb="${mpi_debs[0]}" archive="${archives[0]}"
portable="$(basename -- "${archive}" .tar.gz)"
pictures="${repository}/build/package-test"
rm -rf -- "${pictures}"
mkdir -p "${pictures}"
scratch="$(mktemp -d)"
chmod 755 "${scratch}"
root="${scratch}/root"
as_root=()
if [ "$(id -u)" -ne 0 ] && command -v sudo >/dev/null; then as_root=(sudo -n); fi
# A background service must not keep the folder busy, and nothing of the machine is mounted into the root.
trap '"${as_root[@]}" rm -rf --one-file-system -- "${scratch}"' EXIT
not_done=()

# --- From the outside: what the package holds ---------------------------------------------------------------------------
say "contents of $(basename -- "${deb}")"
dpkg-deb --info "${deb}" | sed -n '/^ Package:/,$p'
contents="$(dpkg-deb --contents "${deb}" | awk '{ print $6 }')"
for wanted in usr/bin/footfall usr/bin/footfall-editor usr/share/applications/org.footfall.Editor.desktop \
  usr/share/mime/packages/org.footfall.Editor.xml usr/share/metainfo/org.footfall.Editor.metainfo.xml \
  usr/share/icons/hicolor/16x16/apps/org.footfall.Editor.png usr/share/icons/hicolor/512x512/apps/org.footfall.Editor.png \
  usr/share/icons/hicolor/scalable/apps/org.footfall.Editor.svg usr/share/man/man1/footfall.1.gz \
  usr/share/man/man1/footfall-editor.1.gz usr/share/doc/footfall/copyright \
  usr/share/footfall/samples/villa/villa.obj usr/share/footfall/samples/villa/villa.pipeline; do
  grep -qxF "./${wanted}" <<<"${contents}" || fail "the package lacks ${wanted}"
done
if grep -E '\.(hpp|h|a|cmake)$|/include/|libfootfall' <<<"${contents}"; then fail "the package holds the developer's files above"; fi
if dpkg-deb --contents "${deb}" | grep -v ' root/root '; then fail "the files above do not belong to root"; fi

dpkg-deb --extract "${deb}" "${scratch}/extracted"
desktop-file-validate "${scratch}/extracted/usr/share/applications/org.footfall.Editor.desktop"
appstreamcli validate --no-net "${scratch}/extracted/usr/share/metainfo/org.footfall.Editor.metainfo.xml"
for page in "${scratch}"/extracted/usr/share/man/man1/*.gz; do
  warnings="$(man --warnings -l -Tutf8 "${page}" 2>&1 >/dev/null)"
  [ -z "${warnings}" ] || fail "$(basename -- "${page}"): ${warnings}"
done

say "contents of $(basename -- "${python_deb}")"
dpkg-deb --info "${python_deb}" | sed -n '/^ Package:/,$p'
contents="$(dpkg-deb --contents "${python_deb}" | awk '{ print $6 }')"
module=usr/lib/python3/dist-packages/footfall
for wanted in "${module}/__init__.py" "${module}/__init__.pyi" "${module}/py.typed" \
  usr/share/doc/python3-footfall/copyright usr/share/doc/python3-footfall/examples/plot_layers.py; do
  grep -qxF "./${wanted}" <<<"${contents}" || fail "the Python package lacks ${wanted}"
done
grep -qxE "\./${module}/_core\.cpython-[0-9]+-.*\.so" <<<"${contents}" || fail "the Python package lacks its module"
if grep -E '\.(hpp|a|cmake|pyc)$|/include/|/bin/' <<<"${contents}"; then fail "the Python package holds the files above"; fi
if dpkg-deb --contents "${python_deb}" | grep -v ' root/root '; then fail "the files above do not belong to root"; fi
dpkg-deb --extract "${python_deb}" "${scratch}/extracted-python"

say "contents of $(basename -- "${mpi_deb}")"
dpkg-deb --info "${mpi_deb}" | sed -n '/^ Package:/,$p'
contents="$(dpkg-deb --contents "${mpi_deb}" | awk '{ print $6 }')"
for wanted in usr/bin/footfall-mpi usr/share/man/man1/footfall-mpi.1.gz usr/share/doc/footfall-mpi/copyright \
  usr/share/footfall/footfall.slurm; do
  grep -qxF "./${wanted}" <<<"${contents}" || fail "the package of footfall-mpi lacks ${wanted}"
done
dpkg-deb --field "${mpi_deb}" Depends | grep -q openmpi || fail "the package of footfall-mpi does not ask for MPI"

# --- What a user does, in the root or out of it: NAME COMMAND... with the programs' folder in front of PATH -------------
# Runs the command line and the editor on a sample: PREFIX-COMMAND... is put before each. Leaves pictures.
use_programs() {
  local name="$1" programs="$2" samples="$3" output="$4"
  shift 4
  local version
  version="$("$@" "${programs}/footfall" --version)"
  [[ "${version}" =~ ^footfall\ [0-9]+\.[0-9]+\.[0-9]+$ ]] || fail "${name}: --version says ${version}"
  "$@" "${programs}/footfall" run "${samples}/house/house.obj" -p "${samples}/house/house.pipeline" --quiet \
    -o "${output}/house-${name}.obj" || fail "${name}: footfall cannot run the sample house"
  "$@" xvfb-run -a -s "-screen 0 1280x1024x24" "${programs}/footfall-editor" "${samples}/villa/villa.obj" \
    -p "${samples}/villa/villa.pipeline" --screenshot "${output}/villa-${name}.png" --size 1280x800 ||
    fail "${name}: footfall-editor cannot show the sample villa"
}

# Runs the Python module on a sample and on arrays: PREFIX-COMMAND... is put before the interpreter. Its export must be
# the program's.
use_python() {
  local name="$1" samples="$2" output="$3"
  shift 3
  "$@" /usr/bin/python3 -c '
import footfall, sys
samples, target = sys.argv[1:]
level = footfall.load(samples + "/house/house.obj")
footfall.run(level, footfall.read_pipeline(samples + "/house/house.pipeline")).save(target)
area = footfall.walkable_area([[0, 0, 0], [4, 0, 0], [4, 4, 0]], [[0, 1, 2]]).area
sys.exit(0 if area == 8 else "the area of a triangle of 8 is %r" % area)
' "${samples}" "${output}/house-${name}.obj" || fail "${name}: the Python module cannot run the sample house"
}

# The results must be there, and the picture no empty frame.
check_results() {
  local name="$1" folder="$2"
  grep -q '^f ' "${folder}/house-${name}.obj" || fail "${name}: the result of the house holds no face"
  [ "$(stat -c %s "${folder}/villa-${name}.png")" -gt 40000 ] || fail "${name}: the editor's picture is nearly empty"
  cp -- "${folder}/villa-${name}.png" "${pictures}/"
  say "${name}: the editor's picture is ${pictures}/villa-${name}.png"
}

# The graphics driver keeps no shaders on the disk: they would look like something that the package leaves.
clean_environment=(env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8 LIBGL_ALWAYS_SOFTWARE=1
  MESA_SHADER_CACHE_DISABLE=true DEBIAN_FRONTEND=noninteractive)

# The machine's own Debian sources, as mmdebstrap and apt in the root want them.
make_root() {
  local list_file="" list_parts="" file log="${pictures}/clean-root.log" sources="${scratch}/debian.sources"
  command -v mmdebstrap >/dev/null || { echo "mmdebstrap is missing"; return 1; }
  [ "$(id -u)" -eq 0 ] || sudo -n true 2>/dev/null || { echo "no root"; return 1; }
  eval "$(apt-config shell list_file Dir::Etc::sourcelist/f list_parts Dir::Etc::sourceparts/d)"
  for file in "${list_file}" "${list_parts%/}"/*.list "${list_parts%/}"/*.sources; do
    if [ -r "${file}" ] && grep -qw bookworm "${file}" && grep -qw main "${file}"; then cat -- "${file}" >"${sources}"; break; fi
  done
  [ -s "${sources}" ] || { echo "apt knows no sources of Debian 12 (bookworm)"; return 1; }
  # Man pages are left out of many small roots; here they are part of what is tested.
  if ! "${as_root[@]}" mmdebstrap --variant=minbase --skip=cleanup/apt/lists \
    --include=xvfb,xauth,libgl1,libegl1,libopengl0,libgl1-mesa-dri,libfontconfig1,fonts-dejavu-core,man-db,desktop-file-utils,shared-mime-info,hicolor-icon-theme \
    bookworm "${root}" - <"${sources}" >"${log}" 2>&1; then
    tail -n 5 "${log}"
    return 1
  fi
  "${as_root[@]}" cp -- /etc/resolv.conf "${root}/etc/resolv.conf"
  "${as_root[@]}" chroot "${root}" /bin/true
}

in_root() { "${as_root[@]}" chroot "${root}" "${clean_environment[@]}" "$@"; }

# All files but those that programs of the system make for themselves.
list_root() {
  "${as_root[@]}" find "${root}" -xdev \( -path "${root}/proc" -o -path "${root}/sys" -o -path "${root}/dev" \
    -o -path "${root}/tmp" -o -path "${root}/run" -o -path "${root}/var/lib/dpkg" -o -path "${root}/var/lib/apt" \
    -o -path "${root}/var/cache" -o -path "${root}/var/log" \) -prune -o ! -type d -printf '%P\n' | sort
}

say "a clean Debian 12 in ${root}"
if problem="$(make_root)"; then
  say "the portable archive in the clean root, which has no Qt"
  if in_root sh -c 'ls /usr/lib/*/libQt6* 2>/dev/null'; then fail "the clean root has Qt already"; fi
  "${as_root[@]}" mkdir -p "${root}/tmp/results"
  "${as_root[@]}" tar -C "${root}/tmp" -xzf "${archive}"
  use_programs portable "/tmp/${portable}" "/tmp/${portable}/share/footfall/samples" /tmp/results in_root
  check_results portable "${root}/tmp/results"
  "${as_root[@]}" rm -rf -- "${root:?}/tmp/${portable}"

  say "installing the package with its dependencies"
  list_root >"${scratch}/before"
  "${as_root[@]}" cp -- "${deb}" "${root}/tmp/footfall.deb"
  quietly "${pictures}/install.log" in_root apt-get install -y --no-install-recommends /tmp/footfall.deb
  use_programs package /usr/bin /usr/share/footfall/samples /tmp/results in_root
  check_results package "${root}/tmp/results"
  say "the Python package with its dependencies"
  "${as_root[@]}" cp -- "${python_deb}" "${root}/tmp/python3-footfall.deb"
  quietly "${pictures}/install-python.log" in_root apt-get install -y --no-install-recommends /tmp/python3-footfall.deb
  use_python python /usr/share/footfall/samples /tmp/results in_root
  cmp "${root}/tmp/results/house-python.obj" "${root}/tmp/results/house-package.obj" ||
    fail "Python's export of the house is not the program's"
  # Without /proc and shared memory MPI cannot start there; that everything it links to is there is what can be said.
  say "the package of footfall-mpi with its dependencies"
  "${as_root[@]}" cp -- "${mpi_deb}" "${root}/tmp/footfall-mpi.deb"
  quietly "${pictures}/install-mpi.log" in_root apt-get install -y --no-install-recommends /tmp/footfall-mpi.deb
  in_root sh -c 'command -v mpirun' >/dev/null || fail "footfall-mpi is there and mpirun is not"
  if in_root ldd /usr/bin/footfall-mpi | grep "not found"; then fail "footfall-mpi lacks the libraries above"; fi
  in_root man -w footfall footfall-editor footfall-mpi >/dev/null || fail "the man pages are not found"
  [ "$(in_root man -P cat footfall 2>&1 | wc -l)" -gt 40 ] || fail "man footfall shows nearly nothing"
  in_root update-desktop-database
  in_root update-mime-database /usr/share/mime
  grep -q '^application/x-footfall-session=org.footfall.Editor.desktop' "${root}/usr/share/applications/mimeinfo.cache" ||
    fail "the desktop does not open sessions with the editor"
  grep -q ':application/x-footfall-session:\*\.footfall$' "${root}/usr/share/mime/globs2" ||
    fail "sessions have no MIME type"
  grep -q ':text/x-footfall-pipeline:\*\.pipeline$' "${root}/usr/share/mime/globs2" || fail "pipelines have no MIME type"

  # man keeps formatted pages for a while; they are not the package's.
  say "removing the packages"
  quietly "${pictures}/remove.log" in_root apt-get purge -y footfall python3-footfall footfall-mpi
  left="$("${as_root[@]}" find "${root}" -xdev -path "${root}/tmp" -prune -o -path "${root}/var/log" -prune -o -path "${root}/var/cache/man" -prune -o \
    -iname '*footfall*' -print)"
  [ -z "${left}" ] || fail "after the removal these are left: ${left}"
  quietly "${pictures}/autoremove.log" in_root apt-get autoremove --purge -y
  list_root >"${scratch}/after"
  # The databases of MIME types and desktop entries are the system's; the updates above wrote them. So are the copies
  # (passwd-, gshadow-, ...) that its tools keep when a package that Open MPI needs makes a group of its own.
  left="$(comm -13 "${scratch}/before" "${scratch}/after" | grep -Ev '^usr/share/(mime/|applications/mimeinfo.cache)|^etc/ld.so.cache|^etc/(passwd|group|shadow|gshadow)-$' || true)"
  [ -z "${left}" ] || fail "after the removal these are left: ${left}"
  grep -q footfall "${root}/usr/share/applications/mimeinfo.cache" "${root}/usr/share/mime/globs2" 2>/dev/null &&
    fail "the desktop still knows the types of the removed package"
  say "nothing is left"
else
  not_done+=("no clean root: ${problem}. Package and archive ran on this machine, in an empty environment, instead")
  mkdir -p "${scratch}/results"
  tar -C "${scratch}" -xzf "${archive}"
  use_programs portable "${scratch}/${portable}" "${scratch}/${portable}/share/footfall/samples" "${scratch}/results" \
    "${clean_environment[@]}"
  check_results portable "${scratch}/results"
  use_programs package "${scratch}/extracted/usr/bin" "${scratch}/extracted/usr/share/footfall/samples" \
    "${scratch}/results" "${clean_environment[@]}"
  check_results package "${scratch}/results"
  if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
    use_python python "${scratch}/extracted/usr/share/footfall/samples" "${scratch}/results" "${clean_environment[@]}" \
      "PYTHONPATH=${scratch}/extracted-python/usr/lib/python3/dist-packages"
    cmp "${scratch}/results/house-python.obj" "${scratch}/results/house-package.obj" ||
      fail "Python's export of the house is not the program's"
  else
    not_done+=("no numpy for /usr/bin/python3: the Python package was only unpacked")
  fi
  # dpkg's own record of what it would install, without its dependencies and without touching the system.
  mkdir -p "${scratch}/dpkg"/{info,updates,parts} "${scratch}/instroot"
  : >"${scratch}/dpkg/status"
  if [ "$(id -u)" -eq 0 ]; then
    options=(--admindir="${scratch}/dpkg" --instdir="${scratch}/instroot" --force-depends --no-triggers)
    quietly "${pictures}/install.log" dpkg "${options[@]}" --install "${deb}"
    [ -x "${scratch}/instroot/usr/bin/footfall-editor" ] || fail "dpkg installed no editor"
    quietly "${pictures}/remove.log" dpkg "${options[@]}" --purge footfall
    left="$(find "${scratch}/instroot" ! -type d)"
    [ -z "${left}" ] || fail "after the removal these are left: ${left}"
  else
    not_done+=("not root: the package was unpacked, not installed and removed")
  fi
fi

for line in "${not_done[@]}"; do say "NOT DONE: ${line}"; done
say "packages: passed"
