// node session_test.mjs SOURCE_DIR BIN_DIR: plays the real recording with the real programs, then reads the session as an
// outsider would, with npm's @mcap/core and nothing of ours: every message must decode by the schema in the file.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, rm, stat } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import { assertPublished, publishedTypes } from "../npm/foxglove_types.mjs";
import { fieldOf, pathsOfLayout } from "../npm/lichtblick_layout.mjs";
import { decoders, readIndexed, typesOf } from "../npm/mcap_file.mjs";

const [sourceDir, binDir] = process.argv.slice(2);
const folder = await mkdtemp(path.join(tmpdir(), "telepalp-session-"));
const byTopic = new Map();
let begin_ns; // of the session

before(async () => {
  const args = ["--headless", "--seconds", "5", "--source", "oni:deploy/demo_data/oni/3dj_test.oni", "--out", folder];
  await promisify(execFile)("deploy/demo", args, { cwd: sourceDir, env: { ...process.env, TELEPALP_BIN: binDir } });
  const { reader, messages } = await readIndexed(path.join(folder, "session.mcap"));
  const decode = decoders(reader.schemasById);
  begin_ns = reader.statistics.messageStartTime;
  for (const message of messages) {
    const channel = reader.channelsById.get(message.channelId);
    if (!byTopic.has(channel.topic)) byTopic.set(channel.topic, []);
    byTopic.get(channel.topic).push(decode.get(channel.schemaId)(message.data));
  }
});
after(() => rm(folder, { recursive: true }));

const IN_CONTACT = [1, 5, 6, 7]; // phases of msg.StationState
const norm = ({ x, y, z }) => Math.hypot(x, y, z);

test("every topic of the system is in the session", () => {
  const wanted = ["/camera/color", "/camera/depth", "/camera/info", "/camera/status", "/clock", "/server/stats"];
  const station = ["state", "ticks", "surface", "events", "stats"].map((name) => `/station/${name}`);
  for (const topic of [...wanted, ...station]) assert.ok(byTopic.get(topic)?.length > 0, topic);
});

test("camera frames are images with the time of their capture", () => {
  for (const image of byTopic.get("/camera/depth")) {
    assert.equal(image.width, 640);
    assert.equal(image.height, 480);
    assert.ok(image.data.length > 1000);
    assert.ok(BigInt(image.captured_ns.toString()) <= BigInt(image.encoded_ns.toString()));
  }
  const jpeg = byTopic.get("/camera/color")[0].data;
  assert.deepEqual([...jpeg.subarray(0, 3)], [0xff, 0xd8, 0xff]);
});

test("every derived message carries the capture time that it came from", () => {
  const captured = new Set(byTopic.get("/camera/depth").map((image) => image.captured_ns.toString()));
  const first = byTopic.get("/station/surface")[0];
  assert.ok(captured.has(first.captured_ns.toString()), "the surface's capture is that of a recorded depth image");
  for (const state of byTopic.get("/station/state")) assert.notEqual(state.surface_captured_ns.toString(), "0");
});

test("every force is finite and within the device's 10 N", () => {
  const forces = byTopic.get("/station/state").map((state) => norm(state.force_N));
  for (const force of forces) assert.ok(Number.isFinite(force) && force <= 10, String(force));
  for (const batch of byTopic.get("/station/ticks"))
    batch.force_x.forEach((x, i) => assert.ok(norm({ x, y: batch.force_y[i], z: batch.force_z[i] }) <= 10));
});

test("no tick is missing from the session but those that missed their deadline", () => {
  let next = 0;
  for (const batch of byTopic.get("/station/ticks")) {
    assert.equal(Number(batch.first_tick), next);
    next += batch.phase.length;
  }
  assert.ok(next >= 9000, `${next} ticks in 5 s`);
});

test("telepalp-export writes the types that Foxglove publishes, with the force as an arrow", async () => {
  const touching = byTopic.get("/station/state").filter(({ phase }) => IN_CONTACT.includes(phase)); // alone have an arrow
  const strongest = touching.reduce((a, b) => (norm(b.force_N) > norm(a.force_N) ? b : a));
  const at_s = Number(BigInt(strongest.stamp_ns.toString()) - begin_ns) * 1e-9;
  const [part, file] = ["part.mcap", "view.mcap"].map((name) => path.join(folder, name));
  const run = (program, ...args) => promisify(execFile)(path.join(binDir, program), args);
  const times = ["--from", `${Math.max(0, at_s - 0.1)}s`, "--to", `${at_s + 0.1}s`];
  await run("telepalp-record", "cut", path.join(folder, "session.mcap"), ...times, "--out", part);
  const { stderr } = await run("telepalp-export", part, "--foxglove", file);
  const announced_MB = Number(/view.mcap will have about ([0-9.]+) MB/.exec(stderr)?.[1]);
  const written_MB = (await stat(file)).size / 1e6;
  assert.ok(Math.abs(announced_MB / written_MB - 1) < 0.2, `${announced_MB} MB announced, ${written_MB} MB written`);
  const { reader, messages } = await readIndexed(file);
  const published = publishedTypes();
  const decode = decoders(reader.schemasById);
  for (const type of typesOf(reader.schemasById).values())
    if (type.fullName.startsWith(".foxglove.")) assertPublished(type, published.lookupType(type.fullName.slice(1)));
  const shown = (topic) =>
    messages.flatMap(({ channelId, data }) => {
      const channel = reader.channelsById.get(channelId);
      return channel.topic === topic ? [decode.get(channel.schemaId)(data)] : [];
    });
  const arrows = shown("/station/scene").flatMap(({ entities }) => entities).flatMap((entity) => entity.arrows);
  const longest_m = Math.max(...arrows.map((arrow) => arrow.shaft_length + arrow.head_length));
  assert.ok(Math.abs(longest_m - 0.02 * norm(strongest.force_N)) < 1e-6, `${longest_m} m for ${norm(strongest.force_N)} N`);
  const [image] = shown("/camera/depth/image");
  assert.equal(image.encoding, "16UC1");
  assert.equal(image.data.length, image.step * image.height);
  const clouds = shown("/camera/points");  // the colour of the first image may have come before the recorder did
  const cloud = clouds.at(-1);
  for (const { fields } of clouds.slice(1))
    assert.deepEqual(fields.map(({ name }) => name), ["x", "y", "z", "red", "green", "blue", "alpha"]);
  assert.equal(cloud.data.length % cloud.point_stride, 0);
  const frames = shown("/transforms").flatMap(({ transforms }) => transforms).map((one) => one.child_frame_id);
  assert.ok(frames.includes("device") && frames.includes("proxy"), [...new Set(frames)].join());
  assert.ok(shown("/camera/color").length > 0);
  const strengths = shown("/station/state").map((state) => norm(state.force_N));
  assert.ok(Math.abs(Math.max(...strengths) - norm(strongest.force_N)) < 1e-9, "the recorded numbers can be plotted");
});

test("the layout for Lichtblick finds its topics in an exported file, and what it shows of them", async () => {
  const file = path.join(folder, "layout.mcap");
  const session = path.join(folder, "session.mcap");
  await promisify(execFile)(path.join(binDir, "telepalp-export"), [session, "--foxglove", file, "--rate", "2"]);
  const { reader } = await readIndexed(file);
  const types = typesOf(reader.schemasById);
  const channels = [...reader.channelsById.values()];
  for (const wanted of pathsOfLayout()) {
    const [topic, ...fields] = wanted.split(".");
    if (topic === "/station/inside/scene") continue; // the scene of this session has no layer
    const channel = channels.find((one) => one.topic === topic);
    assert.ok(channel, `${topic} is in the file`);
    const leaf = fieldOf(types.get(channel.schemaId), fields);
    if (wanted === "/station/phase.value") assert.equal(leaf, "string", "the panel of states shows the phase in words");
    else if (fields.length > 0) assert.ok(leaf === "double" || leaf.values !== undefined, `${wanted} is a number`);
  }
});
