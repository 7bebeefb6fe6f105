text("aбγ — “x”");
