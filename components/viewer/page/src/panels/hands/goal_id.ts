// Ids of goals of actions: 16 random bytes, version 4 of RFC 9562, as rclcpp makes them.

export function newGoalId(): number[] {
  const id = crypto.getRandomValues(new Uint8Array(16));
  id[6] = (id[6]! & 0x0f) | 0x40;
  id[8] = (id[8]! & 0x3f) | 0x80;
  return [...id];
}
