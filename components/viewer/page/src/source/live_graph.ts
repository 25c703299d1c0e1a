// Who publishes, hears and serves what, as the server tells it: first everything, then what changes.
import type { ConnectionGraph } from "../app";
import type { GraphUpdate } from "./protocol";

export class LiveGraph {
  private graph: ConnectionGraph | undefined;
  private isAsked = false;

  constructor(private readonly subscribe: () => boolean, private readonly onChange: () => void) {}

  /** Asks for it the first time. */
  ask(isConnected: boolean): ConnectionGraph | undefined {
    if (!this.isAsked) {
      this.isAsked = true;
      if (isConnected) this.subscribe();
    }
    return this.graph;
  }

  onConnected(): void {
    if (this.isAsked) this.subscribe();
  }

  clear(): void {
    this.graph = undefined;
    this.onChange();
  }

  update(update: GraphUpdate): void {
    const graph = (this.graph ??= { published: {}, subscribed: {}, services: {} });
    for (const { name, publisherIds } of update.publishedTopics) put(graph.published, name, publisherIds);
    for (const { name, subscriberIds } of update.subscribedTopics) put(graph.subscribed, name, subscriberIds);
    for (const { name, providerIds } of update.advertisedServices) put(graph.services, name, providerIds);
    for (const name of update.removedTopics) {
      delete graph.published[name];
      delete graph.subscribed[name];
    }
    for (const name of update.removedServices) delete graph.services[name];
    this.onChange();
  }
}

function put(nodes: Record<string, string[]>, name: string, ids: string[]): void {
  if (ids.length > 0) nodes[name] = ids;
  else delete nodes[name];
}
