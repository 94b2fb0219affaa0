// The landmarks out of map.ply: binary little-endian, any scalar properties.

const READERS = {
  float: [4, (view, at) => view.getFloat32(at, true)],
  double: [8, (view, at) => view.getFloat64(at, true)],
  int: [4, (view, at) => view.getInt32(at, true)],
  uint: [4, (view, at) => view.getUint32(at, true)],
  uchar: [1, (view, at) => view.getUint8(at)],
};
const MIN_CHROMA = 0.02;

function parseHeader(bytes) {
  const text = new TextDecoder("latin1").decode(bytes.subarray(0, 4096));
  const end = text.indexOf("end_header\n") + "end_header\n".length;
  const vertices = Number(/element vertex (\d+)/.exec(text)[1]);
  let offset = 0;
  const properties = {};
  for (const [, type, name] of text.slice(0, end).matchAll(/property (\w+) (\w+)/g)) {
    const [size, read] = READERS[type];
    properties[name] = { offset, read };
    offset += size;
  }
  return { end, vertices, properties, stride: offset };
}

/// A camera without colour gives every landmark a gray.
function hasColor(colors) {
  return colors.some((value, i) => Math.abs(value - colors[i - (i % 3)]) > MIN_CHROMA);
}

/// {count, positions: Float32Array of x y z, colors: Float32Array of sRGB from 0 to 1, or null}
export function parsePly(bytes) {
  const { end, vertices, properties, stride } = parseHeader(bytes);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const column = (names, scale) => {
    if (!names.every((name) => name in properties)) return null;
    const values = new Float32Array(names.length * vertices);
    for (let i = 0; i < values.length; ++i) {
      const { offset, read } = properties[names[i % names.length]];
      values[i] = scale * read(view, end + Math.floor(i / names.length) * stride + offset);
    }
    return values;
  };
  const colors = column(["red", "green", "blue"], 1 / 255);
  return { count: vertices, positions: column(["x", "y", "z"], 1), colors: colors && hasColor(colors) ? colors : null };
}
