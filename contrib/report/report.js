// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the page of a report: draws what is to be seen.
"use strict";

startPage(async report => {
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
});
