/* A rival in C: points in order of x, each joined to the hull of those before it (Graham's scan from the left). Reads
   "x y" lines from standard input and prints "a,b,c" lines. harness/run/COMMANDS.md is the contract. Not exact. */
#include <stdio.h>
#include <stdlib.h>

typedef struct { double x, y; int id; } Point;

static int by_x_then_y(const void *a, const void *b) {
  const Point *p = a, *q = b;
  if (p->x != q->x) return p->x < q->x ? -1 : 1;
  return (p->y > q->y) - (p->y < q->y);
}

static double turn(const Point *a, const Point *b, const Point *c) {
  return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

/* Joins p to the chain (lower: sign = 1, upper: sign = -1), from its end as far as p sees it. */
static void join(Point **chain, int *size, Point *p, int sign) {
  while (*size > 1 && sign * turn(chain[*size - 2], chain[*size - 1], p) < 0) {
    Point *a = chain[*size - 2], *b = chain[*size - 1];
    if (sign > 0) printf("%d,%d,%d\n", a->id, p->id, b->id); else printf("%d,%d,%d\n", a->id, b->id, p->id);
    --*size;
  }
  chain[(*size)++] = p;
}

int main(void) {
  size_t capacity = 1024, n = 0;
  Point *points = malloc(capacity * sizeof *points);
  while (points && scanf("%lf %lf", &points[n].x, &points[n].y) == 2) {
    points[n].id = (int)n;
    if (++n == capacity) points = realloc(points, (capacity *= 2) * sizeof *points);
  }
  Point **lower = malloc((n + 1) * sizeof *lower), **upper = malloc((n + 1) * sizeof *upper);
  if (!points || !lower || !upper) {
    fputs("Out of memory\n", stderr);
    return 1;
  }
  qsort(points, n, sizeof *points, by_x_then_y);
  int lower_size = 0, upper_size = 0;
  for (size_t i = 0; i < n; ++i) {
    join(lower, &lower_size, &points[i], 1);
    join(upper, &upper_size, &points[i], -1);
  }
  free(points); free(lower); free(upper);
  return 0;
}
