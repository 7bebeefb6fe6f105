circle(r = 10);
