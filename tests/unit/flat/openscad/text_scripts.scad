text("Ωmega Жук é", font = "Liberation Mono", language = "el", script = "Grek");
