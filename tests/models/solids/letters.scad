linear_extrude(4) text("Q8&", size = 20, $fn = 8);
