// SPDX-License-Identifier: GPL-3.0-or-later
// A sketch of the case: where fluids, boundaries and solids are at the start, with their names.
"use strict";

const LABEL_COLOURS = {fluid: "#1f4e79", boundary: "#333333", solid: "#7a3e12", point: "#8a1c5a"};

async function drawSketch(div, run, fields, hasMesh = false)
{
  const snapshot = await readSnapshot(run, 0, fields);
  const draw = run.flow.lower.length === 2 ? drawPlaneSketch : drawSpaceSketch;
  let busy = draw(div, run, snapshot, hasMesh);
  whenResized(div, () => busy = busy.then(() => draw(div, run, snapshot, hasMesh)));
  return busy;
}

// The edges of triangles as coordinates of lines for plotly.
function meshLines(surface, points)
{
  const [a, b, c] = surface.corners;
  return points.map(x => Array.from({length: surface.m}, (_, t) => [x[a[t]], x[b[t]], x[c[t]], x[a[t]], null]).flat());
}

function planeMeshTrace(surface)
{
  const [x, y] = meshLines(surface, surface.x);
  return {type: "scatter", mode: "lines", x, y, hoverinfo: "skip",
          line: {color: "rgba(40,60,80,0.45)", width: 0.6, simplify: false}};
}

// Unit normals at the points of a surface in space whose triangles are turned outwards, by component.
function outwardNormals(surface)
{
  const [x, y, z] = surface.x, [A, B, C] = surface.corners, normals = [0, 1, 2].map(() => new Float64Array(surface.n));
  for (let t = 0; t < surface.m; ++t) {
    const [a, b, c] = [A[t], B[t], C[t]];
    const u = [x[b] - x[a], y[b] - y[a], z[b] - z[a]], v = [x[c] - x[a], y[c] - y[a], z[c] - z[a]];
    for (const point of [a, b, c])
      for (let d = 0; d < 3; ++d)
        normals[d][point] += u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3];
  }
  for (let i = 0; i < surface.n; ++i) {
    const length = Math.hypot(normals[0][i], normals[1][i], normals[2][i]) || 1;
    normals.forEach(component => component[i] /= length);
  }
  return normals;
}

// The lines are a little outside, where the surface does not hide them.
function spaceMeshTrace(surface)
{
  const size = Math.max(...surface.x.map(x => x.reduce((m, v) => Math.max(m, v), -Infinity)
    - x.reduce((m, v) => Math.min(m, v), Infinity)));
  const normals = outwardNormals(surface);
  const points = surface.x.map((x, d) => x.map((value, i) => value + 8e-3 * size * normals[d][i]));
  const [x, y, z] = meshLines(surface, points);
  return {type: "scatter3d", mode: "lines", x, y, z, hoverinfo: "skip", line: {color: "#47698a", width: 2}};
}

async function drawPlaneSketch(div, run, snapshot, hasMesh)
{
  const layout = planeLayout(run.flow.box, div.clientWidth),
    points = run.labels.filter(label => label.kind === "point");
  const area = (surface, colour, line) => ({type: "scatter", mode: "lines", ...outlineOf(surface), fill: "toself",
                                            fillcolor: colour,
                                            line: {color: line, width: 1, simplify: false}, hoverinfo: "skip"});
  const meshes = hasMesh ? [snapshot.fluid, snapshot.solid].filter(Boolean) : [];
  const traces = [
    ...(snapshot.fluid ? [area(snapshot.fluid, FLUID, "#4d7fa6")] : []),
    ...(snapshot.solid ? [area(snapshot.solid, SOLID, "#5a2d0c")] : []),
    ...meshes.map(planeMeshTrace),
    ...wallTraces(run.walls, snapshot.walls),
    {type: "scatter", mode: "markers", x: points.map(p => p.at[0]), y: points.map(p => p.at[1]), hoverinfo: "skip",
     marker: {symbol: "x-thin", size: 9, line: {width: 2, color: LABEL_COLOURS.point}}},
  ];
  await Plotly.newPlot(div, traces, layout, {...PLANE_CONFIG, staticPlot: true});
  const {xaxis, yaxis} = div._fullLayout, labels = new LabelPlacer(xaxis._length, yaxis._length);
  const annotations = run.labels.map(label => {
    const pixel = [xaxis.d2p(label.at[0]), yaxis.d2p(label.at[1])], [ax, ay] = labels.place(pixel, label.text,
                                                                                            label.kind === "fluid");
    return {x: label.at[0], y: label.at[1], ax, ay, text: label.text.replace(/&/g, "&amp;").replace(/</g, "&lt;"),
            showarrow: ax !== 0 || ay !== 0, arrowhead: 0, arrowwidth: 1,
            arrowcolor: LABEL_COLOURS[label.kind], font: {size: 12, color: LABEL_COLOURS[label.kind]},
            bgcolor: "rgba(255,255,255,0.78)", borderpad: 1};
  });
  await Plotly.relayout(div, {annotations: [...annotations, ...gravityArrow(run.gravity, labels)]});
}

function gravityArrow(gravity, labels)
{
  const size = Math.hypot(...gravity), length = 34;
  if (size === 0)
    return [];
  const [gx, gy] = gravity.map(g => g / size * length), [px, py] = labels.freePlace(60, 70);
  return [{xref: "x domain", yref: "y domain", x: (px + gx / 2) / labels.width, y: 1 - (py - gy / 2) / labels.height,
           ax: -gx, ay: gy,
           text: "g", showarrow: true, arrowhead: 2, arrowwidth: 1.4, arrowcolor: "#555",
           font: {size: 12, color: "#555"}}];
}

// Finds a place near a point for each label where none stands yet.
class LabelPlacer
{
  constructor(width, height)
  {
    Object.assign(this, {width, height, taken: []});
  }

  isFree(box)
  {
    return box[0] >= 2 && box[1] >= 2 && box[2] <= this.width - 2 && box[3] <= this.height - 2 &&
           !this.taken.some(other => box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3]);
  }

  place([x, y], text, mayStayThere)
  {
    const w = 3.6 * text.length + 6, h = 11;
    const offsets = mayStayThere ? [[0, 0]] : [];
    for (const distance of [30, 48, 72, 100, 140])
      for (const angle of [60, 120, 90, 30, 150, 0, 180, -60, -120, -90])
        offsets.push([distance * Math.cos(angle * Math.PI / 180), -distance * Math.sin(angle * Math.PI / 180)]);
    for (const [ax, ay] of offsets) {
      // The line ends at the label's nearest side.
      const cx = x + ax, cy = y + ay, box = [cx - w, cy - h, cx + w, cy + h];
      if (this.isFree(box)) {
        this.taken.push(box);
        return [ax, ay];
      }
    }
    return [0, mayStayThere ? 0 : -30];
  }

  freePlace(w, h)
  {
    for (const [x, y] of [[0.92, 0.18], [0.5, 0.18], [0.92, 0.5], [0.08, 0.18], [0.3, 0.18], [0.7, 0.5]]) {
      const place = [x * this.width, y * this.height];
      if (this.isFree([place[0] - w / 2, place[1] - h / 2, place[0] + w / 2, place[1] + h / 2]))
        return place;
    }
    return [0.92 * this.width, 0.2 * this.height];
  }
}

async function drawSpaceSketch(div, run, snapshot, hasMesh)
{
  const meshes = hasMesh ? [snapshot.fluid, snapshot.solid].filter(Boolean) : [];
  const traces = [meshTrace(snapshot.fluid, {color: FLUID, hoverinfo: "skip"}),
                  meshTrace(snapshot.solid, {color: SOLID, hoverinfo: "skip"}),
                  ...meshes.map(spaceMeshTrace), ...spaceWallTraces(run.walls, snapshot.walls)];
  const layout = spaceLayout(run, div.clientWidth);
  layout.scene.annotations = run.labels.map((label, i) => ({
    x: label.at[0], y: label.at[1], z: label.at[2], text: label.text.replace(/&/g, "&amp;").replace(/</g, "&lt;"),
      ax: (i % 2 ? -1 : 1) * (70 + 18 * i), ay: -44 - 26 * Math.floor(i / 2),
    arrowhead: 0, arrowwidth: 1, arrowcolor: LABEL_COLOURS[label.kind],
      font: {size: 12, color: LABEL_COLOURS[label.kind]},
    bgcolor: "rgba(255,255,255,0.78)", borderpad: 1,
  }));
  await Plotly.newPlot(div, traces, layout, SPACE_CONFIG);
}
