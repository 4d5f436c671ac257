// The machine of benchmarks/machine.py in XState, with the clocks, buffers and blends of machines.py. A line of JSON in, a line out ({ms}).
import { createInterface } from 'node:readline';
import { createActor, setup } from '../../static/node_modules/xstate/dist/xstate.esm.js';

const DT = 1 / 60;
const DURATIONS = { STAT: 2, STWK: 0.5, WALK: 1, CSTP: 0.5, JUMP: 0.66 };
const LOOPS = new Set(['STAT', 'WALK']);
const EVENTS = ['', 'FORWARD', 'STOP', 'JUMP'].map((type) => ({ type }));
const END = { type: 'END' };
const [BUFFER, BLEND] = [0.3, 0.2];

const machine = setup({ guards: { rested: ({ context }) => context.stamina > 10 } }).createMachine({
  context: { stamina: 20 },
  initial: 'STAT',
  states: {
    STAT: { on: { FORWARD: 'STWK' } },
    STWK: { on: { STOP: 'CSTP', END: 'WALK' } },
    WALK: { on: { STOP: 'CSTP', JUMP: { target: 'JUMP', guard: 'rested' } } },
    CSTP: { on: { FORWARD: 'STWK', END: 'STAT' } },
    JUMP: { on: { END: 'WALK' } },
  },
});

function bodyOf() {
  return { actor: createActor(machine).start(), time: 0, blend: 0, waiting: null, left: 0 };
}

function fire(body, event) {
  const before = body.actor.getSnapshot();
  body.actor.send(event);
  return body.actor.getSnapshot().value !== before.value;
}

function begin(body) {
  body.time = 0;
  body.blend = BLEND;
}

function tick(body, event) {
  const state = body.actor.getSnapshot().value;
  body.time += DT;
  if (body.blend > 0) body.blend -= DT;
  if (body.waiting && (body.left -= DT) <= 0) body.waiting = null;
  if (event.type) {
    if (fire(body, event)) begin(body);
    else [body.waiting, body.left] = [event, BUFFER];
  }
  if (body.time < DURATIONS[state]) return;
  if (LOOPS.has(state)) body.time -= DURATIONS[state];
  else if (fire(body, END)) {
    begin(body);
    if (body.waiting && fire(body, body.waiting)) [body.waiting, body.time] = [null, 0];
  }
}

const crowds = new Map();

// `events`: a string of digits for each tick, one digit for each body: 0 is none.
const jobs = {
  machines({ crowd, events }) {
    if (!crowds.has(crowd)) crowds.set(crowd, Array.from({ length: events[0].length }, bodyOf));
    const bodies = crowds.get(crowd);
    const rows = events.map((row) => Array.from(row, (digit) => EVENTS[digit]));
    const start = performance.now();
    for (const row of rows) row.forEach((event, index) => tick(bodies[index], event));
    return performance.now() - start;
  },
};

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  process.stdout.write(`${JSON.stringify({ ms: await jobs[asked.job](asked) })}\n`);
}
