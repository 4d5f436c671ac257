import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Connection, type Handlers, pauseBefore } from "./connection";

/** A socket whose other end is the test. */
class Line {
  static opened: Line[] = [];
  readyState = 1;
  binaryType = "";
  sent: string[] = [];
  onmessage: ((event: { data: string | ArrayBuffer }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;

  constructor(
    readonly url: string,
    readonly protocol: string,
  ) {
    Line.opened.push(this);
  }

  send(text: string): void {
    this.sent.push(text);
  }

  close(): void {
    this.readyState = 3;
  }

  says(value: object): void {
    this.onmessage?.({ data: JSON.stringify(value) });
  }

  drops(code = 1006): void {
    this.onclose?.({ code, reason: "" });
  }
}

const handlers = { link: vi.fn(), message: vi.fn(), frame: vi.fn(() => 5), failed: vi.fn() } satisfies Handlers;

function connected(): { connection: Connection; line: Line } {
  const connection = new Connection(handlers, (url, protocol) => new Line(url, protocol) as unknown as WebSocket);
  connection.connect("main", "pose");
  return { connection, line: Line.opened[0]! };
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.clearAllMocks();
  vi.stubGlobal("document", { baseURI: "https://example.test/view/" });
  vi.stubGlobal("WebSocket", { OPEN: 1 });
  Line.opened = [];
});
afterEach(() => vi.useRealTimers());

describe("Connection", () => {
  it("asks for the stage's stream with the subprotocol, relative to the page", () => {
    const { line } = connected();
    expect([line.url, line.protocol]).toEqual(["wss://example.test/view/api/stages/main/stream?frames=pose", "statwalk.v1"]);
  });

  it("is live after a hello of its version", () => {
    const { line } = connected();
    line.says({ type: "hello", version: "statwalk.v1" });
    expect(handlers.link).toHaveBeenLastCalledWith("live", "live");
  });

  it("refuses another version and does not come back", () => {
    const { line } = connected();
    line.says({ type: "hello", version: "statwalk.v9" });
    vi.runAllTimers();
    expect(handlers.link.mock.lastCall?.[0]).toBe("refused");
    expect(Line.opened).toHaveLength(1);
  });

  it("acknowledges every frame with its tick", () => {
    const { line } = connected();
    line.onmessage?.({ data: new ArrayBuffer(4) });
    expect(JSON.parse(line.sent[0]!)).toEqual({ type: "ack", tick: 5 });
  });

  it("comes back after a loss", () => {
    const { line } = connected();
    line.drops();
    vi.advanceTimersByTime(pauseBefore(0));
    expect(Line.opened).toHaveLength(2);
  });

  it("asks whether the stage is there when nothing was said", () => {
    connected().line.drops();
    expect(handlers.failed).toHaveBeenCalledOnce();
  });

  it("ignores a line it has left", () => {
    const { connection, line } = connected();
    connection.connect("other", "pose");
    line.says({ type: "status" });
    expect(handlers.message).not.toHaveBeenCalled();
  });

  it("waits longer each time, but never longer than five seconds", () => {
    expect([0, 1, 2, 10].map(pauseBefore)).toEqual([250, 500, 1000, 5000]);
  });
});
