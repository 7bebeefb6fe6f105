text("مرحبا", font = "DejaVu Sans", direction = "ltr");
