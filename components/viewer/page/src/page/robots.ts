// Which robots there are, by the names of their topics.
import type { Channel } from "../app";

const OF_A_ROBOT: [string, string][] = [
  ["/odom", "nav_msgs/msg/Odometry"],
  ["/local_plan", "nav_msgs/msg/Path"],
  ["/scan", "sensor_msgs/msg/LaserScan"],
];

/** Namespaces, sorted; "" for a robot without. */
export function robotsAmong(channels: readonly Channel[]): string[] {
  const names = new Set<string>();
  for (const { topic, type } of channels)
    for (const [suffix, itsType] of OF_A_ROBOT)
      if (type === itsType && topic.endsWith(suffix)) names.add(topic.slice(0, -suffix.length));
  return [...names].sort();
}

/** The robot's topic, or that which all share; undefined where there is none. */
export function topicOf(channels: readonly Channel[], robot: string, suffix: string, type: string): string | undefined {
  const found = (topic: string) => channels.some((channel) => channel.topic === topic && channel.type === type);
  if (found(robot + suffix)) return robot + suffix;
  return found(suffix) ? suffix : undefined;
}

/** robot1/base_link: frames have the namespace as their prefix. */
export function framePrefix(robot: string): string {
  return robot === "" ? "" : `${robot.slice(1)}/`;
}
