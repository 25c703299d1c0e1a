// The page: its parts, and the robot whose server it came from.
import "./style/page.css";
import "./style/statuses.css";
import { element } from "./page/dom";
import { PageApp } from "./page/page_app";
import { mountStatusLines } from "./page/status_lines";
import { mountTabs, type Tab } from "./page/tabs";
import { mountToolbar } from "./page/toolbar";
import { exposeHook } from "./scene/hook";
import { SceneOnPage } from "./scene/scene";
import { LiveSource } from "./source/live";

const TABS: Tab[] = [];

const app = new PageApp();
mountToolbar(app);
mountStatusLines(element("statuses"), app);
exposeHook(app, new SceneOnPage(element("scene"), app));
mountTabs(app, TABS);

const scheme = location.protocol === "https:" ? "wss" : "ws";
app.open(new LiveSource(`${scheme}://${location.host}`, app));
