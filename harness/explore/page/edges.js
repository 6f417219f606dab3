// Sorted lists of edges, as the program sends them: a0 b0 a1 b1 ..., a < b.

// Divides the edges of two lists: {shared, onlyFirst, onlySecond}.
export function compareEdges(first, second) {
  const shared = new Uint32Array(Math.min(first.length, second.length));
  const onlyFirst = new Uint32Array(first.length);
  const onlySecond = new Uint32Array(second.length);
  let [i, j, both, left, right] = [0, 0, 0, 0, 0];
  while (i < first.length || j < second.length) {
    let order = 0;
    if (j === second.length) order = -1;
    else if (i === first.length) order = 1;
    else order = first[i] - second[j] || first[i + 1] - second[j + 1];
    if (order === 0) {
      shared[both++] = first[i++];
      shared[both++] = first[i++];
      j += 2;
    } else if (order < 0) {
      onlyFirst[left++] = first[i++];
      onlyFirst[left++] = first[i++];
    } else {
      onlySecond[right++] = second[j++];
      onlySecond[right++] = second[j++];
    }
  }
  return { shared: shared.slice(0, both), onlyFirst: onlyFirst.slice(0, left), onlySecond: onlySecond.slice(0, right) };
}
