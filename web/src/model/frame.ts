// The model's place on the stage. The scene is in metres with y up, around an origin near the request's points that is
// subtracted in f64: the graphics card's 32 bits then hold the digits that matter, also of survey coordinates of 10⁷.

import { coordinates, type Line, metresOf, type Request, type Vec3 } from './request';

export class Frame {
  readonly origin: Vec3;
  readonly metres: number;
  readonly up: 1 | 2;

  constructor(origin: Vec3, request: Request) {
    this.origin = origin;
    this.metres = metresOf(request);
    this.up = request.up === 'y' ? 1 : 2;
  }

  toScene(point: ArrayLike<number>): Vec3 {
    const [x, y, z] = [0, 1, 2].map((axis) => ((point[axis] ?? 0) - this.origin[axis]!) * this.metres) as Vec3;
    return this.up === 2 ? [x, z, -y] : [x, y, z];
  }

  fromScene([x, y, z]: Vec3): Vec3 {
    const turned: Vec3 = this.up === 2 ? [x, -z, y] : [x, y, z];
    return turned.map((value, axis) => value / this.metres + this.origin[axis]!) as Vec3;
  }

  /** Metres in the request's unit. */
  length(metres: number): number { return metres / this.metres; }
}

/** How far from zero a model may lie, in its own sizes, before it gets an origin of its own. */
const FAR = 50;

/** The coordinates' zero, unless the model is far from it: then a round number near the model's middle, on its lowest level. */
export function originFor(lines: Line[], request: Request): Vec3 {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const line of lines) {
    for (const point of line.points) {
      const found = coordinates(point);
      if (!found) continue;
      for (let axis = 0; axis < 3; axis += 1) {
        low[axis] = Math.min(low[axis]!, found[axis]!);
        high[axis] = Math.max(high[axis]!, found[axis]!);
      }
    }
  }
  if (!Number.isFinite(low[0]!)) return [0, 0, 0];
  const size = Math.max(...low.map((value, axis) => high[axis]! - value)) || 1;
  const step = 10 ** Math.ceil(Math.log10(size));
  const up = request.up === 'y' ? 1 : 2;
  return low.map((value, axis) => {
    const middle = axis === up ? value : (value + high[axis]!) / 2;
    return Math.abs(middle) > FAR * size ? Math.round(middle / step) * step : 0;
  }) as Vec3;
}
