// SPDX-License-Identifier: GPL-3.0-or-later
// The flow in space: surfaces that plotly draws and turns.
"use strict";

const LIGHT = {ambient: 0.78, diffuse: 0.38, specular: 0.08, roughness: 0.85, fresnel: 0.05};
const LIGHT_PLACE = {x: -4000, y: -8000, z: 12000};

// The height of the box over its largest side, at most 1.
function flatness(run)
{
  const size = run.flow.size, vertical = run.gravity.map(Math.abs).indexOf(Math.max(...run.gravity.map(Math.abs)));
  return size[vertical] / Math.max(...size);
}

function spaceLayout(run, width)
{
  const [lower, upper] = run.flow.box, names = ["x", "y", "z"];
  const axis = d => ({range: [lower[d], upper[d]], title: {text: `${names[d]} (m)`}, backgroundcolor: "#fbfbfb",
                      showbackground: true,
                      gridcolor: "#e8e8e8", zeroline: false, tickfont: {size: 10}, nticks: 6, showspikes: false});
  // Whatever gravity pulls along is vertical.
  const vertical = run.gravity.map(Math.abs).indexOf(Math.max(...run.gravity.map(Math.abs)));
  const up = [0, 1, 2].map(d => d === vertical ? (run.gravity[d] > 0 ? -1 : 1) : 0);
  const eye = vertical === 2 ? [0.42, -0.78, 0.46 * up[2]] : vertical === 1 ? [0.42, 0.46 * up[1], 0.78]
    : [0.46 * up[0], -0.78, 0.42];
  // Equal axes; the largest side has the length 1, and the camera sees the whole box.
  const size = [0, 1, 2].map(d => upper[d] - lower[d]), ratio = size.map(s => s / Math.max(...size));
  const distance = 2.45 * 0.5 * Math.hypot(...ratio);
  const vector = v => ({x: v[0], y: v[1], z: v[2]});
  return {
    font: FONT, width, height: Math.round(Math.min(Math.max((0.42 + 0.2 * flatness(run)) * width, 300), 600)),
      margin: {l: 0, r: 0, t: 0, b: 0},
    showlegend: false, uirevision: "same",
    scene: {aspectmode: "manual", aspectratio: vector(ratio), xaxis: axis(0), yaxis: axis(1), zaxis: axis(2),
            dragmode: "turntable", uirevision: "same",
            camera: {up: vector(up), eye: vector(eye.map(e => distance * e)), center: {x: 0, y: 0, z: 0}}},
  };
}

const SPACE_CONFIG = {displaylogo: false, responsive: false,
                      modeBarButtonsToRemove: ["resetCameraLastSave3d", "hoverClosest3d", "tableRotation"]};
const EMPTY_MESH = {type: "mesh3d", x: [], y: [], z: [], i: [], j: [], k: []};

function meshTrace(surface, more)
{
  if (!surface)
    return {...EMPTY_MESH, ...more};
  const [x, y, z] = surface.x, [i, j, k] = surface.corners;
  return {type: "mesh3d", x, y, z, i, j, k, lighting: LIGHT, lightposition: LIGHT_PLACE, showscale: false, ...more};
}

// Walls, transparent, and their edges; x are the coordinates of their points.
function spaceWallTraces(walls, x)
{
  if (!walls.triangles)
    return [];
  const [i, j, k] = parts(wholeNumbers(walls.triangles), 3), [from, to] = parts(wholeNumbers(walls.edges), 2);
  const line = d => Array.from(from).flatMap((start, e) => [x[d][start], x[d][to[e]], null]);
  return [
    {type: "mesh3d", x: x[0], y: x[1], z: x[2], i, j, k, color: "#8b8f96", opacity: 0.16, hoverinfo: "skip",
     flatshading: true, lighting: {ambient: 1, diffuse: 0}},
    {type: "scatter3d", mode: "lines", x: line(0), y: line(1), z: line(2), hoverinfo: "skip",
     line: {color: "#6a6f76", width: 2}},
  ];
}

class SpaceView
{
  constructor(div, run, fields, readout)
  {
    Object.assign(this, {div, run, fields, readout, n: 0});
  }

  async build()
  {
    this.layout = spaceLayout(this.run, this.div.clientWidth);
    whenResized(this.div, width => {
      Object.assign(this.layout, {width, height: spaceLayout(this.run, width).height});
      if (this.div._fullLayout)
        Plotly.relayout(this.div, {width, height: this.layout.height});
    });
  }

  // Takes a later state of the run; the camera stays.
  async update(run, fields)
  {
    Object.assign(this, {run, fields, layout: spaceLayout(run, this.div.clientWidth)});
  }

  async show(k, field)
  {
    const n = ++this.n, {fluid, solid, walls} = await readSnapshot(this.run, k, this.fields);
    if (n !== this.n)
      return;
    const traces = [meshTrace(fluid, this.colours(fluid, field)),
                    meshTrace(solid, {color: SOLID, flatshading: true, name: "solid", hoverinfo: "name+x+y+z"})];
    await Plotly.react(this.div, [...traces, ...spaceWallTraces(this.run.walls, walls)], this.layout, SPACE_CONFIG);
    if (this.onTurn) {
      this.div.on("plotly_relayout", this.onTurn);
      this.onTurn = null;
    }
  }

  colours(fluid, field)
  {
    if (!fluid || !this.fields[field])
      return {color: FLUID};
    const style = FIELD_STYLES[field], [cmin, cmax] = this.fields[field].colours, isByTriangle = field === "yielded";
    const more = {intensity: fluid.fields[field], intensitymode: isByTriangle ? "cell" : "vertex", cmin, cmax,
                  colorscale: colourScale(field)};
    if (isByTriangle)
      return {...more, hoverinfo: "x+y+z"};
    return {...more, hovertemplate: `x %{x:.4~g} m<br>y %{y:.4~g} m<br>z %{z:.4~g} m<br>${style.title.split(",")[0]} ` +
                                    `%{intensity:.3~g} ${style.unit}<extra></extra>`};
  }

  // Turns with another view.
  follow(camera)
  {
    Plotly.relayout(this.div, {"scene.camera": camera});
  }
}
