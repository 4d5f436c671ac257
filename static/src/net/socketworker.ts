/** A worker that owns the socket: while the page draws, frames are still taken and acknowledged in time. */

import type { FromWorker, ToWorker } from "./workersocket";
import { Relay } from "./relay";

let socket: WebSocket | null = null;

const post = (message: FromWorker, transfer: Transferable[] = []): void => self.postMessage(message, { transfer });

const relay = new Relay(
  (tick) => socket?.readyState === WebSocket.OPEN && socket.send(JSON.stringify({ type: "ack", tick })),
  (handed) => post({ kind: "frame", ...handed }, [handed.frame]),
);

function open(url: string, protocol: string): void {
  socket = new WebSocket(url, protocol);
  socket.binaryType = "arraybuffer";
  socket.onopen = () => post({ kind: "open" });
  socket.onclose = ({ code, reason }) => post({ kind: "close", code, reason });
  socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => (typeof data === "string" ? post({ kind: "text", text: data }) : relay.receive(data));
}

function close(): void {
  if (!socket || socket.readyState === WebSocket.CLOSED) return self.close();
  socket.onmessage = null;
  socket.onclose = () => self.close();
  socket.close();
}

self.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === "open") open(data.url, data.protocol);
  else if (data.kind === "send") socket?.send(data.text);
  else if (data.kind === "taken") relay.taken();
  else close();
};
