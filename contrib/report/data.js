// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page: numbers in base64, compressed blocks, snapshots.
"use strict";

const SEPARATOR = 0xffffffff, STEPS = 65535;

function bytesOf(base64)
{
  const text = atob(base64.trim()), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflated(id)
{
  const stream = new Blob([bytesOf(document.getElementById(id).textContent)]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

function floats(base64)
{
  return new Float32Array(bytesOf(base64).buffer);
}

function wholeNumbers(base64)
{
  return new Uint32Array(bytesOf(base64).buffer);
}

// An array of n parts one behind the other, cut into them.
function parts(array, n)
{
  const length = array.length / n;
  return [...Array(n).keys()].map(p => array.subarray(p * length, (p + 1) * length));
}

// Takes arrays from a block one behind the other.
class BlockReader
{
  constructor(buffer)
  {
    this.buffer = buffer;
    this.place = 0;
  }

  take(Type, n)
  {
    const array = new Type(this.buffer, this.place, n);
    this.place += 4 * Math.ceil(array.byteLength / 4);
    return array;
  }
}

// The surface of the fluid or of the solids in a snapshot: coordinates, corners of triangles, outline, fields.
function readSurface(reader, head, flow, fields)
{
  const dimension = flow.lower.length, surface = {n: head.points, m: head.triangles, x: [], fields: {}};
  const rounded = reader.take(Uint16Array, dimension * head.points);
  for (let d = 0; d < dimension; ++d) {
    const x = new Float32Array(head.points);
    for (let i = 0; i < head.points; ++i)
      x[i] = flow.lower[d] + flow.size[d] / STEPS * rounded[d * head.points + i];
    surface.x.push(x);
  }
  surface.corners = parts(reader.take(Uint32Array, 3 * head.triangles), 3);
  if (head.outline !== undefined)
    surface.outline = reader.take(Uint32Array, head.outline);
  for (const name of Object.keys(fields)) {
    if (name === "yielded") {
      surface.fields[name] = reader.take(Uint8Array, head.triangles);
      continue;
    }
    const [lower, upper] = fields[name].values, values = reader.take(Uint16Array, head.points);
    surface.fields[name] = Float32Array.from(values, v => lower + (upper - lower) / STEPS * v);
  }
  return surface;
}

// The snapshot number k of a run, read once. Walls are coordinates of their points; those that stand are the run's.
async function readSnapshot(run, k, fields)
{
  const head = run.flow.snapshots[k];
  if (!head.content)
    head.content = inflated(head.id).then(buffer => {
      const reader = new BlockReader(buffer), dimension = run.flow.lower.length;
      const fluid = head.fluid && readSurface(reader, head.fluid, run.flow, fields);
      const solid = head.solid && readSurface(reader, head.solid, run.flow, {});
      const walls = head.walls ? reader.take(Float32Array, dimension * head.walls) : floats(run.walls.points);
      return {time: head.time, fluid, solid, walls: parts(walls, dimension)};
    });
  return head.content;
}

// An outline as coordinates of lines for plotly: null parts them.
function outlineOf(surface)
{
  const x = [], y = [];
  if (surface)
    for (const i of surface.outline) {
      x.push(i === SEPARATOR ? null : surface.x[0][i]);
      y.push(i === SEPARATOR ? null : surface.x[1][i]);
    }
  return {x, y};
}

// Calls changed(width) when the width of an element that holds a plot has changed; not within the browser's layout.
function whenResized(div, changed)
{
  let width = div.clientWidth;
  new ResizeObserver(() => setTimeout(() => {
    const now = div.clientWidth;
    if (now < 50 || Math.abs(now - width) < 2)
      return;
    width = now;
    changed(width);
  }, 0)).observe(div.parentElement);
}

function nearest(times, time)
{
  let best = 0;
  for (let k = 1; k < times.length; ++k)
    if (Math.abs(times[k] - time) < Math.abs(times[best] - time))
      best = k;
  return best;
}

function numberText(value, digits = 4)
{
  if (value === null || !isFinite(value))
    return "–";
  if (value === 0)
    return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    const raised = String(Number(exponent)).replace(/./g, c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
    return Number(mantissa) + "·10" + raised;
  }
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}
