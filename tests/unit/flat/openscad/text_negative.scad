text("minus", size = -5);
