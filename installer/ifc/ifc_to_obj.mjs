// ifc_to_obj.mjs FILE.ifc [OUT.obj] [--doors]: turns a building of IFC 2x3 or 4 into an OBJ with Z up, in metres, with
// openings cut. Each element is a part: its mesh is "STOREY: NAME (ID)", its material its class ("IfcWall"). Doors are left
// out, so that they are open, unless --doors is given; spaces, annotations, grids and openings are no bodies and always are.
// Coordinates are rounded to a micrometre, finer than the 24 bits that web-ifc gives them, so that what meets in the
// file meets in the OBJ. Without OUT.obj it writes to standard output. Exit codes: 0 done, 1 not a building or not written,
// 2 usage.
// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync, writeFileSync } from 'node:fs';
import * as webIfc from 'web-ifc';

const leftOut = new Set(['IfcSpace', 'IfcAnnotation', 'IfcGrid', 'IfcOpeningElement', 'IfcOpeningStandardCase',
                         'IfcVirtualElement', 'IfcSpatialZone', 'IfcSite']);
const doors = new Set(['IfcDoor', 'IfcDoorStandardCase']);

function fail(code, message) {
  process.stderr.write(`ifc_to_obj: ${message}\n`);
  process.exit(code);
}

/// Text for one line of OBJ, where # begins a comment and a backslash goes on with the next line.
function nameOf(line, fallback) {
  const name = line?.Name?.value ?? line?.LongName?.value ?? '';
  return String(name).replace(/[\s\u0000-\u001f#\\]+/g, ' ').trim() || fallback;
}

/// For each element the name of what it is contained in, through whatever it is a part of.
function findStoreys(api, model) {
  const parents = new Map();
  const collect = (type, parent, children) => {
    const ids = api.GetLineIDsWithType(model, type);
    for (let i = 0; i < ids.size(); ++i) {
      const line = api.GetLine(model, ids.get(i));
      for (const child of [line[children]].flat())
        if (child?.value !== undefined) parents.set(child.value, line[parent].value);
    }
  };
  collect(webIfc.IFCRELAGGREGATES, 'RelatingObject', 'RelatedObjects');
  collect(webIfc.IFCRELCONTAINEDINSPATIALSTRUCTURE, 'RelatingStructure', 'RelatedElements');
  const isStorey = new Map();
  return (id) => {
    let at = id;
    for (let steps = 0; parents.has(at) && steps < 100; ++steps) {
      at = parents.get(at);
      if (!isStorey.has(at)) isStorey.set(at, api.GetLineType(model, at) === webIfc.IFCBUILDINGSTOREY);
      if (isStorey.get(at)) return nameOf(api.GetLine(model, at), `storey ${at}`);
    }
    return 'no storey';
  };
}

/// Shortest decimals of a coordinate to a micrometre; never "-0".
const coordinate = (x) => String(Math.round(x * 1e6) / 1e6 + 0);

function convert(api, model, withDoors) {
  const storeyOf = findStoreys(api, model);
  const text = ['# Z up, metres\n'];
  let first = 1;
  let triangles = 0;
  api.StreamAllMeshes(model, (mesh) => {
    const type = api.GetNameFromTypeCode(api.GetLineType(model, mesh.expressID));
    if (leftOut.has(type) || (doors.has(type) && !withDoors)) return;
    const name = nameOf(api.GetLine(model, mesh.expressID), type);
    text.push(`o ${storeyOf(mesh.expressID)}: ${name} (${mesh.expressID})\nusemtl ${type}\n`);
    for (let i = 0; i < mesh.geometries.size(); ++i) {
      const placed = mesh.geometries.get(i);
      const geometry = api.GetGeometry(model, placed.geometryExpressID);
      const vertices = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
      const indices = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
      const m = placed.flatTransformation;
      for (let k = 0; k < vertices.length; k += 6) {  // each with its normal
        const p = [0, 1, 2].map((row) => m[row] * vertices[k] + m[4 + row] * vertices[k + 1] +
                                         m[8 + row] * vertices[k + 2] + m[12 + row]);
        text.push(`v ${coordinate(p[0])} ${coordinate(-p[2])} ${coordinate(p[1])}\n`);  // web-ifc has Y up
      }
      for (let k = 0; k + 2 < indices.length; k += 3)
        text.push(`f ${first + indices[k]} ${first + indices[k + 1]} ${first + indices[k + 2]}\n`);
      first += vertices.length / 6;
      triangles += indices.length / 3;
      geometry.delete();
    }
  });
  return { text: text.join(''), triangles };
}

const paths = process.argv.slice(2).filter((word) => !word.startsWith('--'));
const flags = process.argv.slice(2).filter((word) => word.startsWith('--'));
if (paths.length < 1 || paths.length > 2 || flags.some((flag) => flag !== '--doors'))
  fail(2, 'usage: ifc_to_obj.mjs FILE.ifc [OUT.obj] [--doors]');

let bytes;
try {
  bytes = readFileSync(paths[0]);
} catch (error) {
  fail(1, `${paths[0]}: cannot be read: ${error.code}`);
}
if (!bytes.subarray(0, 4096).toString('latin1').includes('ISO-10303-21'))
  fail(1, `${paths[0]}: not an IFC file in the form of ISO 10303-21`);
// What the library prints is no part of the OBJ.
console.log = console.warn = console.info = console.debug = () => {};
const api = new webIfc.IfcAPI();
await api.Init();
api.SetLogLevel(webIfc.LogLevel.LOG_LEVEL_OFF);
let result;
try {
  const model = api.OpenModel(bytes, { COORDINATE_TO_ORIGIN: false });
  if (model < 0) throw new Error('its schema is not known');
  result = convert(api, model, flags.includes('--doors'));
} catch (error) {
  fail(1, `${paths[0]}: cannot be read as a building: ${error.message}`);
}
if (result.triangles === 0) fail(1, `${paths[0]}: no bodies in it`);
try {
  writeFileSync(paths[1] ?? 1, result.text);
} catch (error) {
  fail(1, `${paths[1] ?? 'standard output'}: cannot be written: ${error.code}`);
}
process.exit(0);
