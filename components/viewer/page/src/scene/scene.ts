// The scene: what the robot sees, knows and wants, drawn on the ground. Draws when something changed and not otherwise.
import "./scene.css";
import { Color, Group, LinearSRGBColorSpace, Scene, WebGLRenderer } from "three";
import type { App } from "../app";
import { make } from "../page/dom";
import { Wants } from "../page/wants";
import { FIELD_OF_VIEW, TILTED, Viewpoint } from "./camera";
import { SHARED } from "./gl/instances";
import type { Layer } from "./layer";
import { LayerList } from "./layer_list";
import { makeLayers, type Layers } from "./layers/all";
import { Ground } from "./layers/ground";
import { ToolOverlay } from "./layers/tool";
import { paletteFor, toHex } from "./palette";
import { handlePointers } from "./pointer";
import { askRadius } from "./radius";
import { SceneView } from "./view";
import { ViewButtons, type Mode } from "./view_buttons";

const LIFT = 0.8; // [m/s] of time shown upward
const LEGEND_WIDTH = 300; // [px] that a fitted map leaves free
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software/i;
const SOFTWARE_INTERVAL = 30; // [ms] at least between two pictures that the processor has to draw
const AROUND = 12; // [m] about the robot where there is no map

export class SceneOnPage {
  readonly layers: Layers;
  readonly viewpoint = new Viewpoint();
  readonly view: SceneView;
  readonly isOn = new Map<string, boolean>();
  frames = 0;

  private readonly renderer = new WebGLRenderer({ antialias: false, alpha: false, powerPreference: "high-performance" });
  private readonly scene = new Scene();
  private readonly ground = new Ground();
  private readonly switches = new Map<Layer, Group>();
  private readonly tool = new ToolOverlay();
  private readonly wants: Wants;
  private readonly list: LayerList;
  private readonly buttons: ViewButtons;
  private readonly scaleBar = make("div", { className: "scale" });
  private readonly hint = make("div", { className: "hint", hidden: true });
  private readonly darkness = matchMedia("(prefers-color-scheme: dark)");
  private mode: Mode = "top";
  private isFollowing = false;
  private isFitted = false;
  private isDue = false;
  private lastTurn: number | undefined;
  private lastDrawn = 0;
  /** The view, the tool or the colours have changed, whatever the messages say. */
  private isStale = true;
  private isSoftware = false;

  constructor(private readonly root: HTMLElement, private readonly app: App) {
    this.layers = makeLayers(app);
    this.view = new SceneView(app, paletteFor(this.darkness.matches));
    this.wants = new Wants(app);
    for (const layer of this.all) this.isOn.set(layer.id, layer.isOnAtStart);
    this.list = new LayerList(this.all, (layer) => this.isOn.get(layer.id)!, (layer, isOn) => this.switch(layer, isOn));
    this.buttons = new ViewButtons((mode) => this.look(mode), () => this.follow(!this.isFollowing), () => this.fit());
    this.build();
    this.listen();
  }

  private get all(): Layer[] {
    return Object.values(this.layers);
  }

  private build(): void {
    this.renderer.outputColorSpace = LinearSRGBColorSpace; // colours are given as the screen takes them
    for (const layer of this.all) this.switches.set(layer, new Group().add(layer.object));
    this.scene.add(this.ground.mesh, ...this.switches.values(), this.tool.object);
    const context = this.renderer.getContext();
    const info = context.getExtension("WEBGL_debug_renderer_info");
    this.isSoftware = SOFTWARE.test(String(context.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER)));
    const { domElement } = this.renderer;
    domElement.tabIndex = 0;
    this.root.prepend(domElement, this.list.root, this.buttons.root, this.scaleBar, this.hint);
    this.buttons.update(this.mode, this.isFollowing);
  }

  private listen(): void {
    const { app } = this;
    app.on("message", () => this.askForFrame());
    app.on("cursor", () => this.invalidate());
    for (const event of ["source", "channels", "robot"] as const) app.on(event, () => this.onChannels());
    app.on("source", () => (this.isFitted = this.isFitted && app.source?.kind === "live"));
    app.on("services", () => void askRadius(app, (robot, radius) => this.layers.robot.setRadius(robot, radius)));
    this.darkness.addEventListener("change", () => {
      this.view.palette = paletteFor(this.darkness.matches);
      this.showLegend();
      this.invalidate();
    });
    new ResizeObserver(() => this.resize()).observe(this.root);
    handlePointers(this.renderer.domElement, this.viewpoint, app, {
      onMoved: (hasPanned) => {
        if (hasPanned) this.follow(false);
        this.isFitted = true;
        this.invalidate();
      },
      onDrag: (drag) => {
        this.tool.drag = drag;
        this.invalidate();
      },
    });
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.root;
    const ratio = Math.min(window.devicePixelRatio, 2);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    SHARED.viewport!.value = [clientWidth * ratio, clientHeight * ratio];
    SHARED.pixelRatio!.value = ratio;
    this.viewpoint.setSize(clientWidth, clientHeight);
    this.invalidate();
  }

  private onChannels(): void {
    this.view.forgetTopics();
    const topics = new Set(this.view.transformTopics());
    for (const { id, wants } of this.all)
      for (const wanted of wants) {
        const topic = this.view.topic(...wanted);
        if (topic !== undefined && this.isOn.get(id)) topics.add(topic);
      }
    this.wants.set(topics);
    this.showLegend();
    this.invalidate();
  }

  private showLegend(): void {
    const isThere = ({ wants }: Layer) => wants.length === 0 || wants.some((wanted) => this.view.topic(...wanted) !== undefined);
    this.list.update(this.view.palette, (layer) => layer.id === "robot" || isThere(layer));
  }

  switch(layer: Layer, isOn: boolean): void {
    this.isOn.set(layer.id, isOn);
    this.onChannels();
  }

  look(mode: Mode): void {
    this.mode = mode;
    this.viewpoint.lookFrom(mode === "top" ? 0 : TILTED);
    this.view.lift = mode === "time" ? LIFT : 0;
    this.buttons.update(mode, this.isFollowing);
    this.invalidate();
  }

  follow(isFollowing: boolean): void {
    if (isFollowing === this.isFollowing) return;
    this.isFollowing = isFollowing;
    this.buttons.update(this.mode, isFollowing);
    this.invalidate();
  }

  fit(): void {
    this.follow(false);
    this.isFitted = false;
    this.invalidate();
  }

  /** The map fills the view; without one, what is around the robot. */
  private fitNow(): void {
    const { map, robot } = this.layers;
    const { bounds } = map;
    const isLegendOpen = this.list.root.open && this.root.clientWidth > 2 * LEGEND_WIDTH;
    const margin = isLegendOpen ? LEGEND_WIDTH : 0;
    if (bounds && map.object.visible) {
      const { x, y } = map.object.position;
      this.viewpoint.fit(bounds.x0 + x, bounds.y0 + y, bounds.x1 + x, bounds.y1 + y, margin);
      this.isFitted = true;
    } else if (robot.pose) {
      const { x, y } = robot.pose;
      this.viewpoint.fit(x - AROUND, y - AROUND / 2, x + AROUND, y + AROUND / 2, margin);
    }
  }

  invalidate(): void {
    this.isStale = true;
    this.askForFrame();
  }

  private askForFrame(): void {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame((now) => this.draw(now));
  }

  private draw(now: number): void {
    this.isDue = false;
    if (this.root.clientWidth === 0) return;
    if (this.isSoftware && now - this.lastDrawn < SOFTWARE_INTERVAL) {
      this.askForFrame();
      return;
    }
    this.view.look();
    if (!this.updateLayers() && !this.isStale) return;
    this.isStale = false;
    this.lastDrawn = now;
    this.tool.update(this.app.tool, this.view.palette);
    this.aim(now);
    this.dress();
    this.renderer.render(this.scene, this.viewpoint.camera);
    ++this.frames;
  }

  private updateLayers(): boolean {
    let hasChanged = false;
    for (const [layer, group] of this.switches) {
      group.visible = this.isOn.get(layer.id)!;
      if (group.visible) hasChanged = layer.update(this.view) || hasChanged;
    }
    return hasChanged;
  }

  private aim(now: number): void {
    if (!this.isFitted && !this.isFollowing) this.fitNow();
    const { pose } = this.layers.robot;
    if (this.isFollowing && pose) this.viewpoint.target = { x: pose.x, y: pose.y };
    const isTurning = this.viewpoint.turn(this.lastTurn === undefined ? 1 / 60 : (now - this.lastTurn) / 1000);
    this.lastTurn = isTurning ? now : undefined;
    if (isTurning) this.invalidate();
    this.viewpoint.update();
    SHARED.upright!.value = Math.min(1, this.viewpoint.tilt / TILTED);
  }

  /** What depends on where the scene is seen from: ground, scale, hint. */
  private dress(): void {
    const { viewpoint, root } = this;
    const { palette } = this.view;
    const metresPerPixel = (2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * viewpoint.distance) / Math.max(root.clientHeight, 1);
    const tilt = 1 + 2 * Math.sin(viewpoint.tilt);
    const reach = Math.max(root.clientWidth, root.clientHeight) * metresPerPixel * tilt;
    const step = this.ground.update(viewpoint.target, metresPerPixel, reach, palette);
    const [r, g, b] = palette.ground;
    this.renderer.setClearColor(new Color(r, g, b));
    const length = step * 2;
    this.scaleBar.textContent = length >= 1 ? `${length} m` : `${Math.round(length * 100)} cm`;
    this.scaleBar.style.width = `${length / metresPerPixel}px`;
    const { tool } = this.app;
    this.renderer.domElement.classList.toggle("tool", tool !== undefined);
    this.hint.hidden = tool === undefined;
    if (!tool) return;
    this.hint.textContent = `${tool.name}: drag on the ground, Esc ends`;
    this.hint.style.background = toHex(palette.goal);
  }
}
