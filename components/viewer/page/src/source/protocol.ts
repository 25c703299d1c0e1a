// The Foxglove WebSocket protocol as bytes and objects: https://github.com/foxglove/ws-protocol/blob/main/docs/spec.md
// Pure: no sockets here.

export const SUBPROTOCOLS = ["foxglove.sdk.v1", "foxglove.websocket.v1"];

export interface AdvertisedChannel {
  id: number;
  topic: string;
  encoding: string;
  schemaName: string;
  schema: string;
  /** Of this project's server: "latched" where the newest message is given to each new subscription. */
  metadata?: Record<string, string>;
}

interface AdvertisedSchema {
  schema: string;
}

export interface AdvertisedService {
  id: number;
  name: string;
  type: string;
  request?: AdvertisedSchema;
  response?: AdvertisedSchema;
  requestSchema?: string;
  responseSchema?: string;
}

export type TextMessage =
  | {
      op: "serverInfo";
      name: string;
      capabilities: string[];
      supportedEncodings?: string[];
      metadata?: Record<string, string>;
      sessionId?: string;
    }
  | { op: "status"; level: number; message: string; id?: string }
  | { op: "removeStatus"; statusIds: string[] }
  | { op: "advertise"; channels: AdvertisedChannel[] }
  | { op: "unadvertise"; channelIds: number[] }
  | { op: "advertiseServices"; services: AdvertisedService[] }
  | { op: "unadvertiseServices"; serviceIds: number[] }
  | { op: "serviceCallFailure"; serviceId: number; callId: number; message: string }
  | { op: "parameterValues"; parameters: { name: string; value?: unknown; type?: string }[]; id?: string }
  | ({ op: "connectionGraphUpdate" } & GraphUpdate);

export interface GraphUpdate {
  publishedTopics: { name: string; publisherIds: string[] }[];
  subscribedTopics: { name: string; subscriberIds: string[] }[];
  advertisedServices: { name: string; providerIds: string[] }[];
  removedTopics: string[];
  removedServices: string[];
}

export type BinaryMessage =
  | { op: "message"; subscription: number; time: number; data: Uint8Array }
  | { op: "time"; time: number }
  | { op: "serviceResponse"; service: number; call: number; encoding: string; data: Uint8Array };

/** Undefined for what this page has no use for; throws where bytes are missing. */
export function readBinary(buffer: ArrayBuffer): BinaryMessage | undefined {
  const view = new DataView(buffer);
  const seconds = (offset: number) => Number(view.getBigUint64(offset, true)) / 1e9;
  switch (view.getUint8(0)) {
    case 1:
      return { op: "message", subscription: view.getUint32(1, true), time: seconds(5), data: new Uint8Array(buffer, 13) };
    case 2:
      return { op: "time", time: seconds(1) };
    case 3: {
      const length = view.getUint32(9, true);
      const encoding = new TextDecoder().decode(new Uint8Array(buffer, 13, length));
      const data = new Uint8Array(buffer, 13 + length);
      return { op: "serviceResponse", service: view.getUint32(1, true), call: view.getUint32(5, true), encoding, data };
    }
  }
  return undefined;
}

export function writeMessage(channel: number, payload: Uint8Array): Uint8Array {
  const bytes = new Uint8Array(5 + payload.length);
  bytes[0] = 1;
  new DataView(bytes.buffer).setUint32(1, channel, true);
  bytes.set(payload, 5);
  return bytes;
}

export function writeServiceRequest(service: number, call: number, encoding: string, payload: Uint8Array): Uint8Array {
  const name = new TextEncoder().encode(encoding);
  const bytes = new Uint8Array(13 + name.length + payload.length);
  const view = new DataView(bytes.buffer);
  view.setUint8(0, 2);
  view.setUint32(1, service, true);
  view.setUint32(5, call, true);
  view.setUint32(9, name.length, true);
  bytes.set(name, 13);
  bytes.set(payload, 13 + name.length);
  return bytes;
}
