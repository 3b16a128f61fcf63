// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a run that goes on: asks its server for later versions, and takes over what is new in them.
"use strict";

const PAUSE = 1000, MOST_FAILURES = 5; // milliseconds between two questions; questions without answer
const RENEWED = ["overview", "forces", "curves", "accounts", "computation", "messages"];

class Follower
{
  constructor(report, player, sweep)
  {
    Object.assign(this, {report, player, sweep, line: document.getElementById("follow"), failures: 0});
    this.line.hidden = false;
  }

  say(text)
  {
    this.line.textContent = text;
  }

  async follow()
  {
    while (this.failures < MOST_FAILURES) {
      try {
        const state = await (await fetch(`version?${this.report.version}`)).json();
        this.failures = 0;
        if (state.version !== this.report.version) {
          await this.takeOver(await (await fetch("news")).text());
          continue;
        }
        const complaint = state.complaint && `Not up to date: ${state.complaint}`;
        if (state.ended)
          return this.say(complaint ? `${complaint}; the run has ended.` : "The run has ended.");
        this.say(complaint || `Up to date at ${new Date().toLocaleTimeString()}.`);
      }
      catch (error) {
        if (!(error instanceof TypeError))
          throw error;
        ++this.failures; // nobody answers
      }
      await new Promise(done => setTimeout(done, PAUSE));
    }
    this.say("lahar-report has ended: this is the run as it was then.");
  }

  async takeOver(text)
  {
    const page = new DOMParser().parseFromString(text, "text/html");
    const report = JSON.parse(page.getElementById("report").textContent);
    if (this.shape(report) !== this.shape(this.report)) {
      location.reload();
      return new Promise(() => {});
    }
    this.report = report;
    for (const block of page.querySelectorAll("script[id^=snapshot]")) {
      const old = document.getElementById(block.id);
      if (old)
        old.textContent = block.textContent;
      else
        document.body.append(document.importNode(block, true));
    }
    await this.player.update(report);
    document.querySelector(".subtitle").replaceWith(page.querySelector(".subtitle"));
    RENEWED.forEach(id => this.renew(document.getElementById(id), page.getElementById(id)));
    if (this.sweep)
      this.sweep.update(report);
    document.body.dataset.version = report.version;
  }

  // What must not change for a page to be the same one.
  shape(report)
  {
    const names = report.sweep ? report.sweep.measures.map(measure => measure.name) : [];
    return JSON.stringify([Object.keys(report.fields), report.runs.map(run => run.name), names]);
  }

  // Puts a section into the place of the old one; frames with curves stay, and get the new values when they are seen.
  renew(old, fresh)
  {
    const drawn = new Map([...old.querySelectorAll("[data-drawn]")].map(div => [div.dataset.drawn, div]));
    const open = [...old.querySelectorAll("details")].map(box => box.open);
    fresh.querySelectorAll("details").forEach((box, i) => box.open = open[i]);
    const frames = [...fresh.querySelectorAll("[data-plot]")].map(div => {
      const kept = drawn.get(this.report.plots[div.dataset.plot].title);
      if (!kept)
        return div;
      kept.dataset.plot = div.dataset.plot;
      div.replaceWith(kept);
      return kept;
    });
    old.replaceWith(fresh); // before anything is drawn: a frame takes its width from the page that it stands in
    whenVisible(frames, div => drawFrame(div, this.report, this.player));
  }
}
