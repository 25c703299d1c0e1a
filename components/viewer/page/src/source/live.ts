// A live robot, over the Foxglove WebSocket protocol.
import type { App, Channel, ConnectionGraph, Source } from "../app";
import { LiveGraph } from "./live_graph";
import { LiveHands } from "./live_hands";
import { LiveTimeline } from "./live_timeline";
import { SUBPROTOCOLS, readBinary, type AdvertisedChannel, type BinaryMessage, type TextMessage } from "./protocol";

const RETRY = 1000; // [ms]
const COMMANDER = "commander"; // id of the status that says who commands
const READ_ONLY = "read_only"; // id of the status that says why this page may not
const LEVELS = ["info", "warning", "error"] as const;

/** Connects, and again each second when the robot is gone. */
export class LiveSource implements Source {
  readonly kind = "live";
  readonly timeline: LiveTimeline;
  readonly hands: LiveHands;
  metadata: Record<string, string> = {};

  private socket: WebSocket | undefined;
  private retry = 0;
  private isClosed = false;
  private wasTold = false;
  private session: string | undefined;
  private readonly wanted = new Map<string, number>();
  private readonly byTopic = new Map<string, { id: number; channel: Channel }>();
  /** A subscription has the id of its channel. */
  private readonly subscribed = new Map<number, Channel>();
  private readonly links = new LiveGraph(
    () => this.send({ op: "subscribeConnectionGraph" }),
    () => this.app.emit("graph"),
  );

  /** `token`: what commands need, where there is one. */
  constructor(readonly name: string, private readonly app: Pick<App, "emit" | "say">, private readonly token?: string) {
    this.timeline = new LiveTimeline((topic, reason) => app.say("warning", `${topic} cannot be read: ${reason}`));
    this.hands = new LiveHands((frame) => this.send(frame), () => app.emit("services"), () => app.emit("parameters"));
    this.connect();
  }

  get isConnected(): boolean {
    return this.socket?.readyState === WebSocket.OPEN;
  }

  channels(): Channel[] {
    return [...this.byTopic.values()].map(({ channel }) => channel);
  }

  graph(): ConnectionGraph | undefined {
    return this.links.ask(this.isConnected);
  }

  want(topic: string): void {
    this.wanted.set(topic, (this.wanted.get(topic) ?? 0) + 1);
    this.subscribe(topic);
  }

  unwant(topic: string): void {
    const count = (this.wanted.get(topic) ?? 0) - 1;
    if (count > 0) {
      this.wanted.set(topic, count);
      return;
    }
    this.wanted.delete(topic);
    const id = this.byTopic.get(topic)?.id;
    if (id !== undefined && this.subscribed.delete(id)) this.send({ op: "unsubscribe", subscriptionIds: [id] });
  }

  close(): void {
    this.isClosed = true;
    clearTimeout(this.retry);
    this.socket?.close();
  }

  private connect(): void {
    const query = this.token === undefined ? "" : `/?token=${encodeURIComponent(this.token)}`;
    const socket = new WebSocket(this.name + query, SUBPROTOCOLS);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    socket.onmessage = (event) => {
      if (this.isClosed) return;
      try {
        if (typeof event.data === "string") this.onText(JSON.parse(event.data));
        else this.onBinary(readBinary(event.data));
      } catch (error) {
        this.app.say("error", `The server sent what cannot be read: ${error}`);
      }
    };
    socket.onclose = (event) => this.onClose(event.reason);
  }

  private onClose(reason: string): void {
    if (this.isClosed) return;
    this.byTopic.clear();
    this.subscribed.clear();
    this.links.clear();
    this.hands.disconnect();
    if (!this.wasTold) this.app.say("warning", `No connection to ${this.name}${reason && `: ${reason}`}; trying again each second`);
    this.wasTold = true;
    this.app.emit("channels");
    this.app.emit("source");
    this.retry = window.setTimeout(() => this.connect(), RETRY);
  }

  private onText(message: TextMessage): void {
    switch (message.op) {
      case "serverInfo":
        this.metadata = message.metadata ?? {};
        if (this.session !== message.sessionId) this.timeline.clear(); // another run: its time has nothing to do with that of the last
        this.session = message.sessionId;
        this.hands.connect(message.capabilities, message.supportedEncodings ?? ["json"], this.metadata);
        this.links.onConnected();
        if (this.wasTold) this.app.say("info", "Connected again");
        this.wasTold = false;
        this.app.emit("source");
        break;
      case "status":
        if (message.id === COMMANDER) this.setCommander(message.level > 0 ? message.message : "");
        else if (message.id === READ_ONLY) this.setReadOnly(message.message);
        else this.app.say(LEVELS[message.level] ?? "info", message.message);
        break;
      case "removeStatus":
        if (message.statusIds.includes(COMMANDER)) this.setCommander("");
        break;
      case "advertise":
        for (const channel of message.channels) this.onChannel(channel);
        this.app.emit("channels");
        break;
      case "unadvertise":
        for (const { id, channel } of [...this.byTopic.values()].filter(({ id }) => message.channelIds.includes(id))) {
          this.byTopic.delete(channel.topic);
          this.subscribed.delete(id);
        }
        this.app.emit("channels");
        break;
      case "connectionGraphUpdate":
        this.links.update(message);
        break;
      default:
        this.hands.onText(message);
    }
  }

  private setReadOnly(why: string): void {
    this.hands.setReadOnly(why);
    this.app.emit("status");
    this.app.emit("source");
  }

  private setCommander(why: string): void {
    this.hands.setCommander(why);
    this.app.emit("status");
  }

  private onChannel(advertised: AdvertisedChannel): void {
    if (advertised.encoding !== "cdr") return;
    const { id, topic, schemaName, schema } = advertised;
    const latched = advertised.metadata?.latched === "true" || topic.endsWith("/tf_static");
    const old = this.byTopic.get(topic);
    if (old && old.id !== id && this.subscribed.delete(old.id)) this.send({ op: "unsubscribe", subscriptionIds: [old.id] });
    this.byTopic.set(topic, { id, channel: { topic, type: schemaName, schema, latched } });
    if (this.wanted.has(topic)) this.subscribe(topic);
  }

  private subscribe(topic: string): void {
    const found = this.byTopic.get(topic);
    if (!found || this.subscribed.has(found.id)) return;
    this.subscribed.set(found.id, found.channel);
    this.send({ op: "subscribe", subscriptions: [{ id: found.id, channelId: found.id }] });
  }

  private onBinary(message: BinaryMessage | undefined): void {
    switch (message?.op) {
      case "time":
        this.timeline.setClock(message.time);
        break;
      case "message": {
        const channel = this.subscribed.get(message.subscription);
        if (!channel) return; // unsubscribed while it was under way
        this.timeline.add(channel, message.time, message.data);
        break;
      }
      case "serviceResponse":
        this.hands.onResponse(message);
        return;
      default:
        return;
    }
    this.app.emit("message");
  }

  private send(frame: object | Uint8Array): boolean {
    if (!this.isConnected) return false;
    this.socket!.send(frame instanceof Uint8Array ? (frame as Uint8Array<ArrayBuffer>) : JSON.stringify(frame));
    return true;
  }
}
