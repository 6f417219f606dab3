// Asks the program: everything that is computed comes from there.
import { encodeFrame, FrameReader } from "./frames.js";

// What the program refuses or cannot do, in its words.
export class Refusal extends Error {}

async function* framesOf(response) {
  const reader = new FrameReader();
  const stream = response.body.getReader();
  for (;;) {
    const { done, value } = await stream.read();
    if (done) return;
    yield* reader.add(value);
  }
}

// Has a job done; `onFrame(json, bytes)` gets each frame of the answer but the last.
export async function ask(request, bytes, onFrame, signal) {
  let response;
  for (let attempt = 0; ; ++attempt) {
    response = await fetch("job", {
      method: "POST",
      headers: { "Content-Type": "application/octet-stream" },
      body: encodeFrame(request, bytes),
      signal,
    });
    if (response.status !== 503 || attempt === 4) break;
    await new Promise((resolve) => setTimeout(resolve, 300 * (attempt + 1)));
  }
  if (!response.ok) throw new Refusal((await response.text()).trim());
  for await (const { json, bytes: answer } of framesOf(response)) {
    if (json.type === "error") throw new Refusal(json.message);
    if (json.type === "end") return;
    onFrame(json, answer);
  }
  throw new Refusal("the program ended this job at its limits of time or memory");
}

export async function askForPoints(request, bytes) {
  let points = null;
  await ask(request, bytes, (json, answer) => {
    points = new Float64Array(answer);
  });
  return points;
}

export async function catalogue() {
  return (await fetch("catalogue.json")).json();
}

// The points of the file that `mwt explore` was called with: {name, points}, or null.
export async function givenPoints() {
  const bytes = new Uint8Array(await (await fetch("given")).arrayBuffer());
  if (bytes.length === 0) return null;
  const [frame] = new FrameReader().add(bytes);
  return { name: frame.json.name, points: new Float64Array(frame.bytes) };
}

// Leaves points with the program, for links; returns their name. Refusal: it keeps no such points.
export async function keepPoints(coordinates) {
  const response = await fetch("keep", { method: "POST", headers: { "Content-Type": "application/octet-stream" }, body: coordinates });
  if (!response.ok) throw new Refusal((await response.text()).trim());
  return response.text();
}

// Those that were left under a name.
export async function keptPoints(name) {
  const response = await fetch(`kept/${encodeURIComponent(name)}`);
  if (!response.ok) throw new Refusal("this link names points that this program does not have; open them again");
  return new Float64Array(await response.arrayBuffer());
}
