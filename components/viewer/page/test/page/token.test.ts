import assert from "node:assert/strict";
import { test } from "node:test";
import { takeToken } from "../../src/page/token";

function tab(href: string) {
  const kept = new Map<string, string>();
  const shown: string[] = [];
  const memory = { setItem: (key: string, value: string) => void kept.set(key, value), getItem: (key: string) => kept.get(key) ?? null };
  const history = { state: null, replaceState: (_: unknown, __: string, url: URL) => void shown.push(url.href) };
  return { take: (at = href) => takeToken({ href: at } as Location, history as unknown as History, memory as unknown as Storage), shown };
}

test("the token leaves the address bar, and the tab remembers it", () => {
  const { take, shown } = tab("http://127.0.0.1:8765/?bag=a.mcap&token=ab%2Bc#x");
  assert.equal(take(), "ab+c");
  assert.deepEqual(shown, ["http://127.0.0.1:8765/?bag=a.mcap#x"]);
  assert.equal(take("http://127.0.0.1:8765/"), "ab+c");
  assert.equal(shown.length, 1);
  assert.equal(take("http://127.0.0.1:8765/?token=new"), "new"); // of another run
});

test("without a token there is none", () => {
  const { take, shown } = tab("http://127.0.0.1:8765/");
  assert.equal(take(), undefined);
  assert.deepEqual(shown, []);
});
