// Sorted lists of edges, as the program sends them: a0 b0 a1 b1 ..., a < b.

// Divides the edges of two lists: {shared, onlyFirst, onlySecond}.
export function compareEdges(first, second) {
  const shared = [], onlyFirst = [], onlySecond = [];
  let i = 0, j = 0;
  while (i < first.length && j < second.length) {
    const order = first[i] - second[j] || first[i + 1] - second[j + 1];
    if (order === 0) {
      shared.push(first[i], first[i + 1]);
      i += 2;
      j += 2;
    } else if (order < 0) {
      onlyFirst.push(first[i], first[i + 1]);
      i += 2;
    } else {
      onlySecond.push(second[j], second[j + 1]);
      j += 2;
    }
  }
  for (; i < first.length; ++i) onlyFirst.push(first[i]);
  for (; j < second.length; ++j) onlySecond.push(second[j]);
  return { shared: Uint32Array.from(shared), onlyFirst: Uint32Array.from(onlyFirst), onlySecond: Uint32Array.from(onlySecond) };
}
