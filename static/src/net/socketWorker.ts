/** Owns the socket in a worker, so that frames are acknowledged in time while the page draws. */

import { Relay } from "./relay";
import type { FromWorker, ToWorker } from "./workerMessages";

let socket: WebSocket | null = null;

const post = (message: FromWorker, transfer: Transferable[] = []): void =>
  self.postMessage(message, { transfer });

const relay = new Relay(
  (tick) => socket?.readyState === WebSocket.OPEN && socket.send(JSON.stringify({ type: "ack", tick })),
  (delivery) => post({ kind: "frame", ...delivery }, [delivery.frame]),
);

function open(url: string, protocol: string): void {
  socket = new WebSocket(url, protocol);
  socket.binaryType = "arraybuffer";
  socket.onopen = () => post({ kind: "open" });
  socket.onclose = ({ code, reason }) => post({ kind: "close", code, reason });
  socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) =>
    typeof data === "string" ? post({ kind: "text", text: data }) : relay.receive(data);
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
