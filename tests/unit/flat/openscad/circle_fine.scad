circle(d = 25, $fa = 1, $fs = 0.3);
