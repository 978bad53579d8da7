// Units of length of drawings, and coordinates in degrees.

import type { Vec3 } from '../model/request';

interface Points { points: Vec3[] }

/** Metres of each unit. A foot of United States surveys differs from the international one by two millionths. */
export const METRES = { mm: 0.001, cm: 0.01, dm: 0.1, m: 1, km: 1000, in: 0.0254, ft: 0.3048, 'US survey ft': 1200 / 3937, yd: 0.9144, mi: 1609.344 };
export type Length = keyof typeof METRES;
/** The unit of a file. Degrees are longitude, latitude and a height in metres. */
export type FileUnit = Length | 'degrees';

/** The radii of WGS 84: the equator's, and the first eccentricity squared. */
const EQUATOR = 6_378_137, ECCENTRICITY = 0.006_694_379_990_14;
/** Degrees over which a drawing is small enough for a plane; it is also too large for a structure beyond it. */
const LARGEST = 0.5;

/** The middle of the lines' box, as longitude and latitude. */
export function middleOf(lines: Points[]): [number, number] {
  const { low, high } = boxOf(lines);
  return [(low[0]! + high[0]!) / 2, (low[1]! + high[1]!) / 2];
}

export function boxOf(lines: Points[]): { low: Vec3; high: Vec3 } {
  const low: Vec3 = [Infinity, Infinity, Infinity], high: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (const { points } of lines) {
    for (const point of points) {
      for (let axis = 0; axis < 3; axis += 1) {
        low[axis] = Math.min(low[axis]!, point[axis]!);
        high[axis] = Math.max(high[axis]!, point[axis]!);
      }
    }
  }
  return { low, high };
}

/** Whether coordinates can be degrees, and those of a site rather than of a drawing in another unit. */
export function mayBeDegrees(lines: Points[]): boolean {
  const { low, high } = boxOf(lines);
  return low[0] >= -180 && high[0] <= 180 && low[1] >= -90 && high[1] <= 90 && high[0] - low[0] <= LARGEST && high[1] - low[1] <= LARGEST;
}

/**
 * Longitude and latitude as metres east and north on the plane that touches WGS 84 at the lines' middle. Distances
 * are true there, and too short by d³/6R² at the distance d: a millimetre at 6 km. Heights stay as they are.
 */
export function toPlane<T extends Points>(lines: T[]): T[] {
  const radians = Math.PI / 180;
  const [longitude, latitude] = middleOf(lines);
  const place = (lon: number, lat: number): Vec3 => {
    const [l, p] = [lon * radians, lat * radians];
    const normal = EQUATOR / Math.sqrt(1 - ECCENTRICITY * Math.sin(p) ** 2);
    return [normal * Math.cos(p) * Math.cos(l), normal * Math.cos(p) * Math.sin(l), normal * (1 - ECCENTRICITY) * Math.sin(p)];
  };
  const [l, p] = [longitude * radians, latitude * radians];
  const centre = place(longitude, latitude);
  return lines.map((line) => ({
    ...line,
    points: line.points.map(([lon, lat, height]): Vec3 => {
      const [x, y, z] = place(lon, lat).map((value, axis) => value - centre[axis]!) as Vec3;
      const east = -Math.sin(l) * x + Math.cos(l) * y;
      const north = -Math.sin(p) * Math.cos(l) * x - Math.sin(p) * Math.sin(l) * y + Math.cos(p) * z;
      // A tenth of a millimetre is what nine decimals of a degree hold.
      return [Math.round(east * 1e4) / 1e4, Math.round(north * 1e4) / 1e4, height];
    }),
  }));
}

/** Coordinates of web maps (EPSG:3857), whose lengths grow with the latitude, as degrees. */
export const fromWebMap = ([x, y, z]: Vec3): Vec3 => [(x / EQUATOR) * (180 / Math.PI), (2 * Math.atan(Math.exp(y / EQUATOR)) - Math.PI / 2) * (180 / Math.PI), z];
