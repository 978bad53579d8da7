// The light that surrounds the model: a bright sky, soft windows on two sides, a pale floor. It is kept as spherical harmonics,
// which is all that a matt membrane shows of it and costs nothing to draw; a mirror image of it would cost a second of start-up
// where the graphics card is a program.

import { LightProbe, SphericalHarmonics3, Vector3 } from 'three';

const DIRECTIONS = 2000;
const WINDOWS = [
  { toward: new Vector3(-0.75, 0.55, 0.38).normalize(), strength: 1.2, width: 0.7 },
  { toward: new Vector3(0.8, 0.42, -0.35).normalize(), strength: 0.5, width: 0.8 },
  { toward: new Vector3(0.1, 1, -0.15).normalize(), strength: 0.4, width: 0.8 },
];

/** Brightness that comes from a direction: red, green, blue. */
function radiance(direction: Vector3): [number, number, number] {
  const h = direction.y;
  const sky = h > 0 ? 0.24 + 0.14 * h ** 0.6 : 0.24 - 0.14 * (-h) ** 0.5;
  let window = 0;
  for (const { toward, strength, width } of WINDOWS) {
    const near = direction.dot(toward);
    if (near > width) window += strength * ((near - width) / (1 - width)) ** 0.5;
  }
  // A cool sky above a warm floor.
  return [sky * (1 - 0.05 * h) + window, sky + window * 0.99, sky * (1 + 0.09 * h) + window * 0.96];
}

export function studioLight(): LightProbe {
  const sh = new SphericalHarmonics3();
  const basis: number[] = [];
  const weight = (4 * Math.PI) / DIRECTIONS;
  for (let i = 0; i < DIRECTIONS; i += 1) {
    // Directions on a golden spiral are spread evenly.
    const y = 1 - (2 * i + 1) / DIRECTIONS, r = Math.sqrt(1 - y * y), angle = i * Math.PI * (3 - Math.sqrt(5));
    const direction = new Vector3(r * Math.cos(angle), y, r * Math.sin(angle));
    const light = new Vector3(...radiance(direction));
    SphericalHarmonics3.getBasisAt(direction, basis);
    for (let k = 0; k < 9; k += 1) sh.coefficients[k]!.addScaledVector(light, basis[k]! * weight);
  }
  return new LightProbe(sh);
}
