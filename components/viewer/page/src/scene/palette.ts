// Colours of the scene. Those that mean something are Okabe and Ito's, which people with any kind of colour vision tell apart; what they cannot
// tell by colour alone differs in shape as well. Each has a variant for a light ground.

/** Red, green, blue, opacity: 0 to 1, as the screen takes them. */
export type Rgba = readonly [number, number, number, number];

export function hex(text: string, opacity = 1): Rgba {
  const value = parseInt(text.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255, opacity];
}

export function toHex([r, g, b]: Rgba): string {
  return `#${[r, g, b].map((part) => Math.round(part * 255).toString(16).padStart(2, "0")).join("")}`;
}

export function withOpacity([r, g, b]: Rgba, opacity: number): Rgba {
  return [r, g, b, opacity];
}

export function mix(a: Rgba, b: Rgba, share: number): Rgba {
  const part = (i: 0 | 1 | 2 | 3) => a[i] + share * (b[i] - a[i]);
  return [part(0), part(1), part(2), part(3)];
}

/** Along a scale of colours at equal distances; `share` is held between 0 and 1. */
export function along(scale: readonly Rgba[], share: number): Rgba {
  const at = Math.min(Math.max(Number.isNaN(share) ? 0 : share, 0), 1) * (scale.length - 1);
  const i = Math.min(Math.floor(at), scale.length - 2);
  return mix(scale[i]!, scale[i + 1]!, at - i);
}

export interface Palette {
  ground: Rgba;
  grid: Rgba;
  text: Rgba;
  halo: Rgba;
  free: Rgba;
  occupied: Rgba;
  cost: Rgba;
  robot: Rgba;
  otherRobot: Rgba;
  trail: Rgba;
  plan: Rgba;
  /** Slow to fast. */
  speed: readonly Rgba[];
  /** Of the other candidates, one class after the other. */
  classes: readonly Rgba[];
  people: Rgba;
  laser: Rgba;
  cones: Rgba;
  wanted: Rgba;
  particles: Rgba;
  goal: Rgba;
  zoneFree: Rgba;
  zoneLimited: Rgba;
  zoneStopped: Rgba;
  zoneIdle: Rgba;
}

const DARK: Palette = {
  ground: hex("#0e1116"),
  grid: hex("#1a2029"),
  text: hex("#e4e8ed"),
  halo: hex("#0e1116"),
  free: hex("#181e26"),
  occupied: hex("#b9c2cc"),
  cost: hex("#7d8fd6"),
  robot: hex("#56b4e9"),
  otherRobot: hex("#8fa3b5"),
  trail: hex("#3d7397"),
  plan: hex("#8d98a5"),
  speed: [hex("#3d62d8"), hex("#2aa7a0"), hex("#f0e442")],
  classes: [hex("#b66f97"), hex("#a8642f"), hex("#5e86b8"), hex("#8a919b"), hex("#2c8f73")],
  people: hex("#e69f00"),
  laser: hex("#1fc89a"),
  cones: hex("#cc79a7"),
  wanted: hex("#e4e8ed"),
  particles: hex("#d79abc"),
  goal: hex("#f0e442"),
  zoneFree: hex("#009e73"),
  zoneLimited: hex("#e69f00"),
  zoneStopped: hex("#d55e00"),
  zoneIdle: hex("#6d7782"),
};

const LIGHT: Palette = {
  ground: hex("#eceef1"),
  grid: hex("#dfe2e7"),
  text: hex("#1b2129"),
  halo: hex("#ffffff"),
  free: hex("#ffffff"),
  occupied: hex("#38414b"),
  cost: hex("#5a6fc4"),
  robot: hex("#0072b2"),
  otherRobot: hex("#5b6e80"),
  trail: hex("#8fbcd8"),
  plan: hex("#8a949f"),
  speed: [hex("#27479f"), hex("#13887f"), hex("#d9a400")],
  classes: [hex("#c08aab"), hex("#c39a77"), hex("#8aa8cc"), hex("#a9b0b8"), hex("#6bb39c")],
  people: hex("#d98200"),
  laser: hex("#00855f"),
  cones: hex("#b0558a"),
  wanted: hex("#1b2129"),
  particles: hex("#b0558a"),
  goal: hex("#b8860b"),
  zoneFree: hex("#009e73"),
  zoneLimited: hex("#d98200"),
  zoneStopped: hex("#d55e00"),
  zoneIdle: hex("#9aa3ad"),
};

export function paletteFor(isDark: boolean): Palette {
  return isDark ? DARK : LIGHT;
}
