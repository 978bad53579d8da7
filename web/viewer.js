// Draws one surface and any number of line sets with WebGL 2. Lines are quads of a width in pixels, since WebGL's own are one
// pixel wide at most. Draws only when something has changed.

const SURFACE_VERTEX = `#version 300 es
in vec3 position; in vec3 normal; in vec4 color;
uniform mat4 view, projection; uniform vec3 offset;
out vec3 seen, facing; out vec3 tint;
void main() {
  vec4 at = view * vec4(position + offset, 1.0);
  seen = at.xyz; facing = mat3(view) * normal; tint = color.rgb;
  gl_Position = projection * at;
}`;

// Linear colours in, sRGB out. The back is a little warmer and darker, so that the orientation shows.
const SURFACE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 seen, facing; in vec3 tint;
uniform bool facets, tinted, flat_view; uniform vec3 plain;
out vec4 pixel;
void main() {
  vec3 toward = flat_view ? vec3(0.0, 0.0, 1.0) : normalize(-seen);
  vec3 n = facets ? cross(dFdx(seen), dFdy(seen)) : facing;
  n = normalize(n);
  if (dot(n, toward) < 0.0) n = -n;
  float diffuse = max(dot(n, normalize(vec3(-0.35, 0.55, 0.8))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.7, -0.1, 0.5))), 0.0);
  vec3 base = tinted ? tint : plain;
  if (!gl_FrontFacing) base *= vec3(0.92, 0.84, 0.76);
  vec3 half_way = normalize(toward + normalize(vec3(-0.35, 0.55, 0.8)));
  vec3 light = base * (0.22 + 0.62 * diffuse + 0.24 * fill) + 0.05 * pow(max(dot(n, half_way), 0.0), 40.0);
  pixel = vec4(pow(light, vec3(1.0 / 2.2)), 1.0);
}`;

// One instance a segment; its four corners come from the vertex number. Cut at the near plane before dividing.
const LINE_VERTEX = `#version 300 es
in vec3 start; in vec3 end;
uniform mat4 view, projection; uniform vec3 offset; uniform vec2 size; uniform float width, lift;
void main() {
  vec4 a = projection * (view * vec4(start + offset, 1.0));
  vec4 b = projection * (view * vec4(end + offset, 1.0));
  float na = a.z + a.w, nb = b.z + b.w;
  if (na < 0.0 && nb > 0.0) a = mix(a, b, na / (na - nb));
  if (nb < 0.0 && na > 0.0) b = mix(b, a, nb / (nb - na));
  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  float reach = length(along);
  along = reach > 0.0 ? along / reach : vec2(1.0, 0.0);
  vec4 at = (gl_VertexID & 1) == 0 ? a : b;
  float side = gl_VertexID < 2 ? -1.0 : 1.0;
  float cap = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec2 shift = vec2(-along.y, along.x) * side + along * cap * 0.5;
  at.xy += shift * width / size * at.w;
  at.z -= lift * at.w;
  gl_Position = at;
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 color; out vec4 pixel;
void main() { pixel = vec4(color.rgb * color.a, color.a); }`;

export class Viewer {
  /** Fails if the browser has no WebGL 2. */
  constructor(canvas, camera, onDraw) {
    this.canvas = canvas;
    this.camera = camera;
    this.onDraw = onDraw;
    this.surface = null;
    this.lines = [];
    this.facets = false;
    this.tinted = true;
    this.shown = true;
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: true });
    if (this.gl) this.prepare();
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => { this.prepare(); this.restore(); });
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  prepare() {
    const { gl } = this;
    this.surfaceProgram = program(gl, SURFACE_VERTEX, SURFACE_FRAGMENT);
    this.lineProgram = program(gl, LINE_VERTEX, LINE_FRAGMENT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** After the browser took the context away and gave it back. */
  restore() {
    const { surface, lines } = this;
    this.surface = null;
    this.lines = [];
    if (surface) this.setSurface(surface.mesh, surface.offset);
    lines.forEach((line) => this.setLines(line.name, line.segments, line.offset, line.style));
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.max(1, Math.round(clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(clientHeight * ratio));
    this.camera.size = [Math.max(1, clientWidth), Math.max(1, clientHeight)];
    this.invalidate();
  }

  invalidate() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = null;
      this.draw();
      this.onDraw();
    });
  }

  /** `mesh` as parseGlb gives it, or null; `offset` is where its origin lies. */
  setSurface(mesh, offset) {
    const { gl } = this;
    if (this.surface && gl) this.surface.release();
    this.surface = null;
    if (mesh && gl) {
      const colors = mesh.colors ?? new Uint8Array((mesh.positions.length / 3) * 4);
      const buffers = [
        fill(gl, gl.ARRAY_BUFFER, mesh.positions), fill(gl, gl.ARRAY_BUFFER, mesh.normals), fill(gl, gl.ARRAY_BUFFER, colors),
      ];
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      const layout = [['position', 3, gl.FLOAT, false], ['normal', 3, gl.FLOAT, false], ['color', 4, gl.UNSIGNED_BYTE, true]];
      layout.forEach(([name, width, type, normalized], i) => {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffers[i]);
        attribute(gl, this.surfaceProgram, name, width, type, normalized, 0, 0);
      });
      const indices = fill(gl, gl.ELEMENT_ARRAY_BUFFER, mesh.triangles);
      gl.bindVertexArray(null);
      const release = () => { [...buffers, indices].forEach((b) => gl.deleteBuffer(b)); gl.deleteVertexArray(array); };
      this.surface = { mesh, offset, array, count: mesh.triangles.length, colored: mesh.colors !== null, release };
    }
    this.invalidate();
  }

  /** Replaces the line set of this name. `style`: { width, color: [r, g, b, a], lift }. Empty segments remove it. */
  setLines(name, segments, offset, style) {
    const { gl } = this;
    const index = this.lines.findIndex((line) => line.name === name);
    const [old] = index < 0 ? [] : this.lines.splice(index, 1);
    if (old && gl) old.release();
    if (segments.length > 0 && gl) {
      const buffer = fill(gl, gl.ARRAY_BUFFER, segments);
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      attribute(gl, this.lineProgram, 'start', 3, gl.FLOAT, false, 24, 0, 1);
      attribute(gl, this.lineProgram, 'end', 3, gl.FLOAT, false, 24, 12, 1);
      gl.bindVertexArray(null);
      const release = () => { gl.deleteBuffer(buffer); gl.deleteVertexArray(array); };
      const line = { name, segments, offset, style, array, count: segments.length / 6, shown: old?.shown ?? true, release };
      this.lines.splice(index < 0 ? this.lines.length : index, 0, line);
    }
    this.invalidate();
  }

  removeLines(keep) {
    this.lines.filter((line) => !keep(line.name)).forEach((line) => this.setLines(line.name, new Float32Array(), null, null));
  }

  showLines(name, shown) {
    const line = this.lines.find((each) => each.name === name);
    if (line) line.shown = shown;
    this.invalidate();
  }

  draw() {
    const { gl, camera, surface } = this;
    if (!gl || gl.isContextLost()) return;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const view = new Float32Array(camera.view()), projection = new Float32Array(camera.projection());

    if (surface && this.shown) {
      const at = use(gl, this.surfaceProgram, view, projection, surface.offset);
      gl.uniform1i(at('facets'), this.facets ? 1 : 0);
      gl.uniform1i(at('tinted'), this.tinted && surface.colored ? 1 : 0);
      gl.uniform1i(at('flat_view'), camera.flat ? 1 : 0);
      gl.uniform3f(at('plain'), 0.42, 0.62, 0.72);
      gl.bindVertexArray(surface.array);
      gl.drawElements(gl.TRIANGLES, surface.count, gl.UNSIGNED_INT, 0);
    }
    gl.enable(gl.BLEND);
    const ratio = this.canvas.width / camera.size[0];
    for (const line of this.lines.filter((each) => each.shown)) {
      const at = use(gl, this.lineProgram, view, projection, line.offset);
      gl.uniform2f(at('size'), this.canvas.width, this.canvas.height);
      gl.uniform1f(at('width'), line.style.width * ratio);
      gl.uniform1f(at('lift'), line.style.lift);
      gl.uniform4fv(at('color'), line.style.color);
      gl.bindVertexArray(line.array);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, line.count);
    }
    gl.disable(gl.BLEND);
    gl.bindVertexArray(null);
  }
}

function fill(gl, target, data) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(target, buffer);
  gl.bufferData(target, data, gl.STATIC_DRAW);
  return buffer;
}

function attribute(gl, shader, name, width, type, normalized, stride, offset, divisor = 0) {
  const at = gl.getAttribLocation(shader, name);
  if (at < 0) return;
  gl.enableVertexAttribArray(at);
  gl.vertexAttribPointer(at, width, type, normalized, stride, offset);
  gl.vertexAttribDivisor(at, divisor);
}

function use(gl, shader, view, projection, offset) {
  gl.useProgram(shader);
  const at = (name) => gl.getUniformLocation(shader, name);
  gl.uniformMatrix4fv(at('view'), false, view);
  gl.uniformMatrix4fv(at('projection'), false, projection);
  gl.uniform3fv(at('offset'), offset);
  return at;
}

function program(gl, vertex, fragment) {
  const out = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(out, shader);
  }
  gl.linkProgram(out);
  if (!gl.getProgramParameter(out, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(out));
  return out;
}
