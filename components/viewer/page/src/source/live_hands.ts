// Commands over the socket: publishing, services, parameters by the protocol's own words.
import type { Hands } from "../app";
import { decode, encode } from "./decode";
import { writeMessage, writeServiceRequest, type AdvertisedService, type BinaryMessage, type TextMessage } from "./protocol";
import { knownSchema } from "./schemas";

const ANSWER_WITHIN = 10_000; // [ms]

interface Call {
  service: AdvertisedService;
  resolve(value: any): void;
  reject(reason: Error): void;
  timer: number;
}

export class LiveHands implements Hands {
  private isConnected = false;
  private capabilities: string[] = [];
  private encodings: string[] = [];
  private metadata: Record<string, string> = {};
  private commander = "";
  private readOnly = "";
  private readonly known = new Map<number, AdvertisedService>();
  private readonly calls = new Map<number, Call>();
  private readonly advertised = new Map<string, { id: number; type: string }>();
  private lastCall = 0;
  private lastChannel = 0;

  constructor(
    private readonly send: (frame: object | Uint8Array) => boolean,
    private readonly onServices: () => void,
    private readonly onParameters: () => void,
  ) {}

  get canCommand(): boolean {
    return this.whyNot === "";
  }

  get canStop(): boolean {
    return this.canCommand || this.whyNot === this.commander;
  }

  get whyNot(): string {
    if (!this.isConnected) return "No connection to the robot";
    if (this.metadata.clock === "lockstep" && this.metadata.accept_inputs !== "true") return "In lock-step the page commands only with --accept-inputs";
    if (this.metadata.may_command === "false" || !this.capabilities.includes("clientPublish")) return this.readOnly || "Read only: the server takes no commands from this page";
    return this.commander;
  }

  /** Why the server takes none of this page. */
  setReadOnly(why: string): void {
    this.readOnly = why;
  }

  /** Why another one's commands go before ours; empty when they do not. */
  setCommander(why: string): void {
    this.commander = why;
  }

  services(): { name: string; type: string }[] {
    return [...this.known.values()].map(({ name, type }) => ({ name, type }));
  }

  async publish(topic: string, type: string, value: object): Promise<void> {
    const isStop = this.canStop && topic.endsWith("/emergency_stop");
    if (!this.canCommand && !isStop) throw new Error(this.whyNot);
    const schema = this.encodings.includes("cdr") ? knownSchema(type) : undefined;
    const id = this.channelOf(topic, type, schema);
    const payload = schema === undefined ? new TextEncoder().encode(json(value)) : encode(schema, value);
    if (!this.send(writeMessage(id, payload))) throw new Error("No connection to the robot");
  }

  call<Response = any>(name: string, request: object): Promise<Response> {
    const service = [...this.known.values()].find((one) => one.name === name);
    if (!service) return Promise.reject(new Error(`There is no service ${name}`));
    const schema = service.request?.schema ?? service.requestSchema ?? "";
    return new Promise((resolve, reject) => {
      const id = ++this.lastCall;
      const timer = window.setTimeout(() => this.end(id)?.reject(new Error(`${name} did not answer within 10 s`)), ANSWER_WITHIN);
      this.calls.set(id, { service, resolve, reject, timer });
      const frame = writeServiceRequest(service.id, id, "cdr", encode(schema, request));
      if (!this.send(frame)) this.end(id)?.reject(new Error("No connection to the robot"));
    });
  }

  connect(capabilities: string[], encodings: string[], metadata: Record<string, string>): void {
    this.isConnected = true;
    this.metadata = metadata;
    this.commander = "";
    this.readOnly = "";
    this.capabilities = capabilities;
    this.encodings = encodings;
  }

  disconnect(): void {
    this.isConnected = false;
    this.known.clear();
    this.advertised.clear();
    for (const id of [...this.calls.keys()]) this.end(id)?.reject(new Error("The connection was lost"));
    this.onServices();
  }

  onText(message: TextMessage): void {
    switch (message.op) {
      case "advertiseServices":
        for (const service of message.services) this.known.set(service.id, service);
        this.onServices();
        break;
      case "unadvertiseServices":
        for (const id of message.serviceIds) this.known.delete(id);
        this.onServices();
        break;
      case "serviceCallFailure":
        this.end(message.callId)?.reject(new Error(message.message));
        break;
      case "parameterValues":
        this.onParameters();
        break;
    }
  }

  onResponse(message: Extract<BinaryMessage, { op: "serviceResponse" }>): void {
    const call = this.end(message.call);
    if (!call) return;
    try {
      const schema = call.service.response?.schema ?? call.service.responseSchema ?? "";
      const isJson = message.encoding === "json";
      call.resolve(isJson ? JSON.parse(new TextDecoder().decode(message.data)) : decode(schema, message.data));
    } catch (error) {
      call.reject(new Error(`The answer of ${call.service.name} cannot be read: ${error}`));
    }
  }

  private end(id: number): Call | undefined {
    const call = this.calls.get(id);
    this.calls.delete(id);
    if (call) clearTimeout(call.timer);
    return call;
  }

  private channelOf(topic: string, type: string, schema: string | undefined): number {
    const old = this.advertised.get(topic);
    if (old?.type === type) return old.id;
    if (old) this.send({ op: "unadvertise", channelIds: [old.id] });
    const id = ++this.lastChannel;
    this.advertised.set(topic, { id, type });
    const encoding = schema === undefined ? { encoding: "json" } : { encoding: "cdr", schema, schemaEncoding: "ros2msg" };
    this.send({ op: "advertise", channels: [{ id, topic, schemaName: type, ...encoding }] });
    return id;
  }
}

function json(value: object): string {
  return JSON.stringify(value, (_, field) => (typeof field === "bigint" ? Number(field) : field));
}
