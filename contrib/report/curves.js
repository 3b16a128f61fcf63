// SPDX-License-Identifier: GPL-3.0-or-later
// Curves over time, and one value a run over a parameter. A frame is drawn when it comes into view.
"use strict";

// Okabe and Ito's colours, which colour-blind readers can tell apart.
const CURVE_COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"];
const DASHES = ["solid", "dot", "dash", "dashdot", "longdash"];
const CURVE_CONFIG = {displaylogo: false, responsive: true,
                      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d", "toggleSpikelines", "zoomIn2d",
                                               "zoomOut2d"]};

function curveLayout(yTitle, xTitle, logarithmic, hasLegend)
{
  const axis = {gridcolor: "#ececec", zerolinecolor: "#c8c8c8", zerolinewidth: 1, linecolor: "#9a9a9a", showline: true,
                mirror: true, ticks: "outside", ticklen: 4, tickcolor: "#9a9a9a", tickfont: {size: 11},
                automargin: true, exponentformat: "power", minexponent: 5};
  return {
    font: FONT, height: hasLegend ? 300 : 270, margin: {l: 62, r: 14, t: 8, b: 42}, plot_bgcolor: "#fff",
    hovermode: "x unified", showlegend: hasLegend,
    legend: {orientation: "h", x: 0, y: 1.02, yanchor: "bottom", font: {size: 11}, traceorder: "normal"},
    xaxis: {...axis, zeroline: false, title: {text: xTitle, standoff: 6}},
    yaxis: {...axis, type: logarithmic ? "log" : "linear", title: {text: yTitle, standoff: 8}},
    hoverlabel: {font: {size: 11}},
  };
}

function frameTraces(plot, report)
{
  const traces = [], isSingle = report.runs.length === 1;
  report.runs.forEach((run, r) => plot.columns.forEach((name, c) => {
    const column = run.columns[name];
    if (!column)
      return;
    // In a frame of one quantity the components are enough.
    const own = column.label.startsWith(plot.title + " ") ? column.label.slice(plot.title.length + 1) : column.label;
    const label = plot.columns.length === 1 ? "" : own;
    const y = floats(column.y), shown = plot.logarithmic ? Float32Array.from(y, v => v > 0 ? v : NaN) : y;
    traces.push({
      type: "scatter", mode: "lines", x: floats(run.times), y: shown,
      name: isSingle ? label : [run.name, label].filter(Boolean).join(" · "), hovertemplate: "%{y:.5~g}",
      line: {color: CURVE_COLOURS[(isSingle ? c : r) % CURVE_COLOURS.length], width: 1.6,
             dash: DASHES[(isSingle ? 0 : c) % DASHES.length]},
    });
  }));
  return traces;
}

async function drawFrame(div, report, player)
{
  const plot = report.plots[Number(div.dataset.plot)], traces = frameTraces(plot, report);
  const layout = curveLayout(plot.unit || "", "time (s)", plot.logarithmic, traces.length > 1);
  const values = traces.flatMap(trace => Array.from(trace.y)).filter(isFinite);
  const lowest = values.reduce((a, b) => Math.min(a, b), Infinity);
  const middle = 0.5 * (lowest + values.reduce((a, b) => Math.max(a, b), -Infinity));
  if (plot.section === "numerics")
    layout.yaxis.rangemode = "tozero";
  if (2 * (middle - lowest) < plot.least_extent)
    layout.yaxis.range = [middle - 0.5 * plot.least_extent, middle + 0.5 * plot.least_extent];
  layout.uirevision = "same"; // drawn again it keeps what the mouse has chosen
  await Plotly.react(div, traces, layout, CURVE_CONFIG);
  if (!div.dataset.drawn)
    div.on("plotly_click", event => player.goTo(event.points[0].x));
  div.dataset.drawn = plot.title;
}

// The elements that are to be drawn, with the functions that draw them; one observer for all of them.
const undrawn = new Map();
const undrawnObserver = new IntersectionObserver(
  all => all.filter(entry => entry.isIntersecting).forEach(entry => drawNow(entry.target)), {rootMargin: "400px"});
window.addEventListener("beforeprint", () => [...undrawn.keys()].forEach(drawNow));

function drawNow(div)
{
  const draw = undrawn.get(div);
  undrawn.delete(div);
  undrawnObserver.unobserve(div);
  if (draw && div.isConnected)
    draw(div);
}

// Calls draw(div) for each element once, as soon as it is near the window or the page is printed; those that have left
// the page are forgotten.
function whenVisible(elements, draw)
{
  [...undrawn.keys()].filter(div => !div.isConnected).forEach(drawNow);
  for (const div of elements) {
    undrawn.set(div, draw);
    undrawnObserver.observe(div);
  }
}

class Sweep
{
  constructor(report)
  {
    this.report = report;
    this.div = document.getElementById("sweep");
    this.parameter = document.getElementById("sweep-parameter");
    this.measure = document.getElementById("sweep-measure");
    report.sweep.parameters.forEach((p, i) => this.parameter.add(new Option(p.name, i)));
    report.sweep.measures.forEach((m, i) => this.measure.add(new Option(m.name, i)));
    this.measure.value = report.sweep.first;
    this.parameter.addEventListener("change", () => this.draw());
    this.measure.addEventListener("change", () => this.draw());
  }

  update(report)
  {
    this.report = report;
    return this.draw();
  }

  draw()
  {
    const parameter = this.report.sweep.parameters[this.parameter.value],
      measure = this.report.sweep.measures[this.measure.value];
    const isNumeric = parameter.values.every(v => v.trim() !== "" && isFinite(Number(v)));
    const order = parameter.values.map((_, r) => r);
    if (isNumeric)
      order.sort((a, b) => parameter.values[a] - parameter.values[b]);
    const place = r => isNumeric ? Number(parameter.values[r]) : parameter.values[r];
    const trace = {
      type: "scatter", mode: isNumeric ? "lines+markers" : "markers", x: order.map(place),
      y: order.map(r => measure.values[r]), text: order.map(r => this.report.runs[r].name),
      hovertemplate: "%{text}<br>%{y:.5~g}<extra></extra>", line: {color: "#b5b5b5", width: 1.2},
      marker: {size: 9, color: order.map(r => CURVE_COLOURS[r % CURVE_COLOURS.length])},
    };
    const layout = curveLayout(measure.name + (measure.unit ? ` (${measure.unit})` : ""), parameter.name, false, false);
    layout.hovermode = "closest";
    layout.height = 340;
    if (!isNumeric)
      layout.xaxis.type = "category";
    return Plotly.react(this.div, [trace], layout, CURVE_CONFIG);
  }
}
