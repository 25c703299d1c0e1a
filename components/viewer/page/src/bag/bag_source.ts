// A bag as the source of the page.

import type { Channel, Source } from "../app";
import { indexBag } from "./bag_index";
import { BagTimeline, type BagHooks } from "./bag_timeline";
import type { FileBytes } from "./file_bytes";

export interface BagSource extends Source {
  readonly kind: "bag";
  readonly timeline: BagTimeline;
}

/** The files of one bag, a split one has several. Fails with the reason for what is none. */
export async function openBag(files: FileBytes[], hooks: BagHooks): Promise<BagSource> {
  const index = await indexBag(files);
  for (const note of index.notes) hooks.say("warning", note);
  const timeline = new BagTimeline(index, hooks);
  const channels: Channel[] = [...index.topics.values()].map((topic) => ({
    topic: topic.name,
    type: topic.type,
    schema: topic.schema,
    latched: topic.isLatched,
  }));
  return {
    kind: "bag",
    name: files.map((file) => file.name).join(", "),
    timeline,
    metadata: index.metadata,
    channels: () => channels,
    // Nothing is read before it is looked at.
    want: () => {},
    unwant: () => {},
    close: () => {},
  };
}
