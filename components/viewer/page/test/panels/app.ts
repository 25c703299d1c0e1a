// An App for tests: messages by hand, and what was told to the robot.
import type { App, Hands, Message, Timeline } from "../../src/app";

export function timelineOf(messages: Message[], end: number, begin = 0): Timeline {
  return {
    begin,
    end,
    at: (topic, time) => messages.filter((each) => each.topic === topic && each.time <= time).at(-1) as any,
    between: (topic, from, to) => messages.filter((each) => each.topic === topic && each.time > from && each.time <= to) as any,
    transform: () => undefined,
    root: () => "map",
  };
}

export interface Told {
  published: [string, string, any][];
  called: [string, any][];
}

/** `answers` by service. */
export function handsOf(answers: Record<string, unknown> = {}): Hands & Told {
  const told: Told = { published: [], called: [] };
  return {
    ...told,
    canCommand: true,
    canStop: true,
    whyNot: "",
    async publish(topic, type, value) {
      told.published.push([topic, type, value]);
    },
    async call<Response>(service: string, request: object) {
      told.called.push([service, request]);
      if (!(service in answers)) throw new Error(`There is no service ${service}`);
      return answers[service] as Response;
    },
    services: () => Object.keys(answers).map((name) => ({ name, type: "" })),
  };
}

export function appOf(hands: Hands, robot = ""): App {
  return { hands, robot, robots: [robot], timeline: timelineOf([], 10), metadata: {}, statuses: [] } as unknown as App;
}
