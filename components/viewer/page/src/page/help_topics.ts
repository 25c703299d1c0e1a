// Topics of docs/help.txt, and which of them a link leads to.

export interface Topic {
  group: string;
  name: string;
  /** Below the project's root. */
  file: string;
  tells: string;
}

export function helpTopics(list: string): Topic[] {
  const topics: Topic[] = [];
  let group = "";
  for (const line of list.split("\n")) {
    if (!/^[A-Za-z]/.test(line)) continue;
    const heading = /^(.*):$/.exec(line);
    const [, name, file, tells] = /^(\S+) +(\S+) +(.+)$/.exec(line) ?? [];
    if (heading) group = heading[1]!;
    else if (name && file && tells) topics.push({ group, name, file, tells });
  }
  return topics;
}

/** The topic that `href` of the page `file` leads to; a folder stands for its README.md. */
export function topicOf(topics: readonly Topic[], file: string, href: string): string | undefined {
  if (/^[a-z]+:/.test(href)) return undefined;
  const there = new URL(href, `http://localhost/${file}`).pathname.slice(1).replace(/\/$/, "");
  return topics.find((topic) => topic.file === there || topic.file === `${there}/README.md`)?.name;
}
