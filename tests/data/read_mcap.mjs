// Reads an MCAP file with the package of the format's authors, and prints what is in it as JSON.
//
//   node read_mcap.mjs PANEL_FOLDER FILE indexed|stream
//
// indexed: by the summary at the end; stream: from the beginning, as far as the records are whole.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, file, way] = process.argv.slice(2);
const { McapIndexedReader, McapStreamReader } = createRequire(folder + "/package.json")("@mcap/core");
const bytes = readFileSync(file);
const topics = {};
let records = 0;

function add(schema, channel, message) {
  const topic = (topics[channel.topic] ??= {
    schema: schema?.name, encoding: channel.messageEncoding, schemaEncoding: schema?.encoding, count: 0, firstNs: "",
    first: null, schemaText: JSON.parse(new TextDecoder().decode(schema.data)),
  });
  const json = JSON.parse(new TextDecoder().decode(message.data));
  if (topic.count++ === 0) {
    topic.first = json;
    topic.firstNs = String(message.logTime);
  }
  topic.last = json;
  topic.lastNs = String(message.logTime);
}

async function readIndexed() {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
  };
  const reader = await McapIndexedReader.Initialize({ readable });
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    add(reader.schemasById.get(channel.schemaId), channel, message);
    ++records;
  }
  return {
    chunks: reader.chunkIndexes.length, messages: String(reader.statistics.messageCount),
    startNs: String(reader.statistics.messageStartTime), endNs: String(reader.statistics.messageEndTime),
    offsets: reader.summaryOffsetsByOpcode.size, library: reader.header.library,
  };
}

function readStream() {
  const reader = new McapStreamReader({ validateCrcs: true });
  const schemas = new Map(), channels = new Map();
  let hasEnd = false, why = "";
  reader.append(bytes);
  try {
    for (let record; (record = reader.nextRecord()); ) {
      if (record.type === "Schema") schemas.set(record.id, record);
      if (record.type === "Channel") channels.set(record.id, record);
      if (record.type === "Footer") hasEnd = true;
      if (record.type !== "Message") continue;
      const channel = channels.get(record.channelId);
      add(schemas.get(channel.schemaId), channel, record);
      ++records;
    }
  } catch (error) {
    why = String(error);
  }
  return { hasEnd, why };
}

const about = way === "indexed" ? await readIndexed() : readStream();
console.log(JSON.stringify({ ...about, records, topics }));
