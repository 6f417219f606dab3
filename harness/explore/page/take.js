// What can be taken away: commands, files.

const quoted = (text) => (/^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

const parameterOptions = (parameters) =>
  Object.entries(parameters)
    .map(([name, value]) => ` --param ${quoted(`${name}=${value}`)}`)
    .join("");

// The commands that repeat what is shown.
export function commandsOf({ points, algorithms }) {
  const { source } = points;
  let file = "points.csv";
  const lines = [];
  if (points.isEdited || !(source.family || source.given)) {
    lines.push("# with points.csv, saved from the page");
  } else if (source.family) {
    const { family, n, seed, parameters } = source.family;
    lines.push(`mwt generate ${quoted(family)} --n ${quoted(n)} --seed ${quoted(seed)}${parameterOptions(parameters)} -o points.csv`);
  } else {
    file = source.given;
  }
  const optimum = algorithms.optimum || algorithms.second.name === "optimum" ? " --with-optimum --no-cache" : "";
  const slots = [algorithms.first, algorithms.second].filter(({ name }) => name !== "none" && name !== "optimum");
  for (const [position, { name, parameters }] of slots.entries()) {
    const triangles = position === 0 ? "first.csv" : "second.csv";
    lines.push(
      `mwt solve ${quoted(file)} --algorithm ${name}${parameterOptions(parameters)} --seed ${quoted(algorithms.seed)}` +
        ` --time-limit ${quoted(algorithms.timeLimit)}${optimum} --triangles ${triangles}`,
    );
  }
  return lines.join("\n");
}

export function pointsText(coordinates) {
  const lines = ["x,y"];
  for (let i = 0; i < coordinates.length; i += 2) lines.push(`${coordinates[i]},${coordinates[i + 1]}`);
  return lines.join("\n") + "\n";
}

export function trianglesText(triangles) {
  const lines = [];
  for (let i = 0; i < triangles.length; i += 3) lines.push(`${triangles[i]},${triangles[i + 1]},${triangles[i + 2]}`);
  return lines.join("\n") + "\n";
}

export const MOST_IN_SVG = 100000; // points

// The whole set, whatever part of it is seen.
export function svgText(coordinates, layers) {
  const size = 800;
  const margin = 20;
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < coordinates.length; i += 2) {
    left = Math.min(left, coordinates[i]);
    right = Math.max(right, coordinates[i]);
    bottom = Math.min(bottom, coordinates[i + 1]);
    top = Math.max(top, coordinates[i + 1]);
  }
  const scale = (size - 2 * margin) / (Math.max(right - left, top - bottom) || 1);
  const place = (point) => [
    (margin + (coordinates[2 * point] - left) * scale).toFixed(2),
    (margin + (top - coordinates[2 * point + 1]) * scale).toFixed(2),
  ];
  const height = (2 * margin + (top - bottom) * scale).toFixed(2);
  const width = (2 * margin + (right - left) * scale).toFixed(2);
  const parts = [`<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">`];
  parts.push('<rect width="100%" height="100%" fill="#ffffff"/>');
  const print = { "--shared": "#6b6f75", "--first": "#b84a00", "--second": "#0072b2" };
  for (const layer of layers) {
    let path = "";
    for (let i = 0; i < layer.edges.length; i += 2) path += `M${place(layer.edges[i])}L${place(layer.edges[i + 1])}`;
    const dashes = layer.dashed ? ' stroke-dasharray="6 4"' : "";
    parts.push(`<path d="${path}" fill="none" stroke="${print[layer.colour]}" stroke-width="${layer.width}"${dashes}/>`);
  }
  parts.push('<g fill="#1b1c1e">');
  const n = coordinates.length / 2;
  const radius = Math.max(0.5, Math.min(3.5, 60 / Math.sqrt(n || 1)));
  for (let i = 0; i < n; ++i) {
    const [x, y] = place(i);
    parts.push(`<circle cx="${x}" cy="${y}" r="${radius.toFixed(2)}"/>`);
  }
  parts.push("</g></svg>\n");
  return parts.join("\n");
}

export function save(name, content, type) {
  const blob = content instanceof Blob ? content : new Blob([content], { type });
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
