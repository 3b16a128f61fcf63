// SPDX-License-Identifier: GPL-3.0-or-later
// What every page begins with: plotly is unpacked, and what goes wrong is said.
"use strict";

function complain(reason)
{
  const box = document.getElementById("complaint");
  box.textContent = `This page could not be drawn: ${reason}`;
  box.hidden = false;
  document.body.dataset.state = "failed";
}

// Calls draw(data) with the data of the page.
async function startPage(draw)
{
  if (typeof DecompressionStream === "undefined")
    throw new Error("the browser is too old; Chrome 80, Firefox 113, Safari 16.4 or later show it");
  const data = JSON.parse(document.getElementById("report").textContent), script = document.createElement("script");
  script.textContent = new TextDecoder().decode(await inflated("plotly"));
  document.head.append(script);
  await draw(data);
}

window.addEventListener("error", event => complain(event.message));
window.addEventListener("unhandledrejection", event => complain(event.reason && event.reason.message || event.reason));
