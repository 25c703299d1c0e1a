// In simulation: somebody who walks where the drag says, and a push for one who is there.
import { Wants } from "../../page/wants";
import { serviceOfType, expectSuccess, type HandsContext } from "./context";
import { DragToolButton } from "./drag_tool";
import { nearest, velocityOfDrag, type Point } from "./poses";

const ADD_PERSON = "bandwagon_msgs/srv/AddPerson";
const PUSH_PERSON = "bandwagon_msgs/srv/PushPerson";

interface Truth {
  people: { id: number; position: Point }[];
}

interface Answer {
  success: boolean;
  message: string;
}

/** Buttons for what the world offers; hidden where there is none, as on a real robot. */
export class PeopleTools {
  readonly add: DragToolButton;
  readonly push: DragToolButton;
  private readonly wants: Wants;

  constructor(
    private readonly context: HandsContext,
    changed: () => void,
  ) {
    this.wants = new Wants(context.app);
    this.add = new DragToolButton(
      context.app,
      {
        label: "Add person",
        hint: "Press where they start and drag the way they walk: 1 m is 1 m/s; a click stands",
        test: "person",
        onRelease: (from, to) => void this.addPerson(from, to),
      },
      changed,
    );
    this.push = new DragToolButton(
      context.app,
      {
        label: "Push person",
        hint: "Press on somebody and drag the way they are pushed: 1 m is 1 m/s",
        test: "push",
        onTaken: () => this.wants.set([this.truth()]),
        onPut: () => this.wants.set([]),
        onRelease: (from, to) => void this.pushPerson(from, to),
      },
      changed,
    );
  }

  update(): void {
    const { app } = this.context;
    this.add.button.hidden = serviceOfType(app, ADD_PERSON) === undefined;
    this.push.button.hidden = serviceOfType(app, PUSH_PERSON) === undefined;
    this.add.update();
    this.push.update();
  }

  private addPerson(from: Point, to: Point): Promise<boolean> {
    const request = { position: { ...from, z: 0 }, velocity: velocityOfDrag(from, to) };
    return this.context.run("Person", () => this.ask(ADD_PERSON, request));
  }

  private async pushPerson(from: Point, to: Point): Promise<void> {
    const { app } = this.context;
    const truth = app.timeline.at<Truth>(this.truth(), app.timeline.end);
    const person = nearest(truth?.value.people ?? [], from);
    if (person === undefined) return this.context.say("Nobody is there to be pushed: press on a person", true);
    const request = { id: person.id, velocity_change: velocityOfDrag(from, to) };
    await this.context.run(`Push of person ${person.id}`, () => this.ask(PUSH_PERSON, request));
  }

  private async ask(type: string, request: object): Promise<void> {
    const { app } = this.context;
    const service = serviceOfType(app, type);
    if (service === undefined) throw new Error("the simulated world is not there any more");
    expectSuccess(await app.hands.call<Answer>(service, request));
  }

  private truth(): string {
    return `${this.context.app.robot}/sim/ground_truth`;
  }
}
