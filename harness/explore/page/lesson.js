// Ten guided steps through the source report's worked examples and claims. Each shows a view and says what to look for;
// the numbers come from the program.

const element = (id) => document.getElementById(id);

export const STEPS = [
  {
    title: "A triangulation",
    view: "family=report_example&first=delaunay&second=none",
    text: "These are the source report’s ten points. A triangulation divides their hull into triangles. Every one of n points with h on the hull has 2n − h − 2 triangles (claim C3): 12 here. Its weight is the sum of its edges’ lengths. Drag a point: the weight changes, the number of triangles does only when the hull does.",
  },
  {
    title: "Greedy, the worked example",
    view: "family=report_example&first=greedy_naive&second=optimum",
    text: "Greedy takes the shortest edge that crosses none taken before, again and again. The source report finds a weight of 70.9586 (C1). The program proves that this is the optimum: α, the weight divided by that of the lightest triangulation, is 1. Play it.",
  },
  {
    title: "Hull and insertion, the worked example",
    view: "family=report_example&first=hull_insertion&second=optimum",
    text: "Now an optimal triangulation of the hull, into which the other points are inserted one by one, each by splitting the triangle that holds it. The source report finds 86.5447479007 (C2), and the program agrees. Nothing is ever repaired: orange edges are not in the optimum.",
  },
  {
    title: "Local search",
    view: "family=local_search_figure&first=flip_naive&first.start=sweep&second=optimum",
    text: "A flip replaces the diagonal of a convex quadrilateral by the other one if that is shorter. These are the points of the source report’s run of local search (C9), here from another start. The report adds up the triangles’ perimeters and ends at 10.7929; the table adds up edges, each once, and names the perimeters’ sum when you point at the weight. Play the flips; each states what it gains.",
  },
  {
    title: "Greedy on random points",
    view: "family=uniform&n=400&seed=1&first=greedy&second=optimum",
    text: "The source report states that greedy’s α is often 1.1 to 1.5 (C4). On random points it is far smaller: look at α, and take other seeds and larger n.",
  },
  {
    title: "Greedy at its worst",
    view: "family=greedy_corridor&n=200&first=greedy&second=optimum&stretch",
    text: "Points that are built against greedy: two facing chains of points, nearly flat. Its short first edges force long ones later. α grows like the square root of n, no faster: C5, that it is at most O(n), holds. Double n and compare.",
  },
  {
    title: "Insertion’s trap",
    view: "family=insertion_trap&n=120&first=hull_insertion&second=optimum",
    text: "The source report claims that hull insertion is never worse than O(log n) times the optimum (C6). On this family its α grows in proportion to n: double n and compare.",
  },
  {
    title: "The hull is no lower bound",
    view: "family=hull_bound_counterexample&first=exact&second=none",
    text: "The source report argues that the hull’s own optimal triangulation is never heavier than the optimum of all points (C7). Here it is: delete the point in the middle, and the optimum becomes heavier, though there is less to connect. Undo brings the point back.",
  },
  {
    title: "Delaunay and the quadtree",
    view: "family=delaunay_arc&n=60&first=delaunay&second=quadtree",
    text: "Both are good on random points: the quadtree’s α averages 1.03 there (C13). On this arc with one point near its centre, both join nearly all points of the arc to that one. Choose uniform points to see the difference.",
  },
  {
    title: "How an optimum is proved",
    view: "family=uniform&n=100&seed=1&first=exact&second=none",
    text: "The problem is NP-hard (C14), yet most edges are easy. Play it: candidates pass the diamond test, the LMT-skeleton deletes most of them, certain edges divide the rest into faces, and a program for each face finishes. Point at an edge to see why it left or stayed.",
  },
];

export class Lesson {
  #position = -1;
  #show;

  // `show(view)` shows a view, as of a link.
  constructor(show) {
    this.#show = show;
    element("lesson").addEventListener("click", () => this.go(0));
    element("lesson-next").addEventListener("click", () => this.go(this.#position + 1));
    element("lesson-back").addEventListener("click", () => this.go(this.#position - 1));
    element("lesson-close").addEventListener("click", () => {
      element("lesson-box").hidden = true;
      element("lesson").focus();
    });
  }

  go(position) {
    this.#position = position;
    const { title, text, view } = STEPS[position];
    element("lesson-box").hidden = false;
    element("lesson-title").textContent = `${position + 1} of ${STEPS.length}: ${title}`;
    element("lesson-text").textContent = text;
    element("lesson-back").disabled = position === 0;
    element("lesson-next").disabled = position === STEPS.length - 1;
    element("lesson-title").focus();
    this.#show(`${view}&time_limit=10`);
  }
}
