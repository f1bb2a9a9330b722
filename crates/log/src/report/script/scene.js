// Pellets, walls and marks, drawn.

/** Frame before a time, and how far the time is on the way to the next. */
function frameAt(times, time) {
  let [low, high] = [0, times.length - 1];
  if (high < 1 || time <= times[0]) return { frame: 0, part: 0 };
  if (time >= times[high]) return { frame: high, part: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return { frame: low, part: (time - times[low]) / (times[high] - times[low]) };
}

/** Numbers for a table: whole lines of it, and at least one. */
function tableOf(count, values = []) {
  const line = 4 * TABLE_WIDTH;
  const numbers = new Float32Array(line * Math.max(1, Math.ceil(count / line)));
  numbers.set(values);
  return numbers;
}

const COLOR_OF = {
  speed: (data, i, j, part) => (data.speeds[i] + part * (data.speeds[j] - data.speeds[i])) / 255,
  force: (data, i) => data.forces[i] / 255,
  id: (data, i, j, part, track) => data.ids[track] / Math.max(data.ids[data.ids.length - 1], 1),
};

class Scene {
  constructor(canvas, header, data) {
    // Smooth edges cost a software renderer three quarters of its pace.
    const probe = document.createElement("canvas").getContext("webgl2");
    const info = probe?.getExtension("WEBGL_debug_renderer_info");
    const renderer = info ? probe.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
    probe?.getExtension("WEBGL_lose_context")?.loseContext();
    this.isSoftware = /swiftshader|llvmpipe|software/i.test(renderer);
    const gl = canvas.getContext("webgl2", { antialias: !this.isSoftware, powerPreference: "high-performance" });
    if (!gl) throw new Error("no WebGL2");
    Object.assign(this, { gl, canvas, header, data, resolution: 1 });
    this.pellets = program(gl, PELLETS);
    this.walls = program(gl, WALLS);
    this.edges = program(gl, EDGES);
    this.marks = program(gl, MARKS);
    this.rows = tableOf(8 * header.tracks);
    this.pelletTable = this.table(this.rows);
    const heaviest = header.hits.reduce((most, hit) => Math.max(most, hit[2]), 1e-9);
    const dots = header.hits.flatMap(([, place, weight]) => [...place, 2.5 + 5 * Math.sqrt(weight / heaviest)]);
    this.hitTable = this.table(tableOf(dots.length, dots));
    this.ring = tableOf(4);
    this.ringTable = this.table(this.ring);
    this.corners = this.cornersOf(Math.max(header.tracks, header.hits.length, 1));
    this.surfaces = data.walls.map((wall) => this.surface(wall));
    this.colors = Float32Array.from(header.colors.match(/../g), (pair) => parseInt(pair, 16) / 255);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthFunc(gl.LEQUAL);
  }

  buffer(values, target = this.gl.ARRAY_BUFFER) {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindVertexArray(null);
    gl.bindBuffer(target, buffer);
    gl.bufferData(target, values, gl.STATIC_DRAW);
    return buffer;
  }

  /** A table for squares, of four numbers in each cell. */
  table(values) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, TABLE_WIDTH, values.length / (4 * TABLE_WIDTH));
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    this.fill(texture, values, values.length);
    return texture;
  }

  /** Puts the first numbers of a table in place. */
  fill(texture, values, count) {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    const height = Math.ceil(count / (4 * TABLE_WIDTH));
    if (height > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, TABLE_WIDTH, height, gl.RGBA, gl.FLOAT, values);
  }

  /** Draws a square for each row of a table. */
  squares(made, texture, count) {
    const { gl } = this;
    gl.bindVertexArray(this.corners);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(made.uniform("table"), 0);
    gl.drawElements(gl.TRIANGLES, 6 * count, gl.UNSIGNED_INT, 0);
  }

  /** Two triangles for each of so many squares, by the numbers of their corners. */
  cornersOf(count) {
    const { gl } = this;
    const numbers = new Uint32Array(6 * count);
    for (let i = 0; i < count; i++) numbers.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 2, 4 * i + 1, 4 * i + 3], 6 * i);
    const buffer = this.buffer(numbers, gl.ELEMENT_ARRAY_BUFFER);
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    return array;
  }

  surface(wall) {
    const { gl } = this;
    const array = (made, values, indices) => {
      const buffer = this.buffer(values);
      const list = indices && this.buffer(indices, gl.ELEMENT_ARRAY_BUFFER);
      const vertices = gl.createVertexArray();
      gl.bindVertexArray(vertices);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      if (list) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, list);
      gl.enableVertexAttribArray(made.attribute("corner"));
      gl.vertexAttribPointer(made.attribute("corner"), 3, gl.FLOAT, false, 0, 0);
      return vertices;
    };
    return {
      wall,
      faces: array(this.walls, wall.corners, wall.indices),
      lines: array(this.edges, wall.edges),
    };
  }

  /** Fills a row for each pellet inside at a time; how many there are. */
  gather({ frame, part }, color) {
    const { rows, data, header, colors } = this;
    const top = colors.length / 3 - 1;
    const [x, y, z] = data.places;
    const colorOf = COLOR_OF[color];
    let at = 0;
    for (let track = 0; track < header.tracks; track++) {
      const since = frame - data.firsts[track];
      if (since < 0 || since >= data.lengths[track]) continue;
      const i = data.starts[track] + since;
      const j = since + 1 < data.lengths[track] ? i + 1 : i;
      rows[at++] = x[i] + part * (x[j] - x[i]);
      rows[at++] = y[i] + part * (y[j] - y[i]);
      rows[at++] = z[i] + part * (z[j] - z[i]);
      rows[at++] = data.radii[track];
      const share = Math.min(colorOf(data, i, j, part, track), 1) * top;
      const below = Math.min(share | 0, top - 1);
      for (let k = 3 * below; k < 3 * below + 3; k++) rows[at++] = colors[k] + (share - below) * (colors[k + 3] - colors[k]);
      at++;
    }
    return at / 8;
  }

  draw(camera, time, { color, hasWalls, hasMarks, place, colors }) {
    const { gl, canvas, header } = this;
    const ratio = this.resolution * Math.min(window.devicePixelRatio || 1, this.isSoftware ? 1 : 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((side) => Math.max(1, Math.round(side * ratio)));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const { view, projection } = camera.matrices(width / height);
    const use = (made) => {
      made.use();
      gl.uniformMatrix4fv(made.uniform("view"), false, view);
      gl.uniformMatrix4fv(made.uniform("projection"), false, projection);
    };
    const moment = frameAt(header.times, time);
    const count = this.gather(moment, color);
    use(this.pellets);
    this.fill(this.pelletTable, this.rows, 8 * count);
    this.squares(this.pellets, this.pelletTable, count);
    gl.depthMask(false);
    if (hasWalls) this.drawWalls(use, moment, colors);
    use(this.marks);
    gl.uniform2f(this.marks.uniform("pixels"), width / ratio, height / ratio);
    gl.uniform4f(this.marks.uniform("color"), ...colors.mark, 0.85);
    if (hasMarks) {
      gl.uniform1f(this.marks.uniform("inner"), 0);
      this.squares(this.marks, this.hitTable, header.hits.length);
    }
    if (place) {
      gl.disable(gl.DEPTH_TEST);
      gl.uniform1f(this.marks.uniform("inner"), 0.78);
      this.ring.set([...place, 15]);
      this.fill(this.ringTable, this.ring, 4);
      this.squares(this.marks, this.ringTable, 1);
    }
    return count;
  }

  drawWalls(use, { frame, part }, colors) {
    const { gl } = this;
    const shown = this.surfaces.filter(({ wall }) => wall.presence[frame] === "1");
    for (const [made, share] of [[this.walls, "faces"], [this.edges, "lines"]]) {
      use(made);
      for (const surface of shown) {
        const { wall } = surface;
        const count = share === "faces" ? wall.indices.length : wall.edges.length / 3;
        if (count === 0) continue;
        gl.uniformMatrix4fv(made.uniform("model"), false, poseAt(wall.poses, frame, part));
        const color = share === "lines" ? colors.edge : wall.active ? colors.active : colors.wall;
        gl.uniform4f(made.uniform("color"), ...color, share === "lines" ? 0.55 : 0.16);
        gl.bindVertexArray(surface[share]);
        if (share === "faces") gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
        else gl.drawArrays(gl.LINES, 0, count);
      }
    }
  }
}

/** Pose of a wall between two frames, as a matrix. */
function poseAt(poses, frame, part) {
  const [i, j] = poses.length > 7 ? [frame, Math.min(frame + 1, poses.length / 7 - 1)] : [0, 0];
  const [a, b] = [poses.subarray(7 * i, 7 * i + 7), poses.subarray(7 * j, 7 * j + 7)];
  // The shorter way round of the two that mean the same turn.
  const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
  const mixed = Array.from(a, (value, k) => value + part * ((k < 3 ? 1 : sign) * b[k] - value));
  const [px, py, pz] = mixed;
  const length = Math.hypot(...mixed.slice(3)) || 1;
  const [x, y, z, w] = mixed.slice(3).map((value) => value / length);
  return new Float32Array([
    1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0,
    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0,
    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0,
    px, py, pz, 1,
  ]);
}
