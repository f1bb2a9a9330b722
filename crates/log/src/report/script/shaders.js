// What the graphics card does. Colors are multiplied by their opacity, so that the page shines through.

// Squares are made of a table of their centers: drawing them as instances takes a software renderer a hundred times as
// long, as it begins anew with each.
const SQUARES = `#version 300 es
precision highp float;
uniform highp sampler2D table;
const int WIDTH = 1024;
vec4 cell(int index) { return texelFetch(table, ivec2(index % WIDTH, index / WIDTH), 0); }
int row() { return gl_VertexID >> 2; }
vec2 corner() { return vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1) * 2.0 - 1.0; }
`;
const TABLE_WIDTH = 1024;

/** Pellets: each a square that faces the eye and is shaded as a sphere. */
const PELLETS = [`${SQUARES}
uniform mat4 view, projection;
out vec2 place;
flat out vec3 color;
void main() {
  vec4 pellet = cell(2 * row());
  float radius = pellet.w;
  vec4 at = view * vec4(pellet.xyz, 1.0);
  place = corner();
  color = cell(2 * row() + 1).rgb;
  gl_Position = projection * vec4(at.xy + radius * place, at.zw);
  // As deep as its front: no wall that it rests on cuts it.
  vec4 front = projection * vec4(at.xy, at.z + radius, 1.0);
  gl_Position.z = front.z / front.w * gl_Position.w;
}`, `#version 300 es
precision mediump float;
in vec2 place;
flat in vec3 color;
out vec4 pixel;
void main() {
  float square = dot(place, place);
  if (square > 1.0) discard;
  vec3 normal = vec3(place, sqrt(1.0 - square));
  float light = 0.38 + 0.62 * max(dot(normal, vec3(-0.33, 0.56, 0.76)), 0.0);
  float rim = smoothstep(0.72, 1.0, square);
  pixel = vec4(color * light * (1.0 - 0.35 * rim), 1.0);
}`];

/** Walls: see-through, denser where they are seen from the side. */
const WALLS = [`#version 300 es
uniform mat4 model, view, projection;
in vec3 corner;
out vec3 place;
void main() {
  vec4 at = view * model * vec4(corner, 1.0);
  place = at.xyz;
  gl_Position = projection * at;
}`, `#version 300 es
precision highp float;
uniform vec4 color;
in vec3 place;
out vec4 pixel;
void main() {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  float facing = abs(dot(normal, normalize(place)));
  float opacity = color.a * mix(2.2, 0.7, facing);
  pixel = vec4(color.rgb, 1.0) * opacity;
}`];

const EDGES = [WALLS[0], `#version 300 es
precision mediump float;
uniform vec4 color;
in vec3 place;
out vec4 pixel;
void main() {
  pixel = vec4(color.rgb, 1.0) * color.a;
}`];

/** Marks of hits: discs, or a ring around the one that is looked at, of a size on the screen. */
const MARKS = [`${SQUARES}
uniform mat4 view, projection;
uniform vec2 pixels;
out vec2 place;
void main() {
  vec4 mark = cell(row());
  place = corner();
  gl_Position = projection * view * vec4(mark.xyz, 1.0);
  gl_Position.xy += place * mark.w * 2.0 / pixels * gl_Position.w;
  gl_Position.z -= 0.002 * gl_Position.w;
}`, `#version 300 es
precision mediump float;
uniform vec4 color;
uniform float inner;
in vec2 place;
out vec4 pixel;
void main() {
  float away = length(place);
  if (away > 1.0 || away < inner) discard;
  pixel = vec4(color.rgb, 1.0) * color.a;
}`];

function program(gl, [vertex, fragment]) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  const places = new Map();
  const uniform = (name) => {
    if (!places.has(name)) places.set(name, gl.getUniformLocation(made, name));
    return places.get(name);
  };
  return { use: () => gl.useProgram(made), uniform, attribute: (name) => gl.getAttribLocation(made, name) };
}
