// The run's token, which commands need: out of the address that the program printed, into this tab's memory.

const KEY = "token";

/** Takes `?token=` away from the address, so that neither the address bar nor the history keeps it. Later loads of the tab know it still. */
export function takeToken(location: Location, history: History, memory: Storage): string | undefined {
  const address = new URL(location.href);
  const given = address.searchParams.get(KEY);
  if (given !== null) {
    memory.setItem(KEY, given);
    address.searchParams.delete(KEY);
    history.replaceState(history.state, "", address);
  }
  return memory.getItem(KEY) ?? undefined;
}
