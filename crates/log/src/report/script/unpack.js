// What the page carries, as numbers.

/** The bytes of the replay, as `header` promises them. */
async function inflate(text, header) {
  const letters = atob(text);
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  if (bytes.length !== header.bytes) throw new Error("the replay is incomplete");
  return bytes;
}

/** Reads numbers one run after another. */
class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }
  take(count) {
    this.at += count;
    return this.bytes.slice(this.at - count, this.at);
  }
  floats(count) {
    return new Float32Array(this.take(4 * count).buffer);
  }
  longs(count) {
    return new Uint32Array(this.take(4 * count).buffer);
  }
  /** Numbers whose lowest bytes come first, then the next ones. */
  planes(count, width) {
    const numbers = width > 2 ? new Uint32Array(count) : new Uint16Array(count);
    for (let plane = 0; plane < width; plane++) {
      const bytes = this.take(count);
      for (let i = 0; i < count; i++) numbers[i] |= bytes[i] << (8 * plane);
    }
    return numbers;
  }
}

/** Walls and tracks, from the bytes of the replay. */
function unpack(bytes, header) {
  const reader = new Reader(bytes);
  const walls = header.walls.map((wall) => ({
    ...wall,
    poses: reader.floats(7 * wall.poses),
    corners: reader.floats(3 * wall.corners),
    edges: reader.floats(3 * wall.edges),
    indices: reader.longs(wall.indices),
  }));
  const count = header.tracks;
  const ids = reader.planes(count, 4);
  for (let i = 1; i < count; i++) ids[i] += ids[i - 1];
  const radii = Float32Array.from(reader.planes(count, 2), (r) => (r / 65535) * header.radius);
  const firsts = reader.planes(count, 2);
  const lengths = reader.planes(count, 2);
  const starts = new Uint32Array(count + 1);
  for (let i = 0; i < count; i++) starts[i + 1] = starts[i] + lengths[i];
  const places = [0, 1, 2].map((axis) => {
    const steps = reader.planes(header.points, 2);
    const least = header.min[axis];
    const unit = (header.max[axis] - least) / 65535;
    const values = new Float32Array(header.points);
    for (let track = 0; track < count; track++) {
      let place = 0;
      for (let i = starts[track]; i < starts[track + 1]; i++) {
        place = (place + ((steps[i] >> 1) ^ -(steps[i] & 1))) & 0xffff;
        values[i] = least + place * unit;
      }
    }
    return values;
  });
  const summed = () => {
    const values = reader.take(header.points);
    for (let track = 0; track < count; track++) {
      for (let i = starts[track] + 1; i < starts[track + 1]; i++) values[i] += values[i - 1];
    }
    return values;
  };
  return { walls, ids, radii, firsts, lengths, starts, places, speeds: summed(), forces: summed() };
}
