// SPDX-License-Identifier: GPL-3.0-or-later
// The slider over time, the menu of fields and the views of all runs that they move.
"use strict";

const FRAMES_PER_SECOND = 8;

class FlowPlayer
{
  constructor(report)
  {
    const find = id => document.getElementById(id);
    Object.assign(this, {slider: find("slider"), label: find("time"), menu: find("field"), legend: find("legend"),
                         play: find("play")});
    this.take(report);
    for (const name of Object.keys(this.fields))
      this.menu.add(new Option(FIELD_STYLES[name].title, name));
    this.menu.disabled = this.menu.length === 0;
    this.views = report.runs.map((run, r) => {
      const View = report.dimension === 2 ? PlaneView : SpaceView;
      return new View(find(`flow-${r}`), run, this.fields, find(`readout-${r}`));
    });
  }

  take(report)
  {
    this.report = report;
    this.fields = report.fields;
    this.times = [...new Set(report.runs.flatMap(run => run.flow.snapshots.map(s => s.time)))].sort((a, b) => a - b);
    this.slider.max = this.times.length - 1;
  }

  // Goes on with a later report of the same runs: at the same time, or with the last snapshot if that was shown.
  async update(report)
  {
    const time = this.times[this.k], wasLast = this.k === this.times.length - 1;
    this.take(report);
    await Promise.all(this.views.map((view, r) => view.update(report.runs[r], report.fields)));
    await this.show(wasLast ? this.times.length - 1 : nearest(this.times, time));
  }

  async build()
  {
    for (const view of this.views)
      await view.build();
    if (this.report.dimension === 3 && this.views.length > 1)
      this.views.forEach(view => view.onTurn = change => this.turn(view, change));
    this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
    this.menu.addEventListener("change", () => this.show(this.k));
    this.play.addEventListener("click", () => this.toggle());
    document.getElementById("back").addEventListener("click", () => this.show(this.k - 1));
    document.getElementById("forth").addEventListener("click", () => this.show(this.k + 1));
    window.addEventListener("hashchange", () => this.readAddress());
    if (!await this.readAddress())
      await this.show(this.report.version === null ? Math.floor(0.4 * (this.times.length - 1)) : this.times.length - 1);
  }

  // The address may end in #snapshot=3&field=pressure, snapshots counted from 0.
  async readAddress()
  {
    const wanted = new URLSearchParams(location.hash.slice(1));
    if (!wanted.has("snapshot") && !wanted.has("field"))
      return false;
    if (this.fields[wanted.get("field")])
      this.menu.value = wanted.get("field");
    await this.show(wanted.has("snapshot") ? Number(wanted.get("snapshot")) || 0 : this.k || 0);
    return true;
  }

  async show(k)
  {
    this.k = Math.min(Math.max(Math.round(k), 0), this.times.length - 1);
    const time = this.times[this.k], field = this.menu.value;
    this.slider.value = this.k;
    this.label.textContent = `t = ${numberText(time, 5)} s  (${this.k + 1} of ${this.times.length})`;
    if (this.fields[field])
      drawLegend(this.legend, field, this.fields[field]);
    this.wanted = [this.k, field];
    if (this.busy)
      return this.busy;
    this.busy = this.draw();
    return this.busy;
  }

  // Draws what is wanted; if that changes meanwhile, once more.
  async draw()
  {
    try {
      let drawn;
      while (drawn !== this.wanted) {
        drawn = this.wanted;
        const time = this.times[drawn[0]];
        await Promise.all(this.views.map(view => {
          const times = view.run.flow.snapshots.map(s => s.time);
          return view.show(nearest(times, time), drawn[1]);
        }));
        document.getElementById("look").dataset.drawn = drawn.join(" ");
        await new Promise(done => setTimeout(done, 0));
      }
    }
    finally {
      this.busy = null;
    }
  }

  goTo(time)
  {
    this.show(nearest(this.times, time));
  }

  toggle()
  {
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = null;
    }
    else {
      if (this.k === this.times.length - 1)
        this.show(0);
      this.timer = setInterval(() => {
        if (this.busy)
          return;
        if (this.k === this.times.length - 1)
          this.toggle();
        else
          this.show(this.k + 1);
      }, 1000 / FRAMES_PER_SECOND);
    }
    this.play.textContent = this.timer ? "❚❚" : "▶";
  }

  turn(view, change)
  {
    const camera = change["scene.camera"];
    if (!camera || this.turning)
      return;
    this.turning = true;
    const others = this.views.filter(other => other !== view);
    Promise.all(others.map(other => other.follow(camera))).then(() => this.turning = false);
  }
}
