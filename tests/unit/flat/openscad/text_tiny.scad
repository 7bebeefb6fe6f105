text("tiny", size = 0.01, $fa = 1, $fs = 0.001);
