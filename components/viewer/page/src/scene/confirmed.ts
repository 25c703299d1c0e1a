const CONFIRMED = 0.5; // confidence of a track from which it is a person and no piece of furniture (local_planner/theory.md 7.10)

/** A person, a robot; not what may be furniture. What is not from 0 to 1 says nothing, and counts as a person. */
export function isConfirmed({ confidence }: { confidence?: number }): boolean {
  return !(confidence !== undefined && confidence >= 0 && confidence < CONFIRMED);
}
