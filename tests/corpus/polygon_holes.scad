// Paths: a hole, an island in it, a hole in the island; all in one direction, as people write them.
function ring(r, n, turn) = [for (i = [0:n - 1]) r * [cos(360 * i / n + turn), sin(360 * i / n + turn)]];
function run(start, n) = [for (i = [0:n - 1]) start + i];
linear_extrude(4)
  polygon(concat(ring(20, 7, 0), ring(15, 9, 10), ring(10, 4, 20), ring(5, 6, 0), [[15, 14], [19, 14], [17, 18]]),
          [run(0, 7), run(7, 9), run(16, 4), run(20, 6), run(26, 3)]);
