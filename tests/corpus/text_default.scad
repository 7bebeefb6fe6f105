// No font is named; no text at all is nothing.
linear_extrude(2) text("default");
linear_extrude(9) text("");
linear_extrude(9) text(" ");
