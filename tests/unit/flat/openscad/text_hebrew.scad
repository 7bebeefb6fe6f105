text("שלום עולם", font = "DejaVu Sans");
