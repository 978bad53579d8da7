// An orbiting camera, y up. Matrices are column by column, as WebGL wants them.

const FIELD = (35 * Math.PI) / 180;
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => scale(a, 1 / Math.hypot(...a));

export class Camera {
  target = [0, 0, 0];
  distance = 10;
  yaw = 0.6;
  pitch = 0.5;
  /** Parallel projection, for plan and elevations. */
  flat = false;
  /** Radius of what is to be seen, for the clipping planes. */
  radius = 1;
  size = [1, 1];

  orbit(dx, dy) {
    this.flat = false;
    this.yaw -= dx * 0.008;
    this.pitch = Math.max(-1.55, Math.min(1.55, this.pitch + dy * 0.008));
  }

  pan(dx, dy) {
    const { right, up } = this.axes();
    const pixel = this.pixel(this.target);
    this.target = add(this.target, add(scale(right, -dx * pixel), scale(up, dy * pixel)));
  }

  zoom(factor) {
    const least = this.radius * 1e-3, most = this.radius * 100;
    this.distance = Math.max(least, Math.min(most, this.distance * factor));
  }

  look(yaw, pitch) {
    Object.assign(this, { yaw, pitch, flat: true });
  }

  /** Shows a ball of this centre and radius. */
  fit(centre, radius) {
    this.radius = radius || 1;
    this.target = centre;
    const aspect = Math.min(1, this.size[0] / this.size[1]);
    this.distance = (1.12 * this.radius) / Math.sin(FIELD / 2) / aspect;
  }

  axes() {
    const { yaw, pitch } = this;
    const back = [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
    const right = [Math.cos(yaw), 0, -Math.sin(yaw)];
    return { back, right, up: cross(back, right) };
  }

  eye() {
    return add(this.target, scale(this.axes().back, this.distance));
  }

  /** The world's size of one pixel at a point. */
  pixel(point) {
    const depth = this.flat ? this.distance : dot(subtract(this.eye(), point), this.axes().back);
    return (2 * Math.max(depth, 1e-9 * this.distance) * Math.tan(FIELD / 2)) / this.size[1];
  }

  view() {
    const { back, right, up } = this.axes();
    const eye = this.eye();
    return [
      right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
      -dot(right, eye), -dot(up, eye), -dot(back, eye), 1,
    ];
  }

  projection() {
    const aspect = this.size[0] / this.size[1];
    const off = Math.hypot(...this.target) + 4 * this.radius;
    const far = this.distance + off;
    if (this.flat) {
      const half = this.distance * Math.tan(FIELD / 2);
      const near = this.distance - off;
      return [
        1 / (half * aspect), 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, -2 / (far - near), 0,
        0, 0, -(far + near) / (far - near), 1,
      ];
    }
    const near = Math.max(this.distance - off, this.distance * 0.01);
    const f = 1 / Math.tan(FIELD / 2);
    return [
      f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1,
      0, 0, (2 * far * near) / (near - far), 0,
    ];
  }

  /** A world point in pixels, and whether it is in front of the eye. */
  project(point) {
    const { back, right, up } = this.axes();
    const seen = subtract(point, this.eye());
    const pixel = this.pixel(point);
    return {
      x: this.size[0] / 2 + dot(seen, right) / pixel,
      y: this.size[1] / 2 - dot(seen, up) / pixel,
      visible: this.flat || dot(seen, back) < -0.01 * this.distance,
    };
  }

  /** The ray through a pixel. */
  ray(x, y) {
    const { back, right, up } = this.axes();
    const pixel = this.pixel(this.target);
    const on = add(this.target, add(scale(right, (x - this.size[0] / 2) * pixel), scale(up, (this.size[1] / 2 - y) * pixel)));
    return this.flat
      ? { origin: add(on, scale(back, this.distance)), direction: scale(back, -1) }
      : { origin: this.eye(), direction: unit(subtract(on, this.eye())) };
  }
}

/** Where a ray meets a plane; null if it runs along it or away from it. */
export function meet({ origin, direction }, point, normal) {
  const along = dot(direction, normal);
  if (Math.abs(along) < 1e-9) return null;
  const t = dot(subtract(point, origin), normal) / along;
  return t > 0 ? add(origin, scale(direction, t)) : null;
}
