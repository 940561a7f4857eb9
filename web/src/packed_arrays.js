// SPDX-License-Identifier: Apache-2.0
// Reads what src/report/packed_arrays.cpp writes.

const TYPES = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, f32: Float32Array };

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** An array of `count` numbers whose bytes of equal weight stand together from `place` on. */
function fromPlanes(bytes, place, type, count) {
  const values = new TYPES[type](count);
  const size = values.BYTES_PER_ELEMENT;
  const target = new Uint8Array(values.buffer);
  for (let plane = 0; plane < size; ++plane)
    for (let i = 0; i < count; ++i) target[i * size + plane] = bytes[place + plane * count + i];
  return values;
}

/** `{about, arrays}` of the text in the page: arrays by name. */
export async function unpack(base64) {
  const bytes = await inflated(Uint8Array.from(atob(base64.trim()), (c) => c.charCodeAt(0)));
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const list = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const arrays = {};
  let place = 4 + length;
  for (const { name, type, count, differences } of list.arrays) {
    const values = fromPlanes(bytes, place, type, count);
    if (differences) for (let i = 1; i < count; ++i) values[i] += values[i - 1];
    arrays[name] = values;
    place += count * values.BYTES_PER_ELEMENT;
  }
  return { about: list.about, arrays };
}
