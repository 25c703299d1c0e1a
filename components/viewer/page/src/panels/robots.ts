// Which robots there are. In a graph with several each has its names below its own: /robot1/cmd_vel; one alone has "".

/** Prefixes of names, "" or "/robot1", sorted. Whoever publishes a status of navigation or is asked for one is a robot. */
export function robotsOf(topics: Iterable<string>, services: Iterable<string>): string[] {
  const robots = new Set<string>();
  const add = (name: string, ending: string) => {
    if (name.endsWith(ending)) robots.add(name.slice(0, -ending.length));
  };
  for (const topic of topics) {
    add(topic, "/navigation_status");
    add(topic, "/odometry/filtered");
  }
  for (const service of services) {
    add(service, "/navigate_to_pose/_action/send_goal");
    add(service, "/lifecycle_manager_navigation/manage_nodes");
  }
  return [...robots].sort();
}

/** The robot's own frame in the tree of all: map alone has no prefix. */
export function frameOf(robot: string, frame: string): string {
  return robot === "" ? frame : `${robot.slice(1)}/${frame}`;
}
