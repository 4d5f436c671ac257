import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Connection, type Handlers, pauseBefore } from "./connection";
import type { FrameSocket } from "./workerSocket";

/** A socket whose other end is the test. */
class FakeLine implements FrameSocket {
  static opened: FakeLine[] = [];
  open = true;
  sent: string[] = [];
  ontext: FrameSocket["ontext"] = null;
  onframe: FrameSocket["onframe"] = null;
  onclose: FrameSocket["onclose"] = null;

  constructor(
    readonly url: string,
    readonly protocol: string,
  ) {
    FakeLine.opened.push(this);
  }

  send(text: string): void {
    this.sent.push(text);
  }

  close(): void {
    this.open = false;
  }

  says(value: object): void {
    this.ontext?.(JSON.stringify(value));
  }

  drops(code = 1006): void {
    this.onclose?.(code, "");
  }
}

const handlers = { link: vi.fn(), message: vi.fn(), frame: vi.fn(), failed: vi.fn() } satisfies Handlers;

function connected(): { connection: Connection; line: FakeLine } {
  const connection = new Connection(handlers, (url, protocol) => new FakeLine(url, protocol));
  connection.connect("main", () => "pose");
  return { connection, line: FakeLine.opened[0]! };
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.clearAllMocks();
  vi.stubGlobal("document", { baseURI: "https://example.test/view/" });
  FakeLine.opened = [];
});
afterEach(() => vi.useRealTimers());

describe("Connection", () => {
  it("asks for the stage's stream with the subprotocol, relative to the page", () => {
    const { line } = connected();
    expect([line.url, line.protocol]).toEqual([
      "wss://example.test/view/api/stages/main/stream?frames=pose",
      "statwalk.v1",
    ]);
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
    expect(FakeLine.opened).toHaveLength(1);
  });

  it("gives up when it is turned away, until it is told to retry", () => {
    const { connection, line } = connected();
    line.drops();
    connection.refuse("no token");
    vi.runAllTimers();
    expect(handlers.link).toHaveBeenLastCalledWith("refused", "no token");
    expect(FakeLine.opened).toHaveLength(1);
    connection.retryNow();
    expect(FakeLine.opened).toHaveLength(2);
  });

  it("sends nothing while the line is not open", () => {
    const { connection, line } = connected();
    line.open = false;
    expect([connection.send({ type: "live" }), line.sent]).toEqual([false, []]);
  });

  it("comes back after a loss", () => {
    const { line } = connected();
    line.drops();
    vi.advanceTimersByTime(pauseBefore(0));
    expect(FakeLine.opened).toHaveLength(2);
  });

  it("comes back with the kind of frames that was chosen meanwhile", () => {
    let kind: "pose" | "glb" = "pose";
    const { connection } = connected();
    connection.connect("main", () => kind);
    kind = "glb";
    FakeLine.opened.at(-1)!.drops();
    vi.advanceTimersByTime(pauseBefore(0));
    expect(FakeLine.opened.at(-1)!.url).toMatch(/frames=glb$/);
  });

  it("asks whether the stage is there when nothing was said", () => {
    connected().line.drops();
    expect(handlers.failed).toHaveBeenCalledOnce();
  });

  it("ignores a line it has left", () => {
    const { connection, line } = connected();
    connection.connect("other", () => "pose");
    line.says({ type: "status" });
    expect(handlers.message).not.toHaveBeenCalled();
  });

  it("waits longer each time, but never longer than five seconds", () => {
    expect([0, 1, 2, 10].map(pauseBefore)).toEqual([250, 500, 1000, 5000]);
  });
});
