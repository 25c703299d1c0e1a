// visualization_msgs as far as the scene has a use for them.
import type { Header } from "./layer";
import type { Rgba } from "./palette";

export const MARKER_ARRAY = "visualization_msgs/msg/MarkerArray";

export const Kind = { arrow: 0, lineStrip: 4, lineList: 5, sphereList: 7, text: 9, triangleList: 11 } as const;

export interface Marker {
  header: Header;
  ns: string;
  id: number;
  type: number;
  action: number;
  pose: { position: { x: number; y: number; z: number }; orientation: { x: number; y: number; z: number; w: number } };
  scale: { x: number; y: number; z: number };
  color: { r: number; g: number; b: number; a: number };
  points: { x: number; y: number; z: number }[];
  /** One for each point, or none. */
  colors: { r: number; g: number; b: number; a: number }[];
  text: string;
}

export interface MarkerArray {
  markers: Marker[];
}

/** Those to be shown, of one namespace. */
export function markersOf(array: MarkerArray, ns: string): Marker[] {
  return array.markers.filter((marker) => marker.ns === ns && marker.action === 0);
}

export function colorOf({ color }: Marker): Rgba {
  return [color.r, color.g, color.b, color.a];
}
