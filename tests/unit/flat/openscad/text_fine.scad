text("%&@8$", size = 20, font = "Liberation Sans:style=Bold", $fn = 100);
