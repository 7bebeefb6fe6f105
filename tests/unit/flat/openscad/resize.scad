resize([12, 5]) circle(r = 3, $fn = 16);
