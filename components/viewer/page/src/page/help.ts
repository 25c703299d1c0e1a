// The project's pages over the scene: those that `bandwagon help` prints, served as they were when the program was built.
import "../style/help.css";
import { Marked, type Tokens } from "marked";
import { make } from "./dom";
import { helpTopics, topicOf, type Topic } from "./help_topics";

export function mountHelp(root: HTMLElement, toggle: HTMLButtonElement): void {
  const help = new Help(root);
  toggle.hidden = false;
  toggle.onclick = () => {
    root.hidden = !root.hidden;
    toggle.setAttribute("aria-expanded", String(!root.hidden));
    if (!root.hidden) void help.open();
  };
}

class Help {
  private topics: Topic[] = [];
  private readonly list = make("nav", {});
  private readonly text = make("article", { tabIndex: 0 });

  constructor(root: HTMLElement) {
    this.text.dataset.test = "help-text";
    root.append(this.list, this.text);
    this.text.onclick = (event) => {
      const link = (event.target as HTMLElement).closest<HTMLAnchorElement>("a[data-topic]");
      if (link) void this.show(link.dataset.topic!);
    };
  }

  async open(): Promise<void> {
    if (this.topics.length) return;
    try {
      this.topics = helpTopics(await fetched("list"));
    } catch (error) {
      this.text.textContent = String(error);
      return;
    }
    let group = "";
    for (const topic of this.topics) {
      if (topic.group !== group) this.list.append(make("h2", { textContent: topic.group }));
      group = topic.group;
      const button = make("button", { type: "button", textContent: topic.name, title: topic.tells, onclick: () => void this.show(topic.name) });
      button.dataset.topic = topic.name;
      this.list.append(button);
    }
    await this.show(this.topics[0]!.name);
  }

  private async show(name: string): Promise<void> {
    for (const button of this.list.querySelectorAll("button")) button.setAttribute("aria-pressed", String(button.dataset.topic === name));
    const { file } = this.topics.find((topic) => topic.name === name)!;
    const { topics } = this;
    const marked = new Marked({
      renderer: {
        // The program carries no pictures, and a link leads to another topic or nowhere.
        image: ({ text }: Tokens.Image) => `<em>${text}</em>`,
        link({ href, tokens }: Tokens.Link) {
          const words = this.parser.parseInline(tokens);
          const topic = topicOf(topics, file, href);
          return topic === undefined ? words : `<a href="#" data-topic="${topic}">${words}</a>`;
        },
      },
    });
    try {
      this.text.innerHTML = await marked.parse(await fetched(name));
    } catch (error) {
      this.text.textContent = String(error);
    }
    this.text.scrollTop = 0;
  }
}

async function fetched(name: string): Promise<string> {
  const reply = await fetch(`/help/${name}`);
  if (!reply.ok) throw new Error(`The robot has no page ${name} (${reply.status})`);
  return reply.text();
}
