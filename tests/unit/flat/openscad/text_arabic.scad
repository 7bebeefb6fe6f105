text("مرحبا", font = "DejaVu Sans", size = 12, halign = "center", $fn = 32);
