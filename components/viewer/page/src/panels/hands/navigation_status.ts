// bandwagon_msgs/msg/NavigationStatus as a sentence.

export interface NavigationStatus {
  goal_id: number | bigint;
  status: number;
  reason: string;
  distance_remaining: number;
  number_of_recoveries: number;
  number_of_goals_remaining: number;
}

/** The values of action_msgs/msg/GoalStatus. */
const NAMES = ["unknown", "accepted", "driving", "canceling", "reached", "canceled", "given up"];

export function statusText(status: NavigationStatus): string {
  const name = NAMES[status.status] ?? `status ${status.status}`;
  const parts = [`Goal ${status.goal_id}: ${name}`];
  const isOver = status.status >= 4;
  if (!isOver && Number.isFinite(status.distance_remaining)) parts.push(`${status.distance_remaining.toFixed(1)} m to go`);
  if (status.number_of_recoveries > 0) parts.push(`${status.number_of_recoveries} recoveries`);
  if (status.number_of_goals_remaining > 0) parts.push(`${status.number_of_goals_remaining} more to come`);
  if (status.reason !== "" && status.reason !== name) parts.push(status.reason);
  return parts.join(", ");
}
