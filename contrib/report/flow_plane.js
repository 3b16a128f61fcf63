// SPDX-License-Identifier: GPL-3.0-or-later
// The flow in the plane: the field is painted into a picture that lies below the curves of a plotly plot.
"use strict";

const INK = "#262626", SOLID = "#c0703a", FLUID = "#9cc3e0", FILLED = "#8c8c8c";

const AXIS = {showgrid: false, zeroline: false, showline: true, mirror: true, linecolor: "#9a9a9a", ticks: "outside",
              ticklen: 4, tickcolor: "#9a9a9a", tickfont: {size: 11}};
const FONT = {family: "system-ui, 'Segoe UI', 'DejaVu Sans', Arial, sans-serif", size: 12, color: "#333"};

function planeLayout(box, width)
{
  const [lower, upper] = box, aspect = (upper[1] - lower[1]) / (upper[0] - lower[0]);
  return {
    font: FONT, width, height: Math.round(Math.min(Math.max((width - 76) * aspect + 52, 190), 520)),
    margin: {l: 62, r: 14, t: 8, b: 44}, showlegend: false, dragmode: "pan", hovermode: false, plot_bgcolor: "#fff",
    xaxis: {...AXIS, range: [lower[0], upper[0]], constrain: "domain", title: {text: "x (m)", standoff: 6}},
    yaxis: {...AXIS, range: [lower[1], upper[1]], constrain: "domain", scaleanchor: "x",
            title: {text: "y (m)", standoff: 6}},
    images: [], annotations: [],
  };
}

const PLANE_CONFIG = {displaylogo: false, scrollZoom: true, responsive: false,
                      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d", "toggleSpikelines"]};

// Walls whose points have the coordinates x and y.
function wallTraces(walls, [x, y])
{
  return walls.lines.map((line, i) => ({
    type: "scatter", mode: "lines", x: line.map(p => x[p]), y: line.map(p => y[p]), hoverinfo: "skip",
    line: {color: INK, width: 2.2, simplify: false}, fill: walls.filled[i] ? "toself" : "none", fillcolor: FILLED,
  }));
}

class PlaneView
{
  constructor(div, run, fields, readout)
  {
    Object.assign(this, {div, run, fields, readout, n: 0});
  }

  async build()
  {
    const line = {type: "scatter", mode: "lines", x: [], y: [], hoverinfo: "skip"};
    this.layout = planeLayout(this.run.flow.box, this.div.clientWidth);
    this.traces = [{...line, line: {color: INK, width: 1, simplify: false}},
                   {...line, line: {color: "#5a2d0c", width: 1.2, simplify: false}}];
    await Plotly.newPlot(this.div, this.traces, this.layout, PLANE_CONFIG);
    this.div.on("plotly_relayout", change => {
      if (Object.keys(change).some(key => key.startsWith("xaxis") || key.startsWith("yaxis")))
        this.draw();
    });
    this.div.addEventListener("mousemove", event => this.readAt(event));
    this.div.addEventListener("mouseleave", () => this.readout.textContent = "");
    whenResized(this.div, width => {
      Object.assign(this.layout, {width, height: planeLayout(this.run.flow.box, width).height});
      Plotly.relayout(this.div, {width, height: this.layout.height}).then(() => this.draw());
    });
  }

  // Takes a later state of the run; the part of the plane stays if the mouse has chosen it.
  async update(run, fields)
  {
    const {xaxis, yaxis} = this.div._fullLayout, [lower, upper] = this.run.flow.box;
    const isChosen = Math.abs(xaxis.range[0] - lower[0]) + Math.abs(xaxis.range[1] - upper[0])
      + Math.abs(yaxis.range[0] - lower[1]) + Math.abs(yaxis.range[1] - upper[1]) > 1e-6 * (upper[0] - lower[0]);
    Object.assign(this, {run, fields});
    if (isChosen)
      return;
    this.layout = planeLayout(run.flow.box, this.div.clientWidth);
    const {width, height, xaxis: x, yaxis: y} = this.layout;
    await Plotly.relayout(this.div, {width, height, "xaxis.range": x.range, "yaxis.range": y.range});
  }

  async show(k, field)
  {
    const n = ++this.n, snapshot = await readSnapshot(this.run, k, this.fields);
    if (n !== this.n)
      return;
    this.snapshot = snapshot;
    this.field = field;
    Object.assign(this.traces[0], outlineOf(snapshot.fluid));
    Object.assign(this.traces[1], outlineOf(snapshot.solid));
    this.traces.splice(2, Infinity, ...wallTraces(this.run.walls, snapshot.walls));
    await this.draw();
  }

  async draw()
  {
    if (!this.snapshot)
      return;
    const {xaxis, yaxis} = this.div._fullLayout;
    this.painting = new Painting(xaxis, yaxis, Math.min(window.devicePixelRatio || 1, 2));
    const {fluid, solid} = this.snapshot, colours = this.fields[this.field];
    if (fluid && colours)
      this.painting.paint(fluid, fluid.fields[this.field], this.field === "yielded", colours.colours,
                          coloursOf(this.field));
    if (solid)
      this.painting.paintPlain(solid, SOLID);
    this.layout.images = [this.painting.image()];
    this.layout.xaxis.range = xaxis.range.slice();
    this.layout.yaxis.range = yaxis.range.slice();
    await Plotly.react(this.div, this.traces, this.layout, PLANE_CONFIG);
  }

  // What is below the mouse.
  readAt(event)
  {
    const area = this.div.querySelector(".nsewdrag");
    if (!area || !this.painting)
      return;
    const place = area.getBoundingClientRect(), {x, y, value} = this.painting.at(
      (event.clientX - place.left) / place.width, (event.clientY - place.top) / place.height);
    const text = `x = ${numberText(x, 4)} m, y = ${numberText(y, 4)} m`;
    this.readout.textContent = isNaN(value) ? text : `${text}: ${valueText(this.field, value)}`;
  }
}

// A picture of the visible part of a plot, painted triangle by triangle.
class Painting
{
  constructor(xaxis, yaxis, scale)
  {
    this.width = Math.max(Math.round(xaxis._length * scale), 1);
    this.height = Math.max(Math.round(yaxis._length * scale), 1);
    [this.x0, this.x1] = xaxis.range;
    [this.y0, this.y1] = yaxis.range;
    this.pixels = new Uint32Array(this.width * this.height);
    this.values = new Float32Array(this.width * this.height).fill(NaN);
  }

  // Calls set(pixel, weights of the corners) for all pixels whose centre lies in the triangle.
  cover(surface, t, set)
  {
    const [a, b, c] = surface.corners.map(corner => corner[t]), [px, py] = surface.x;
    const sx = this.width / (this.x1 - this.x0), sy = this.height / (this.y1 - this.y0);
    const ax = (px[a] - this.x0) * sx, bx = (px[b] - this.x0) * sx, cx = (px[c] - this.x0) * sx;
    const ay = (this.y1 - py[a]) * sy, by = (this.y1 - py[b]) * sy, cy = (this.y1 - py[c]) * sy;
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area === 0)
      return;
    const first = Math.max(Math.floor(Math.min(ay, by, cy)), 0), last = Math.min(Math.ceil(Math.max(ay, by, cy)),
                                                                                 this.height - 1);
    const left = Math.max(Math.floor(Math.min(ax, bx, cx)), 0), right = Math.min(Math.ceil(Math.max(ax, bx, cx)),
                                                                                 this.width - 1);
    const few = -1e-6;
    for (let j = first; j <= last; ++j)
      for (let i = left; i <= right; ++i) {
        const x = i + 0.5, y = j + 0.5;
        const wb = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area,
          wc = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
        const wa = 1 - wb - wc;
        if (wa >= few && wb >= few && wc >= few)
          set(j * this.width + i, wa, wb, wc);
      }
  }

  paint(surface, values, isByTriangle, [lower, upper], colours)
  {
    const [A, B, C] = surface.corners, last = colours.length - 1;
    for (let t = 0; t < surface.m; ++t)
      this.cover(surface, t, (pixel, wa, wb, wc) => {
        const value = isByTriangle ? values[t] : wa * values[A[t]] + wb * values[B[t]] + wc * values[C[t]];
        this.values[pixel] = value;
        this.pixels[pixel] = colours[Math.min(Math.max(Math.round((value - lower) / (upper - lower) * last), 0), last)];
      });
  }

  paintPlain(surface, colour)
  {
    const word = colourWord(colour);
    for (let t = 0; t < surface.m; ++t)
      this.cover(surface, t, pixel => {
        this.values[pixel] = NaN;
        this.pixels[pixel] = word;
      });
  }

  image()
  {
    const canvas = document.createElement("canvas");
    canvas.width = this.width;
    canvas.height = this.height;
    canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(this.pixels.buffer), this.width), 0, 0);
    return {source: canvas.toDataURL(), xref: "x", yref: "y", x: this.x0, y: this.y1, sizex: this.x1 - this.x0,
            sizey: this.y1 - this.y0, sizing: "stretch", layer: "below"};
  }

  at(across, down)
  {
    const i = Math.floor(across * this.width), j = Math.floor(down * this.height);
    const isInside = i >= 0 && j >= 0 && i < this.width && j < this.height;
    return {x: this.x0 + across * (this.x1 - this.x0), y: this.y1 - down * (this.y1 - this.y0),
            value: isInside ? this.values[j * this.width + i] : NaN};
  }
}
