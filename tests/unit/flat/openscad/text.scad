text("Hello, World! 0123");
