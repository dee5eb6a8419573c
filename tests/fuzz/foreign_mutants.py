#!/usr/bin/env python3
"""foreign_mutants.py FOOTFALL [--mutants N] [--seed S] [--keep FOLDER] [FILE...]: gives `footfall info` damaged files of
other formats: deep ones, unbounded ones, and N mutants of the given files (tests/data by default). The program may
refuse a file with one line that names it, and may read it; it must not die or hang."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import base64
import json
import os
import random
import struct
import subprocess
import sys
import tempfile
import zipfile

LONGEST_S = 240


def gltf(nodes, extras=None):
    """A triangle under nodes."""
    numbers = struct.pack("<9f3H", 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 1, 2)
    file = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": 42, "uri": "data:application/octet-stream;base64," + base64.b64encode(numbers).decode()}],
    }
    text = json.dumps(file)
    return text[:-1] + ', "extras": ' + extras + "}" if extras else text


def dae(nodes, indices="0 1 2"):
    return f"""<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source="#a" count="3" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
</source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">
<input semantic="VERTEX" source="#v" offset="0"/><p>{indices}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


def write(path, content):
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    return path


def bomb(path, name, start, piece, pieces, end):
    """A file in an archive that is much larger than the archive."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        if path.endswith(".3mf"):
            archive.writestr("_rels/.rels", '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/'
                             'relationships"><Relationship Id="r" Target="/3D/3dmodel.model" Type='
                             '"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
        with archive.open(name, "w", force_zip64=True) as file:
            file.write(start.encode())
            for _ in range(pieces):
                file.write(piece)
            file.write(end.encode())
    return path


def extreme_files(folder, bomb_megabytes):
    def at(name):
        return os.path.join(folder, name)

    chain = [{"children": [i + 1]} for i in range(20000)] + [{"mesh": 0}]
    yield write(at("chain.gltf"), gltf(chain)), True
    twice = [{"children": [i + 1, i + 1]} for i in range(20)] + [{"mesh": 0}]
    yield write(at("twice.gltf"), gltf(twice)), False
    yield write(at("brackets.gltf"), gltf([{"mesh": 0}], "[" * 200000 + "]" * 200000)), True
    deep = '<node><instance_geometry url="#g"/>' * 10000 + "</node>" * 10000
    yield write(at("deep.dae"), dae(deep)), None
    yield write(at("index.dae"), dae('<node><instance_geometry url="#g"/></node>', "0 1 10000000000000000")), None
    yield write(at("blanks.dae"), dae('<node><matrix>  1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>'
                                      '<instance_geometry url="#g"/></node>', "\n  0 1 2 ").replace(
                                          'count="9">', 'count="9">\n\t ')), True
    blank = b" " * (1 << 20)
    yield bomb(at("bomb.zae"), "a.dae", dae("")[:60] + "<!--", blank, bomb_megabytes, "--></COLLADA>"), None
    vertex = b'<vertex x="0" y="0" z="0"/>' * 38836
    yield bomb(at("bomb.3mf"), "3D/3dmodel.model", '<model unit="millimeter"><resources><object id="1"><mesh><vertices>',
               vertex, bomb_megabytes, "</vertices></mesh></object></resources></model>"), None
    os.mkfifo(at("fifo.bin"))
    text = json.loads(gltf([{"mesh": 0}]))
    text["buffers"][0]["uri"] = "fifo.bin"
    yield write(at("fifo.gltf"), json.dumps(text)), False


def mutant(content, other, random_):
    """One to four changes."""
    data = bytearray(content)
    for _ in range(random_.randint(1, 4)):
        if not data:
            break
        kind = random_.randrange(9)
        at = random_.randrange(len(data))
        if kind == 0:  # a line less
            lines = data.split(b"\n")
            del lines[random_.randrange(len(lines))]
            data = bytearray(b"\n".join(lines))
        elif kind == 1:  # a line twice
            lines = data.split(b"\n")
            line = random_.randrange(len(lines))
            lines.insert(random_.randrange(len(lines)), lines[line])
            data = bytearray(b"\n".join(lines))
        elif kind == 2:
            data[at] = random_.randrange(256)
        elif kind == 3:
            data[at] ^= 1 << random_.randrange(8)
        elif kind == 4:
            del data[at:]
        elif kind == 5:
            del data[at:at + random_.randint(1, 40)]
        elif kind == 6:  # a number that is another
            numbers = [i for i, c in enumerate(data) if 48 <= c <= 57]
            if numbers:
                value = random_.choice([b"-1", b"1e16", b"4294967295", b"0", b"99999999999999999999", b"nan", b"#1"])
                first = random_.choice(numbers)
                data[first:first + 1] = value
        elif kind == 7:
            start = random_.randrange(len(other))
            data[at:at] = other[start:start + random_.randint(1, 200)]
        else:
            first = random_.randrange(len(data))
            data[at:at] = data[first:first + random_.randint(1, 400)]
    return bytes(data)


def check(program, path, must_read, environment):
    """What is wrong with how the program took the file; empty when nothing is."""
    try:
        done = subprocess.run([program, "info", path], env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=LONGEST_S, check=False)
    except subprocess.TimeoutExpired:
        return "it hangs"
    errors = done.stderr.decode(errors="replace")
    if done.returncode not in (0, 1, 2):
        return f"it ended with {done.returncode}: {errors[-300:]}"
    if done.returncode != 0 and must_read:
        return f"a file in order is refused: {errors[-300:]}"
    if done.returncode == 0 and must_read is False:
        return "it is read"
    if done.returncode != 0:
        lines = [line for line in errors.splitlines() if not line.startswith("footfall: note:")]
        if len(lines) != 1 or path not in lines[0] or "; " not in lines[0]:
            return f"its message is none: {errors[-300:]}"
        if "internal error" in lines[0]:
            return lines[0]
        for word in ("ended by signal", "more than"):
            if word in lines[0]:
                counts[word] = counts.get(word, 0) + 1
    counts[done.returncode] = counts.get(done.returncode, 0) + 1
    return ""


counts = {}


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("footfall")
    parser.add_argument("files", nargs="*")
    parser.add_argument("--mutants", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--bomb-megabytes", type=int, default=1500)
    parser.add_argument("--keep", help="the folder for files that something is wrong with")
    arguments = parser.parse_args()
    data = os.path.join(here, "..", "data")
    files = arguments.files or [os.path.join(data, name) for name in sorted(os.listdir(data))
                                if not name.endswith((".obj", ".md"))]
    environment = dict(os.environ, FOOTFALL_IFC="/nowhere")  # Assimp is to read IFC
    random_ = random.Random(arguments.seed)
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        def report(path, problem):
            nonlocal wrong
            if not problem:
                return
            wrong += 1
            print(f"{os.path.basename(path)}: {problem}")
            if arguments.keep:
                os.makedirs(arguments.keep, exist_ok=True)
                os.replace(path, os.path.join(arguments.keep, os.path.basename(path)))

        for path, must_read in extreme_files(folder, arguments.bomb_megabytes):
            report(path, check(arguments.footfall, path, must_read, environment))
        contents = []
        for file in files:
            with open(file, "rb") as opened:
                contents.append((os.path.splitext(file)[1], opened.read()))
        for i in range(arguments.mutants):
            ending, content = contents[i % len(contents)]
            path = write(os.path.join(folder, f"mutant-{arguments.seed}-{i}{ending}"),
                         mutant(content, random_.choice(contents)[1], random_))
            report(path, check(arguments.footfall, path, None, environment))
            if os.path.exists(path):
                os.remove(path)
    print(f"{arguments.mutants} mutants of {len(files)} files: {counts.get(0, 0)} were read, "
          f"{counts.get(1, 0) + counts.get(2, 0)} refused, {counts.get('ended by signal', 0)} of them because a reader "
          f"died, {counts.get('more than', 0)} by a limit; {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
