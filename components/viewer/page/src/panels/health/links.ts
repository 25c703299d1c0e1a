// Who sends what to whom: the connection graph, between the components that are drawn.
import type { ConnectionGraph } from "../../app";

export interface Link {
  from: string;
  to: string;
  topics: string[];
}

/** What everybody has: arrows of those would hide all others. */
const OF_ALL = /^\/(rosout|parameter_events|diagnostics|clock|bond|tf|tf_static)$|\/transition_event$|\/_action\/|\/_service_event$/;

/** A node's component by its name in the diagnostics: /robot1/people is robot1/people, /global_costmap/global_costmap is global_costmap. */
export function componentNames(names: readonly string[]): (node: string) => string | undefined {
  const known = new Set(names);
  return (node) => {
    const full = node.replace(/^\//, "");
    if (known.has(full)) return full;
    const parts = full.split("/");
    // A component in a namespace of its own, below the robot's name or without one.
    for (let kept = parts.length - 2; kept >= 0; kept--) {
      const name = [...parts.slice(0, kept), parts.at(-1)].join("/");
      if (known.has(name)) return name;
    }
    return undefined;
  };
}

/** One link for all topics between two components, in the order of topics. */
export function linksOf(graph: ConnectionGraph, names: readonly string[]): Link[] {
  const componentOf = componentNames(names);
  const links = new Map<string, Link>();
  for (const topic of Object.keys(graph.published).sort()) {
    if (OF_ALL.test(topic)) continue;
    for (const from of componentsOf(graph.published[topic]!)) {
      for (const to of componentsOf(graph.subscribed[topic] ?? [])) {
        if (from === to) continue;
        const key = `${from} ${to}`;
        const link = links.get(key) ?? { from, to, topics: [] };
        link.topics.push(topic);
        links.set(key, link);
      }
    }
  }
  return [...links.values()];

  function componentsOf(nodes: readonly string[]): Set<string> {
    return new Set(nodes.map(componentOf).filter((name) => name !== undefined));
  }
}
