// All parameters of all nodes, asked of their services, followed while others change them, and changed from here.
import { equal, fromWire, toWire, type Value } from "./values";
import { parameterOf, type Descriptor, type Parameter } from "./descriptor";

export type Call = <Response>(service: string, request: object) => Promise<Response>;

export interface Entry {
  readonly parameter: Parameter;
  value: Value;
  /** What it was when the page saw it first. */
  readonly first: Value;
}

export interface ParameterEvent {
  node: string;
  new_parameters: WireParameter[];
  changed_parameters: WireParameter[];
}

interface WireParameter {
  name: string;
  value: { type: number } & Record<string, unknown>;
}

/** Nodes are asked this many at a time, by two calls at most each: the server of the page takes 32 in flight, and others ask too. */
const AT_ONCE = 8;

export class ParameterStore {
  private readonly entries = new Map<string, Map<string, Entry>>();

  /** `onChange` hears of each value that is another one now; `onNodes` of nodes that came or went. */
  constructor(
    private readonly call: Call,
    private readonly onChange: (entry: Entry) => void,
    private readonly onNodes: (node: string) => void,
  ) {}

  nodes(): string[] {
    return [...this.entries.keys()].sort();
  }

  of(node: string): readonly Entry[] {
    return [...(this.entries.get(node)?.values() ?? [])];
  }

  find(node: string, name: string): Entry | undefined {
    return this.entries.get(node)?.get(name);
  }

  /** In the order of nodes and of their lists. */
  changed(): Entry[] {
    return this.nodes().flatMap((node) => this.of(node).filter(({ value, first }) => !equal(value, first)));
  }

  /** Asks all of `nodes`; one that does not answer is told to `failed` and left out. What is known of others stays. */
  async load(nodes: readonly string[], failed: (node: string, reason: unknown) => void): Promise<void> {
    const waiting = [...nodes];
    const work = async () => {
      for (let node = waiting.shift(); node !== undefined; node = waiting.shift()) {
        try {
          await this.loadNode(node);
        } catch (reason) {
          failed(node, reason);
        }
      }
    };
    await Promise.all(Array.from({ length: AT_ONCE }, work));
  }

  /** Fails with the node's reason when it refuses. */
  async set(entry: Entry, value: Value): Promise<void> {
    const { node, name, type } = entry.parameter;
    const { result } = await this.call<{ result: { successful: boolean; reason: string } }>(`${node}/set_parameters_atomically`, {
      parameters: [{ name, value: toWire(type, value) }],
    });
    if (!result.successful) throw new Error(result.reason || "refused");
    this.heard(entry, value);
  }

  follow(event: ParameterEvent): void {
    for (const { name, value } of [...event.new_parameters, ...event.changed_parameters]) {
      const entry = this.find(event.node, name);
      if (entry !== undefined) this.heard(entry, fromWire(value));
    }
  }

  private heard(entry: Entry, value: Value): void {
    if (equal(entry.value, value)) return;
    entry.value = value;
    this.onChange(entry);
  }

  private async loadNode(node: string): Promise<void> {
    const listed = await this.call<{ result: { names: string[] } }>(`${node}/list_parameters`, { prefixes: [], depth: 0 });
    const { names } = listed.result;
    const [{ descriptors }, { values }] = await Promise.all([
      this.call<{ descriptors: Descriptor[] }>(`${node}/describe_parameters`, { names }),
      this.call<{ values: WireParameter["value"][] }>(`${node}/get_parameters`, { names }),
    ]);
    if (descriptors.length !== names.length || values.length !== names.length) throw new Error("its parameters changed while asked");
    const before = this.entries.get(node);
    this.entries.set(
      node,
      new Map(
        descriptors.map((descriptor, i) => {
          const parameter = parameterOf(node, descriptor);
          const value = fromWire(values[i]!);
          // A robot that was gone and is back: what it was at first stays what it was at first.
          const known = before?.get(parameter.name);
          return [parameter.name, { parameter, value, first: known === undefined ? value : known.first }];
        }),
      ),
    );
    this.onNodes(node);
  }
}
