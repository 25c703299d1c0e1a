// How a bag comes onto the page: dropped on it, chosen by a button, named in the address, or written into the page.
import type { App } from "../app";
import { element, make } from "../page/dom";
import { openBag } from "./bag_source";
import { bytesInMemory, bytesOfFile, bytesOfServer, type FileBytes } from "./file_bytes";
import "./mount.css";

const MOST_LISTED = 50;

/** True where the page is made for a bag: it shows no robot then. */
export function mountBag(app: App): boolean {
  let asked = 0;
  const open = async (files: () => FileBytes[] | Promise<FileBytes[]>) => {
    const mine = ++asked;
    try {
      const source = await openBag(await files(), {
        changed: () => app.emit("message"),
        say: (level, text) => app.say(level, text),
      });
      if (mine === asked) app.open(source);
      else source.close(); // another one was asked for meanwhile
    } catch (error) {
      app.say("error", (error as Error).message);
    }
  };
  const openFiles = (files: Iterable<File>) =>
    void open(() => [...files].filter((file) => !/\.ya?ml$/.test(file.name)).map(bytesOfFile));
  const openServed = (name: string) =>
    void open(async () => [await bytesOfServer(name, `/bags/${name.split("/").map(encodeURIComponent).join("/")}`)]);

  addButton(openFiles);
  addDrop(openFiles);
  const inlined = document.getElementById("bag");
  if (inlined) {
    document.title = `${inlined.dataset["name"] ?? "drive"} - Bandwagon`;
    void open(() => [bytesInMemory(inlined.dataset["name"] ?? "drive.mcap", fromBase64(inlined.textContent ?? ""))]);
    return true;
  }
  addWayBack(app);
  void addList(openServed);
  const name = new URLSearchParams(location.search).get("bag");
  if (name !== null) openServed(name);
  return name !== null;
}

function fromBase64(text: string): Uint8Array {
  const raw = atob(text.trim());
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

function addButton(open: (files: FileList) => void): void {
  const input = make("input", { type: "file", accept: ".mcap,.db3", multiple: true, hidden: true });
  input.dataset["test"] = "bag-file";
  input.onchange = () => {
    if (input.files?.length) open(input.files);
    input.value = ""; // the same file again is a change as well
  };
  const button = make("button", { textContent: "Open bag", title: "Plays an MCAP file; or drop one on the page" });
  button.dataset["test"] = "bag-open";
  button.onclick = () => input.click();
  element("tools").append(button, input);
}

/** To the robot whose server the page came from. */
function addWayBack(app: App): void {
  const back = make("button", { textContent: "Back to live", title: "Leaves the bag", hidden: true });
  back.dataset["test"] = "bag-leave";
  back.onclick = () => location.assign(location.pathname);
  element("tools").prepend(back);
  app.on("source", () => (back.hidden = app.source?.kind !== "bag"));
}

function addDrop(open: (files: FileList) => void): void {
  const veil = make("div", { id: "drop-veil", hidden: true }, make("span", { textContent: "Drop the bag to play it" }));
  document.body.append(veil);
  const isFile = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  addEventListener("dragover", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    veil.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) veil.hidden = true;
  });
  addEventListener("drop", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    veil.hidden = true;
    if (event.dataTransfer?.files.length) open(event.dataTransfer.files);
  });
}

interface Served {
  path: string;
  size: number;
  modified: number | string;
}

/** What the server has in its folder; nothing where it serves none. */
async function addList(open: (name: string) => void): Promise<void> {
  const bags = await fetch("/bags/")
    .then((response) => (response.ok ? (response.json() as Promise<Served[]>) : []))
    .catch(() => []);
  const shown = bags.filter((bag) => bag.path.endsWith(".mcap"));
  if (shown.length === 0) return;
  const newest = shown.sort((a, b) => (a.modified < b.modified ? 1 : -1)).slice(0, MOST_LISTED);
  const label = (bag: Served) => `${bag.path} (${(bag.size / 1e6).toFixed(1)} MB)`;
  const list = make(
    "select",
    { title: "Bags in the folder that is served" },
    new Option("Recorded drives", "", true),
    ...newest.map((bag) => new Option(label(bag), bag.path)),
  );
  list.dataset["test"] = "bag-list";
  list.onchange = () => {
    if (list.value) open(list.value);
  };
  element("tools").prepend(list);
}
