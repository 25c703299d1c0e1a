// The page: its parts, and the robot whose server it came from.
import "./style/page.css";
import "./style/statuses.css";
import { mountBag } from "./bag/mount";
import { element } from "./page/dom";
import { mountHelp } from "./page/help";
import { PageApp } from "./page/page_app";
import { mountReadOnly } from "./page/read_only";
import { mountStatusLines } from "./page/status_lines";
import { mountStopButton } from "./page/stop_button";
import { mountTabs, type Tab } from "./page/tabs";
import { takeToken } from "./page/token";
import { mountToolbar } from "./page/toolbar";
import { exposeHook } from "./scene/hook";
import { SceneOnPage } from "./scene/scene";
import { mountStrip } from "./panels/strip";
import { mountHands } from "./panels/hands";
import { mountHealth } from "./panels/health";
import { LogRecorder } from "./panels/health/log_recorder";
import { mountParameters } from "./panels/parameters";
import { LiveSource } from "./source/live";

const app = new PageApp();
const log = new LogRecorder(app);
const TABS: Tab[] = [
  { name: "Drive", mount: mountHands },
  { name: "Parameters", mount: mountParameters },
  { name: "Health", mount: (root, app) => mountHealth(root, app, log) },
];

mountToolbar(app);
mountReadOnly(element("connection"), app);
mountStatusLines(element("statuses"), app);
mountStopButton(element("stop"), app);
if (location.protocol !== "file:") mountHelp(element("help"), element<HTMLButtonElement>("help-toggle"));
exposeHook(app, new SceneOnPage(element("scene"), app));
mountTabs(app, TABS);

mountStrip(element("strip"), app);

const scheme = location.protocol === "https:" ? "wss" : "ws";
if (!mountBag(app)) app.open(new LiveSource(`${scheme}://${location.host}`, app, takeToken(location, history, sessionStorage)));
