// Where the bytes of a bag come from: a file of this computer, one that the server hands out in parts, or the page itself.

export interface FileBytes {
  readonly name: string;
  readonly size: number;
  /** Exactly these bytes; fails with a sentence when they cannot be had. */
  read(offset: number, length: number): Promise<Uint8Array>;
}

/** No more than this is asked for at once, whatever a file claims of its parts. */
export const LARGEST_READ = 256 * 2 ** 20;

function check(file: { name: string; size: number }, offset: number, length: number): void {
  if (length > LARGEST_READ)
    throw new Error(`${file.name}: claims a part of ${length} bytes at byte ${offset}, more than ${LARGEST_READ}`);
  if (offset < 0 || length < 0 || offset + length > file.size)
    throw new Error(`${file.name}: ends at byte ${file.size}, but ${length} bytes at byte ${offset} should be there`);
}

export function bytesOfFile(file: File): FileBytes {
  return {
    name: file.name,
    size: file.size,
    async read(offset, length) {
      check(file, offset, length);
      return new Uint8Array(await file.slice(offset, offset + length).arrayBuffer());
    },
  };
}

export function bytesInMemory(name: string, bytes: Uint8Array): FileBytes {
  return {
    name,
    size: bytes.byteLength,
    async read(offset, length) {
      check({ name, size: bytes.byteLength }, offset, length);
      return bytes.subarray(offset, offset + length);
    },
  };
}

type Fetch = (url: string, init: { headers: Record<string, string> }) => Promise<Response>;

/** A file that the server hands out by Range requests. */
export async function bytesOfServer(name: string, url: string, get: Fetch = (u, i) => fetch(u, i)): Promise<FileBytes> {
  const range = (offset: number, length: number) => ({ headers: { Range: `bytes=${offset}-${offset + length - 1}` } });
  const first = await get(url, range(0, 1));
  if (!first.ok) {
    const reason = first.status === 404 ? "there is no such bag in the folder that is served" : (await first.text()).slice(0, 200);
    throw new Error(`${name}: ${reason || `HTTP ${first.status}`}`);
  }
  const size = Number(/\/(\d+)$/.exec(first.headers.get("Content-Range") ?? "")?.[1] ?? NaN);
  if (first.status !== 206 || !Number.isSafeInteger(size)) throw new Error(`${name}: the server does not hand it out in parts`);
  return {
    name,
    size,
    async read(offset, length) {
      check({ name, size }, offset, length);
      if (length === 0) return new Uint8Array(0);
      const response = await get(url, range(offset, length));
      const bytes = new Uint8Array(await response.arrayBuffer());
      if (response.status !== 206 || bytes.byteLength !== length)
        throw new Error(`${name}: HTTP ${response.status} with ${bytes.byteLength} bytes for ${length} bytes at byte ${offset}`);
      return bytes;
    },
  };
}
