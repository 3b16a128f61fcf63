// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the fields, and the legend that shows them.
"use strict";

// Viridis and the lighter part of magma, turned round (matplotlib), at even distances.
const FIELD_STYLES = {
  speed: {title: "speed", unit: "m/s", stops: ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80",
                                               "#5ec962", "#addc30", "#fde725"]},
  pressure: {title: "pressure, positive where it pushes", unit: "Pa",
             stops: ["#fcfdbf", "#fecf92", "#fe9f6d", "#f7705c", "#de4968", "#b73779", "#8c2981", "#641a80",
                     "#3b0f70"]},
  yielded: {title: "yielding", unit: "", stops: ["#d3d9de", "#3d4c63"],
            words: ["rigid, below the yield stress", "yielded"]},
};
const N_COLOURS = 256;

// The colour #rrggbb as a word of a picture's pixels, on little-endian machines.
function colourWord(text)
{
  const rgb = parseInt(text.slice(1), 16);
  return (0xff000000 | (rgb & 0xff) << 16 | (rgb & 0xff00) | rgb >> 16) >>> 0;
}

function mixed(a, b, share)
{
  const parts = [16, 8, 0].map(shift => {
    const [x, y] = [a, b].map(text => parseInt(text.slice(1), 16) >> shift & 0xff);
    return Math.round(x + (y - x) * share).toString(16).padStart(2, "0");
  });
  return "#" + parts.join("");
}

// The colours of a field from its lowest to its largest value, as words of pixels.
function coloursOf(field)
{
  const style = FIELD_STYLES[field], last = style.stops.length - 1;
  style.table = style.table || Uint32Array.from({length: N_COLOURS}, (_, i) => {
    const place = i / (N_COLOURS - 1) * last, k = Math.min(Math.floor(place), last - 1);
    return colourWord(mixed(style.stops[k], style.stops[k + 1], place - k));
  });
  return style.table;
}

// The same for plotly.
function colourScale(field)
{
  const stops = FIELD_STYLES[field].stops;
  return stops.map((colour, i) => [i / (stops.length - 1), colour]);
}

function valueText(field, value)
{
  const style = FIELD_STYLES[field];
  return style.words ? style.words[value > 0.5 ? 1 : 0]
    : `${style.title.split(",")[0]} ${numberText(value, 3)} ${style.unit}`;
}

function drawLegend(element, field, range)
{
  const style = FIELD_STYLES[field];
  if (style.words) {
    const swatch = i => `<span class="swatch" style="background:${style.stops[i]}"></span>${style.words[i]}`;
    element.innerHTML = swatch(0) + " " + swatch(1);
    return;
  }
  const [lower, upper] = range.colours, [lowest, largest] = range.values, marks = [];
  for (let i = 0; i <= Math.round((upper - lower) / range.step); ++i)
    marks.push(i * range.step / (upper - lower));
  const ends = [lowest < lower - 1e-9 * (upper - lower) ? "≤ " : "", largest > upper + 1e-9 * (upper - lower) ? "≥ "
                : ""];
  const text = i => (i === 0 ? ends[0] : i === marks.length - 1 ? ends[1] : "") +
    numberText(lower + marks[i] * (upper - lower), 3);
  const labels = marks.map((mark, i) => `<span class="mark" style="left:${100 * mark}%">${text(i)}</span>`).join("");
  const gradient = `<span class="gradient" style="background:linear-gradient(90deg,${style.stops.join(",")})"></span>`;
  element.innerHTML = `<span class="bar">${gradient}${labels}</span><span class="unit">${style.unit}</span>`;
}
