// footfall-ifc.mjs FILE.ifc: writes the building to standard output as an OBJ that core/io/ifc_reader.cpp reads.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Openings are cut by web-ifc. Coordinates are the file's: its unit, Z up, not moved to the origin. They are rounded to
// a power of two near a micrometre, far below what a building is drawn to: web-ifc computes shapes in floats, and what
// was level or in one plane in the file is so again. An element is an object `o CLASS` with the material
// `usemtl STOREY: NAME`. Comments before the first vertex say what OBJ cannot:
//   # footfall-ifc 1
//   # metres per unit: 0.001
//   # storey: 4000 Level 2          (height of its floor in file units, name; ascending)
// Exit status 1 with one line on standard error: the file is no IFC file or cannot be read.
import { readFileSync, writeSync } from 'node:fs';
import * as WebIfc from 'web-ifc';

class Output {
  #lines = [];
  #size = 0;

  line(text) {
    this.#lines.push(text, '\n');
    this.#size += text.length;
    if (this.#size > 1 << 20) this.flush();
  }

  flush() {
    let rest = Buffer.from(this.#lines.join(''));
    while (rest.length > 0) {
      try {
        rest = rest.subarray(writeSync(1, rest));
      } catch (error) {
        if (error.code !== 'EAGAIN') throw error;
      }
    }
    this.#lines = [];
    this.#size = 0;
  }
}

function fail(text) {
  writeSync(2, `${text}\n`);
  process.exit(1);
}

/** All lines of a type and of those that inherit from it. */
function* linesOfType(api, model, type) {
  const ids = api.GetLineIDsWithType(model, type, true);
  for (let i = 0; i < ids.size(); ++i) {
    let line;
    try {
      line = api.GetLine(model, ids.get(i));
    } catch {
      continue;  // damaged: what it says is not needed for the shapes
    }
    if (line) yield line;
  }
}

/** Of a line; in OBJ a # begins a comment, and a backslash at the end takes in the next line. */
const nameOf = (line) => String(line?.Name?.value ?? '').replace(/[\x00-\x1f\x7f]+/g, ' ').replace(/#\s*/g, 'No. ')
  .replaceAll('\\', '/').trim();

const kPrefixes = { EXA: 1e18, PETA: 1e15, TERA: 1e12, GIGA: 1e9, MEGA: 1e6, KILO: 1e3, HECTO: 1e2, DECA: 10,
  DECI: 0.1, CENTI: 0.01, MILLI: 0.001, MICRO: 1e-6, NANO: 1e-9, PICO: 1e-12, FEMTO: 1e-15, ATTO: 1e-18 };

/** Metres in the file's unit of length; an SI unit, or one that is converted to it (foot, inch). */
function metresPerUnit(api, model) {
  const ofSi = (unit) => (unit?.Name?.value === 'METRE' ? (kPrefixes[unit.Prefix?.value] ?? 1) : undefined);
  for (const assignment of linesOfType(api, model, WebIfc.IFCUNITASSIGNMENT)) {
    for (const handle of assignment.Units ?? []) {
      const unit = api.GetLine(model, handle.value);
      if (unit?.UnitType?.value !== 'LENGTHUNIT') continue;
      if (unit.type === WebIfc.IFCSIUNIT) return ofSi(unit) ?? 1;
      const factor = unit.ConversionFactor && api.GetLine(model, unit.ConversionFactor.value);
      const value = factor?.ValueComponent?.value;
      const base = factor?.UnitComponent && ofSi(api.GetLine(model, factor.UnitComponent.value));
      if (Number.isFinite(value) && base) return value * base;
    }
  }
  return 1;
}

/** Which storey an element belongs to: what contains it, or what it is a part of. */
class Storeys {
  #parent = new Map();
  #names = new Map();
  list = [];

  constructor(api, model) {
    for (const relation of linesOfType(api, model, WebIfc.IFCRELCONTAINEDINSPATIALSTRUCTURE)) {
      for (const element of relation.RelatedElements ?? [])
        this.#parent.set(element.value, relation.RelatingStructure?.value);
    }
    for (const relation of linesOfType(api, model, WebIfc.IFCRELAGGREGATES)) {
      for (const part of relation.RelatedObjects ?? [])
        if (!this.#parent.has(part.value)) this.#parent.set(part.value, relation.RelatingObject?.value);
    }
    for (const storey of linesOfType(api, model, WebIfc.IFCBUILDINGSTOREY)) {
      const name = nameOf(storey) || `No. ${storey.expressID}`;
      this.#names.set(storey.expressID, name);
      this.list.push({ name, height: this.#heightOf(api, model, storey) });
    }
    this.list.sort((a, b) => a.height - b.height);
  }

  /** Where its placement puts it; what the storey says of itself is often 0, or relative to the sea. */
  #heightOf(api, model, storey) {
    try {
      const z = api.GetWorldTransformMatrix(model, storey.ObjectPlacement.value)[14];
      if (Number.isFinite(z)) return z;
    } catch {
      // without a placement
    }
    return Number.isFinite(storey.Elevation?.value) ? storey.Elevation.value : 0;
  }

  of(element) {
    for (let id = element, steps = 0; id !== undefined && steps < 64; id = this.#parent.get(id), ++steps)
      if (this.#names.has(id)) return this.#names.get(id);
    return '';
  }
}

async function main() {
  const [path] = process.argv.slice(2);
  if (path === undefined) fail('usage: footfall-ifc.mjs FILE.ifc');
  const api = new WebIfc.IfcAPI();
  // what it prints belongs neither into the OBJ nor into a message
  for (const method of ['log', 'info', 'warn', 'error', 'debug']) console[method] = () => {};
  await api.Init();
  api.SetLogLevel(WebIfc.LogLevel.LOG_LEVEL_OFF);
  let data;
  try {
    data = readFileSync(path);
  } catch (error) {
    fail(`cannot be read (${error.code})`);
  }
  if (!data.subarray(0, 4096).includes('ISO-10303-21')) fail('is no IFC file: it does not begin with ISO-10303-21');
  if (!data.subarray(-4096).includes('END-ISO-10303-21')) fail('is cut off: it does not end with END-ISO-10303-21');
  const model = api.OpenModel(new Uint8Array(data), { COORDINATE_TO_ORIGIN: false });
  if (model < 0) fail('cannot be read: unknown IFC version, or damaged');

  const unit = metresPerUnit(api, model);
  const storeys = new Storeys(api, model);
  const grid = 2 ** Math.round(Math.log2(1e-6 / unit));
  const out = new Output();
  out.line('# footfall-ifc 1');
  out.line(`# metres per unit: ${unit}`);
  for (const { name, height } of storeys.list) out.line(`# storey: ${height} ${name}`);

  let vertexCount = 0, problem;
  const write = (mesh) => {
    const element = api.GetLine(model, mesh.expressID);
    const storey = storeys.of(mesh.expressID);
    const name = nameOf(element) || `No. ${mesh.expressID}`;
    out.line(`o ${api.GetNameFromTypeCode(element.type)}`);
    out.line(`usemtl ${storey ? `${storey}: ` : ''}${name}`);
    for (let i = 0; i < mesh.geometries.size(); ++i) {
      const placed = mesh.geometries.get(i);
      const shape = api.GetGeometry(model, placed.geometryExpressID);
      const m = placed.flatTransformation;
      const vertices = api.GetVertexArray(shape.GetVertexData(), shape.GetVertexDataSize());
      const indices = api.GetIndexArray(shape.GetIndexData(), shape.GetIndexDataSize());
      const round = (value) => Math.round(value / grid) * grid + 0;
      for (let v = 0; v + 5 < vertices.length; v += 6) {  // a position and a normal each
        const [x, y, z] = vertices.subarray(v, v + 3);
        const at = (row) => round((m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]) / unit);
        out.line(`v ${at(0)} ${-at(2) + 0} ${at(1)}`);  // web-ifc gives Y up, in metres
      }
      for (let t = 0; t + 2 < indices.length; t += 3) {
        const [a, b, c] = indices.subarray(t, t + 3);
        out.line(`f ${vertexCount + a + 1} ${vertexCount + b + 1} ${vertexCount + c + 1}`);
      }
      vertexCount += Math.floor(vertices.length / 6);
      shape.delete();
    }
  };
  api.StreamAllMeshes(model, (mesh) => {
    if (problem) return;
    try {
      write(mesh);
    } catch (error) {
      problem = error;  // must not pass through WebAssembly
    }
  });
  if (problem) throw problem;
  out.flush();
}

main().catch((error) => fail(`cannot be converted (${String(error?.message ?? error).split('\n')[0]})`));
