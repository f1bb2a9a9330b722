// The replay as one uses it: play, scrub, look around, and plots that follow.

const get = (id) => document.getElementById(id);
const RATES = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5];
/** Pictures per second below which the replay draws fewer pixels. */
const LEAST_PACE = 31;
/** Seconds that a replay takes at first, about. */
const FIRST_LENGTH = 8;

function digits(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 0.001 || size >= 1e5) return value.toExponential(1);
  return String(Number(value.toPrecision(3)));
}

class Player {
  constructor(header, scene) {
    Object.assign(this, { header, scene, isPlaying: false, place: null, isDue: false });
    const { times, min, max, radius } = header;
    this.first = times[0] ?? 0;
    this.last = times[times.length - 1] ?? 0;
    this.camera = new Camera(min.map((low) => low - radius), max.map((high) => high + radius));
    this.time = (this.first + this.last) / 2;
    this.colors = {};
    this.pace = { pictures: 0, since: 0 };
    this.plots = [...document.querySelectorAll(".chart[data-span]")].map((figure) => new Plot(figure, this));
    this.wire();
    this.takeColors();
    this.showLegend();
    this.changed();
  }

  wire() {
    const scrub = get("scrub");
    Object.assign(scrub, { min: this.first, max: this.last });
    scrub.addEventListener("input", () => this.seek(Number(scrub.value)));
    const length = this.last - this.first;
    const wanted = Math.min(length / FIRST_LENGTH, 1);
    const first = RATES.reduce((best, rate) => (Math.abs(Math.log(rate / wanted)) < Math.abs(Math.log(best / wanted)) ? rate : best));
    for (const rate of RATES) {
      get("rate").add(new Option(rate === 1 ? "as it was" : `× ${rate}`, rate, false, rate === first));
    }
    get("play").addEventListener("click", () => this.toggle());
    get("reset").addEventListener("click", () => {
      this.camera.reset();
      this.place = null;
      this.changed();
    });
    for (const id of ["color", "walls", "marks"]) {
      get(id).addEventListener("change", () => {
        this.showLegend();
        this.changed();
      });
    }
    get("marks").closest("label").hidden = this.header.hits.length === 0;
    steer(get("view"), this.camera, () => this.changed(), {
      " ": () => this.toggle(),
      ",": () => this.step(-1),
      ".": () => this.step(1),
    });
    for (const button of document.querySelectorAll(".moment")) {
      button.addEventListener("click", () => this.show(Number(button.dataset.time), button.dataset.place.split(" ").map(Number)));
    }
    new ResizeObserver(() => this.changed()).observe(get("view"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.takeColors();
      this.changed();
    });
  }

  /** Colors of the page, for what is drawn. */
  takeColors() {
    const style = getComputedStyle(document.documentElement);
    for (const name of ["wall", "active", "edge", "mark"]) {
      this.colors[name] = style.getPropertyValue(`--${name}`).split(",").map((part) => Number(part) / 255);
    }
  }

  toggle() {
    this.isPlaying = !this.isPlaying;
    if (this.isPlaying && this.time >= this.last) this.time = this.first;
    get("sign").setAttribute("d", this.isPlaying ? "M3 2h4v12H3zM9 2h4v12H9z" : "M4 2l10 6-10 6z");
    get("play").setAttribute("aria-label", this.isPlaying ? "Pause" : "Play");
    this.before = undefined;
    this.pace = { pictures: 0, since: performance.now() };
    this.changed();
  }

  seek(time) {
    this.time = Math.min(Math.max(time, this.first), this.last);
    this.changed();
  }

  step(by) {
    const { times } = this.header;
    const { frame, part } = frameAt(times, this.time);
    this.seek(times[Math.min(Math.max(by < 0 && part > 0 ? frame : frame + by, 0), times.length - 1)]);
  }

  /** Shows a place at a moment, with a ring around it. */
  show(time, place) {
    if (this.isPlaying) this.toggle();
    this.place = place;
    this.camera.approach(place);
    this.seek(time);
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    get("replay").scrollIntoView({ behavior: calm ? "auto" : "smooth", block: "start" });
  }

  changed() {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame((now) => this.draw(now));
  }

  draw(now) {
    this.isDue = false;
    if (this.isPlaying) {
      const passed = this.before === undefined ? 0 : (now - this.before) / 1000;
      this.before = now;
      this.time += passed * Number(get("rate").value);
      this.keepPace(now);
      if (this.time >= this.last) {
        this.time = this.last;
        this.toggle();
      }
    }
    const drawn = this.scene.draw(this.camera, this.time, {
      color: get("color").value,
      hasWalls: get("walls").checked,
      hasMarks: get("marks").checked,
      place: this.place,
      colors: this.colors,
    });
    get("scrub").value = this.time;
    get("scrub").setAttribute("aria-valuetext", `${this.time.toFixed(3)} seconds`);
    get("clock").textContent = `${this.time.toFixed(3)} of ${this.last.toFixed(3)} s`;
    for (const plot of this.plots) plot.follow(this.time);
    Object.assign(document.documentElement.dataset, { state: "ready", pellets: drawn });
    if (this.isPlaying) this.changed();
  }

  /** Counts pictures; where they come too slowly, draws fewer pixels and says so. */
  keepPace(now) {
    this.pace.pictures += 1;
    const passed = (now - this.pace.since) / 1000;
    if (passed < 0.8) return;
    const rate = this.pace.pictures / passed;
    this.pace = { pictures: 0, since: now };
    document.documentElement.dataset.picturesPerSecond = rate.toFixed(1);
    if (rate < LEAST_PACE && this.scene.resolution > 0.35) {
      this.scene.resolution *= 0.8;
      get("pace").textContent = `This browser draws slowly: the replay is drawn at ${Math.round(100 * this.scene.resolution)} % of its resolution to keep pace.`;
    }
  }

  showLegend() {
    const { header } = this;
    const colors = header.colors.match(/.{6}/g).map((color) => `#${color}`).join(", ");
    const [name, ticks] = {
      speed: ["speed [m/s]", [0, 0.5, 1].map((share) => digits(share * header.speed))],
      force: ["greatest force [N]", [0, 0.5, 1].map((share) => digits(header.force * 10 ** (header.decades * (share - 1))))],
      id: ["order of coming", ["first", "", "last"]],
    }[get("color").value];
    const legend = get("legend");
    legend.replaceChildren();
    const add = (kind, text) => {
      const part = document.createElement("div");
      part.className = kind;
      part.textContent = text;
      legend.append(part);
      return part;
    };
    add("name", name);
    add("scale", "").style.background = `linear-gradient(to right, ${colors})`;
    const row = add("ticks", "");
    for (const tick of ticks) row.append(Object.assign(document.createElement("span"), { textContent: tick }));
  }
}

/** A plot over time: a line shows the moment of the replay, and a press on the plot goes there. */
class Plot {
  constructor(figure, player) {
    const [start, end] = figure.dataset.span.split(" ").map(Number);
    const [left, right, top, bottom] = figure.dataset.frame.split(" ").map(Number);
    const svg = figure.querySelector("svg");
    const { width, height } = svg.viewBox.baseVal;
    // Beside the drawing and not in it: a part that moves makes a browser draw the whole anew.
    const box = document.createElement("div");
    box.className = "now";
    Object.assign(box.style, {
      left: `${(100 * left) / width}%`,
      width: `${(100 * (right - left)) / width}%`,
      top: `${(100 * top) / height}%`,
      height: `${(100 * (bottom - top)) / height}%`,
    });
    this.line = box.appendChild(document.createElement("div"));
    figure.querySelector(".drawing").append(box);
    this.share = (time) => (time - start) / (end - start);
    box.addEventListener("click", (event) => {
      const { left: from, width: length } = box.getBoundingClientRect();
      player.seek(start + ((event.clientX - from) / length) * (end - start));
    });
  }
  follow(time) {
    this.line.style.transform = `translateX(${100 * this.share(time)}%)`;
  }
}

try {
  const header = JSON.parse(get("header").textContent);
  if (!window.DecompressionStream) throw new Error("this browser cannot unpack it; take one of 2023 or later");
  const data = unpack(await inflate(get("packed").textContent, header), header);
  const scene = new Scene(get("view"), header, data);
  get("message").textContent = header.times.length ? "" : "The recording holds no frames.";
  new Player(header, scene);
} catch (error) {
  const reason = error.message === "no WebGL2" ? "it needs WebGL2, which this browser does not have or has turned off" : error.message;
  get("message").textContent = `The replay cannot be shown: ${reason}. Plots and tables below are complete.`;
  document.documentElement.dataset.state = "failed";
}
