// Where one looks from, and how hand, wheel and keys change it. Columns first, as WebGL wants its matrices.

const FIELD_OF_VIEW = 0.6;

function product(a, b) {
  const c = new Float32Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4 * k + row] * b[4 * column + k];
      c[4 * column + row] = sum;
    }
  }
  return c;
}

class Camera {
  /** Looks at a box so that all of it is seen. */
  constructor(min, max) {
    this.home = {
      target: min.map((low, axis) => (low + max[axis]) / 2),
      size: Math.max(Math.hypot(...min.map((low, axis) => max[axis] - low)), 1e-3),
    };
    this.reset();
  }
  reset() {
    this.target = [...this.home.target];
    this.distance = 1.75 * this.home.size;
    this.turn = 0.6;
    this.rise = 0.28;
  }
  /** Looks at a place from nearby. */
  approach(place) {
    this.target = [...place];
    this.distance = Math.min(this.distance, 0.6 * this.home.size);
  }
  orbit(across, up) {
    this.turn -= across;
    this.rise = Math.min(Math.max(this.rise + up, -1.5), 1.5);
  }
  /** Shifts by shares of the height of the view. */
  pan(across, up) {
    const length = 2 * this.distance * Math.tan(FIELD_OF_VIEW / 2);
    const { right, above } = this.axes();
    for (let axis = 0; axis < 3; axis++) {
      this.target[axis] -= length * (across * right[axis] + up * above[axis]);
    }
  }
  zoom(factor) {
    const { size } = this.home;
    this.distance = Math.min(Math.max(this.distance * factor, 0.02 * size), 20 * size);
  }
  axes() {
    const [ct, st, cr, sr] = [
      Math.cos(this.turn), Math.sin(this.turn), Math.cos(this.rise), Math.sin(this.rise),
    ];
    return { right: [-st, ct, 0], above: [-ct * sr, -st * sr, cr], back: [ct * cr, st * cr, sr] };
  }
  /** From the world to the eye, and from the eye to the screen. */
  matrices(aspect) {
    const { right, above, back } = this.axes();
    const eye = this.target.map((at, axis) => at + this.distance * back[axis]);
    const along = (way) => -way.reduce((sum, part, axis) => sum + part * eye[axis], 0);
    const view = new Float32Array([
      right[0], above[0], back[0], 0,
      right[1], above[1], back[1], 0,
      right[2], above[2], back[2], 0,
      along(right), along(above), along(back), 1,
    ]);
    // A narrow view shows the same width as a square one.
    const reach = Math.tan(FIELD_OF_VIEW / 2) / Math.min(1, aspect);
    const near = Math.max(this.distance - 3 * this.home.size, 0.01 * this.distance);
    const far = this.distance + 8 * this.home.size;
    const projection = new Float32Array([
      1 / (reach * aspect), 0, 0, 0,
      0, 1 / reach, 0, 0,
      0, 0, (far + near) / (near - far), -1,
      0, 0, (2 * far * near) / (near - far), 0,
    ]);
    return { view, projection };
  }
}

/** Lets hand, wheel and keys move a camera; `changed` is called after each move. */
function steer(canvas, camera, changed, keys) {
  const fingers = new Map();
  const middle = () => {
    const points = [...fingers.values()];
    const mean = (axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length;
    const [x, y] = [mean(0), mean(1)];
    return { x, y, spread: Math.hypot(points[0][0] - x, points[0][1] - y) };
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
  }
  canvas.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId)) return;
    const before = middle();
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    const after = middle();
    const height = canvas.clientHeight;
    const across = (after.x - before.x) / height;
    const up = (after.y - before.y) / height;
    if (fingers.size > 1 || event.shiftKey || event.buttons & 6) camera.pan(across, -up);
    else camera.orbit(4 * across, 4 * up);
    if (fingers.size > 1 && after.spread > 0) camera.zoom(before.spread / after.spread);
    changed();
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    // A page that scrolls past must not stop here: the wheel zooms once the view was chosen.
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    camera.zoom(Math.exp(0.0015 * event.deltaY * (event.deltaMode === 1 ? 30 : 1)));
    changed();
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const way = ways[event.key];
    if (way && event.shiftKey) camera.pan(0.05 * way[0], 0.05 * way[1]);
    else if (way) camera.orbit(-0.1 * way[0], 0.1 * way[1]);
    else if (event.key === "+" || event.key === "=") camera.zoom(0.9);
    else if (event.key === "-") camera.zoom(1 / 0.9);
    else if (event.key === "0") camera.reset();
    else if (keys[event.key]) keys[event.key]();
    else return;
    event.preventDefault();
    changed();
  });
}
