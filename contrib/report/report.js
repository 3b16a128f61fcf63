// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the page: unpacks plotly, then draws what is to be seen.
"use strict";

function complain(reason)
{
  const box = document.getElementById("complaint");
  box.textContent = `This page could not be drawn: ${reason}`;
  box.hidden = false;
  document.body.dataset.state = "failed";
}

async function start()
{
  if (typeof DecompressionStream === "undefined")
    throw new Error("the browser is too old; Chrome 80, Firefox 113, Safari 16.4 or later show it");
  const report = JSON.parse(document.getElementById("report").textContent), script = document.createElement("script");
  script.textContent = new TextDecoder().decode(await inflated("plotly"));
  document.head.append(script);

  const player = new FlowPlayer(report);
  await player.build();
  const sketch = div => drawSketch(div, report.runs[Number(div.dataset.run)], report.fields);
  whenVisible([...document.querySelectorAll(".sketch")], sketch);
  whenVisible([...document.querySelectorAll("[data-plot]")], div => drawFrame(div, report, player));
  const comparison = report.sweep && new Sweep(report);
  if (comparison)
    comparison.draw();
  document.body.dataset.state = "ready";
  if (report.version !== null)
    await new Follower(report, player, comparison).follow();
}

window.addEventListener("error", event => complain(event.message));
window.addEventListener("unhandledrejection", event => complain(event.reason && event.reason.message || event.reason));
start();
