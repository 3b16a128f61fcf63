// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the page of a start: unpacks plotly, then draws the case with its mesh.
"use strict";

startPage(async start => {
  await drawSketch(document.querySelector(".sketch"), start.run, {}, true);
  document.body.dataset.state = "ready";
});
