offset(r = 7.5) square([20, 10]);
